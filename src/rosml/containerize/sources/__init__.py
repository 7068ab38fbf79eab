"""Upstream sources: the repositories that `.repos` files name, fetched at exact commits."""
