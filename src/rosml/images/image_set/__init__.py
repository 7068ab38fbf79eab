"""The image set: every image and part that the rules of the matrix allow, with its facts and its locks; tells why a
combination is missing, as the rules say. Uses matrix and base; touches neither network nor processes."""
