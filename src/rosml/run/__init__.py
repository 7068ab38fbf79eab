"""An image is started, or a container entered: from what a person writes, and what the image and the engine are, to the engine's
command."""
