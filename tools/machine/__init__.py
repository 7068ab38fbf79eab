"""Sets a machine up for this project: tools, local registry, builder. Standard library only, Python >= 3.9."""
