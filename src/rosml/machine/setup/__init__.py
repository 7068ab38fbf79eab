"""Setup of this machine: programs at pinned versions, the local registry, the builder."""
