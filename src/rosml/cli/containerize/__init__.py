"""Commands that build images of people's own packages."""
