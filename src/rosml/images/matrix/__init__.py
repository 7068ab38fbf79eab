"""`matrix.yaml`: reads it with the place of each value, validates it, and makes one typed model. Also names, and the rules about
which combinations exist and why others do not. Uses base; touches neither network nor processes."""
