"""Commands that save images for machines without a registry, and load them there."""
