"""Base images for a machine that does not reach Docker Hub: Debian's, made from its packages, and what parts for other Pythons are
built on. Set-up names `python tools/offline` as the command that is asked for them; src/rosml/images/builds/base_images.py says how.
"""
