"""`matrix.yaml`: read with the place of each value, validated, and as one typed model; the rules and names that
follow from its facts. Uses base; touches neither network nor processes."""
