"""Locks, resolved from the requirements of the matrix, and digests of base images. Uses image_set and below."""
