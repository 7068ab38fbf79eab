"""The inputs in CI: those of the table with other defaults, and those that only CI has."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from rosml.base.errors import RosmlError
from rosml.containerize import inputs as app_inputs
from rosml.containerize.inputs import Input


@dataclass(frozen=True)
class Setting:
    """An input in CI."""

    input: Input
    github: str = ""  # its default, in the forge's words; that of the table if empty
    gitlab: str = ""
    server: tuple[str, str] | None = (
        None  # if its default is the job's token: the input that names a server, and the only one that gets it
    )

    @property
    def token(self) -> str:
        """GitHub's expression for the default: the job's token, which goes to no other server."""
        return f"inputs.{self.server[0]} == '{self.server[1]}' && github.token || ''" if self.server else ""


OWN = (
    Setting(Input("registry", "registry to log in to"), "ghcr.io", "$CI_REGISTRY"),
    Setting(Input("registry-user", "user there"), "${{ github.actor }}", "$CI_REGISTRY_USER"),
    Setting(
        Input("registry-password", "password or token there"), "", "$CI_REGISTRY_PASSWORD", ("registry", "ghcr.io")
    ),
    Setting(Input("build-context", "folder of the repository with your packages"), ".", "."),
    Setting(
        Input("enable-singlearch-push", "give tags with the platform, such as latest-arm64, and no others"), "false"
    ),
    Setting(Input("enable-checkout", "check your repository out"), "true"),
    Setting(Input("enable-checkout-lfs", "with files of Git LFS"), "true"),
    Setting(Input("enable-checkout-submodules", "with submodules: false, true or recursive"), "recursive"),
)

_DEFAULTS: dict[str, tuple[Any, ...]] = {
    "target": ("run", "run"),
    "platform": ("", "amd64"),
    "enable-slim": ("true", "true"),
    "image-name": ("ghcr.io/${{ github.repository }}", "$CI_REGISTRY_IMAGE"),
    "push": ("true", "true"),
    "git-https-server": ("github.com", "$CI_SERVER_HOST"),
    "git-https-user": ("${{ github.actor }}", "gitlab-ci-token"),
    "git-https-password": ("", "$CI_JOB_TOKEN", ("git-https-server", "github.com")),
}
"""Inputs of the table with a better default in CI: the fields of their settings."""

SETTINGS = (*(Setting(item, *_DEFAULTS.get(item.name, ())) for item in app_inputs.TABLE), *OWN)

SECRET = (*app_inputs.SECRET, "registry-password")


def inputs_of(environment: Mapping[str, str]) -> dict[str, str]:
    """The inputs that somebody gives, by name. If a forge has inputs beside variables, it passes both: `INPUT_TARGET` counts before
    `TARGET`, and `DEFAULT_TARGET` after it."""
    texts = {}
    for item in (setting.input for setting in SETTINGS):
        names = (f"INPUT_{item.variable}", item.variable, f"DEFAULT_{item.variable}")
        if text := next(filter(None, map(environment.get, names)), ""):
            texts[item.name] = text
    return texts


def flag(name: str, inputs: Mapping[str, str]) -> bool:
    """Whether an input that only CI has is true."""
    value = inputs.get(name, "false").lower()
    if value not in ("true", "false"):
        raise RosmlError(f"{name} is true or false, not {value!r}", f"check {name}", exit_code=2)
    return value == "true"
