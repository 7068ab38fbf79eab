"""The dossier of an image: what an image of a registry has, for people and authorities, from what is attached to it. No layer is read."""
