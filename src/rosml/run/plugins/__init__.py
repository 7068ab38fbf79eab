"""rosml's own plugins of `rosml run`, and the command line that they and others make."""
