"""Starting an image or entering a container: from the command line and the facts about image and engine to the engine's command."""
