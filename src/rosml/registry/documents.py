"""Models of what registries send, by the OCI specifications, with the fields that this program reads."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import BeforeValidator, ConfigDict, Field

from rosml.base.shapes import Shape

DIGEST = r"sha256:[0-9a-f]{64}|sha512:[0-9a-f]{128}"
TAG = r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,127}"

MEDIA_TYPE = r"[A-Za-z0-9][A-Za-z0-9!#$&^_.+-]{0,126}/[A-Za-z0-9][A-Za-z0-9!#$&^_.+-]{0,126}"

Digest = Annotated[str, Field(pattern=rf"^(?:{DIGEST})$")]
Tag = Annotated[str, Field(pattern=rf"^(?:{TAG})$")]
MediaType = Annotated[str, Field(pattern=rf"^{MEDIA_TYPE}$")]
Size = Annotated[int, Field(ge=0, lt=1 << 62)]


def _texts(value: Any) -> dict[str, str]:
    """Annotations as text. Anybody may write anything there, and the image is still good."""
    return {str(name): str(text) for name, text in value.items()} if isinstance(value, Mapping) else {}


Annotations = Annotated[dict[str, str], BeforeValidator(_texts)]


class _Shape(Shape):
    model_config = ConfigDict(strict=True, frozen=True)


class Platform(_Shape):
    os: str | None = None
    architecture: str | None = None
    variant: str | None = None


class Descriptor(_Shape):
    """A pointer to a manifest or a blob. `size` is in bytes."""

    mediaType: str
    digest: Digest
    size: Size
    platform: Platform | None = None
    artifactType: str | None = None
    annotations: Annotations = {}


class Image(_Shape):
    """The manifest of an image for one platform, or of an artifact."""

    schemaVersion: int
    mediaType: MediaType | None = None
    artifactType: str | None = None
    config: Descriptor | None = None
    layers: list[Descriptor] = []
    manifests: None = None
    annotations: Annotations = {}
    subject: Descriptor | None = None


class Index(_Shape):
    """An index of images, one for each platform; or of the artifacts attached to a manifest."""

    schemaVersion: int
    mediaType: MediaType | None = None
    artifactType: str | None = None
    config: None = None
    layers: None = None
    manifests: list[Descriptor] | None
    annotations: Annotations = {}
    subject: Descriptor | None = None


class Referrers(_Shape):
    manifests: list[Descriptor] | None


class Tags(_Shape):
    tags: list[Tag] | None


class Settings(_Shape):
    """How a container starts. Docker has the same names."""

    Env: list[str] | None = None
    Labels: dict[str, str] | None = None
    User: str | None = None
    Entrypoint: list[str] | None = None
    Cmd: list[str] | None = None
    Shell: list[str] | None = None
    WorkingDir: str | None = None
    OnBuild: list[str] | None = None


class RootFs(_Shape):
    """`diff_ids` are digests of layers before they were compressed, lowest first."""

    diff_ids: list[Digest] | None = None


class Config(_Shape):
    os: str | None = None
    architecture: str | None = None
    variant: str | None = None
    created: str | None = None
    config: Settings | None = None
    rootfs: RootFs | None = None
    history: list[dict[str, Any]] | None = None


class Error(_Shape):
    code: str = ""
    message: str | None = None


class Errors(_Shape):
    errors: list[Error]


class Token(_Shape):
    token: str | None = None
    access_token: str | None = None
    expires_in: Any = None
