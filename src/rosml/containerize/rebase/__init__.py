"""Puts apps on other base images in a registry: `image.py` computes the image, `checks.py` says what speaks against it, `rebaser.py` works
in a registry and pulls no layer."""
