"""Writes a call of `rosml run` as a file from which other programs start it."""
