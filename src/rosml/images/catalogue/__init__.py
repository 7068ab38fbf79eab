"""The catalogue: what a registry has published, as a page for people and as JSON. Uses records and below."""
