"""A node in Python."""
