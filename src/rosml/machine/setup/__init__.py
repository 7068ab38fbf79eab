"""What makes this machine ready: programs at pinned versions, the local registry, the builder."""
