"""Joins an image and parts: `layers.py` is a pure function from manifests to a manifest, `joiner.py` works in a
registry and pulls no layer. Uses records, registry and below."""
