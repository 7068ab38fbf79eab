"""Locks: resolved from what the matrix asks for, and digests of base images. Uses images and below."""
