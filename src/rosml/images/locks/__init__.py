"""Locks: resolved from what the matrix asks for, and digests of base images. Uses image_set and below."""
