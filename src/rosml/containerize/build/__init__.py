"""Builds an app: its packages once, as a part, and the images that join the part and a base image."""
