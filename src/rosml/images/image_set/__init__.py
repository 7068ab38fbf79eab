"""The image set: every image and part that the rules of the matrix allow, with its facts and locks; also explains why a
combination is missing. Uses matrix and base; touches neither network nor processes."""
