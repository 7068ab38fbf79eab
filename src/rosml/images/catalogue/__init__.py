"""What is published, read from a registry, as a page for people and as JSON. Uses records and below."""
