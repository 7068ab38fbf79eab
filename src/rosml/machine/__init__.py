"""What this machine has: the local registry and the builder, a call of buildx with its progress, base images, disk, an earlier revision.
Uses registry, bake and below."""
