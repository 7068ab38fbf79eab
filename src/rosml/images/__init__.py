"""Images: from `matrix.yaml` to tags in a registry. Its packages stand in the order in which docs/architecture.md has them."""
