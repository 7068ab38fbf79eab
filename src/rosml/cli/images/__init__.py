"""Commands that make images, say what there is, and publish it."""
