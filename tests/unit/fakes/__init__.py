"""Local replacements for programs, registries and machines, and builders of what the unit tests share."""
