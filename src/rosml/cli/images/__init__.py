"""Commands that build, list and publish images."""
