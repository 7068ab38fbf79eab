"""Puts apps on other base images in a registry: `compatibility.py` decides whether an app may move, `image.py` computes its image,
`rebaser.py` plans and moves one app, `fleet.py` many."""
