"""Base images for a machine that does not reach Docker Hub: `python tools/offline`, the command in services.json."""
