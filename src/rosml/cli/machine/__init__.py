"""Commands that make this machine ready."""
