"""Commands that start containers, and enter them."""
