"""Says which images have a vulnerability or a package, by their SBOMs. Uses rebase, and what is below."""
