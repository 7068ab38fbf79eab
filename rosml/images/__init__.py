"""The image set: every image and part that the matrix allows, with its facts, its locks, and why a combination is
missing. Uses matrix and base; touches neither network nor processes."""
