"""Joins an image and parts: `layers.py` computes a manifest, `joiner.py` works in a registry. Uses records and below."""
