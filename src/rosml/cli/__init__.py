"""What people call: commands, tables and reports. Only this package prints."""

from __future__ import annotations

SECTIONS = {
    "Run images": {"run": "run.run", "attach": "run.attach"},
    "Build images of your own packages": {
        "init": "containerize.init",
        "containerize": "containerize.containerize",
        "dev": "containerize.dev",
        "rebase": "containerize.rebase",
        "affected": "containerize.affected",
        "save": "delivery.save",
        "load": "delivery.load",
        "delta": "delivery.delta",
        "ci": "containerize.ci",
    },
    "Find and build base images": {
        "list": "images.listing",
        "explain": "images.explain",
        "image": "images.image",
        "part": "images.part",
        "env": "images.env",
        "join": "images.join",
        "dossier": "images.dossier",
    },
    "Publish base images": {
        "plan": "images.plan",
        "publish": "images.publish",
        "status": "images.status",
        "catalogue": "images.catalogue",
        "locks": "images.locks",
        "generate": "images.generate",
        "diff": "images.diff",
    },
    "Set up this machine": {"setup": "machine.setup", "doctor": "machine.doctor"},
}
"""The sections of --help: each command, and its module in this package, which has a `main`."""

MODULES = {name: module for section in SECTIONS.values() for name, module in section.items()}
