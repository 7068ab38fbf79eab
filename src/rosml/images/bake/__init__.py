"""The bake file: targets as data, the file that is written from them, and the inputs digest, which decides an image's
content. Uses image_set and below; touches neither network nor processes."""
