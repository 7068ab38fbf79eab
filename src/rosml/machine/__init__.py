"""This machine: its set-up, the builder and the local registry, a call of buildx with its progress, git. Uses registry and base."""
