"""An image is started: from what a person writes, what the image promises and which engine there is, to the engine's command."""
