"""`matrix.yaml`: read with the place of each value, validated, and as one typed model; names, and the rules that
say which combinations its facts allow and why others are missing. Uses base; touches neither network nor processes."""
