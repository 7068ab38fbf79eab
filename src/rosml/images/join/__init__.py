"""Joins parts and an image: first as a pure function from manifests to a manifest, then in a registry, where nothing
is pulled. Uses records, registry and below."""
