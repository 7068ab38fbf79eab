"""The bake file: targets as data, the file that is written from them, and the inputs digest that decides what an
image holds. Uses images and below; touches neither network nor processes."""
