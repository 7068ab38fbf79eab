"""This machine: setup, the builder and the local registry, calls of buildx with progress, git. Uses registry and base."""
