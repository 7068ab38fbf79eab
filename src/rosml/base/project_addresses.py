"""The project's public addresses, for help and for sets of images. They are in pyproject.toml, `[project.urls]`; a wheel has them in its metadata."""

from __future__ import annotations

from rosml import IN_CHECKOUT, ROOT


def addresses() -> dict[str, str]:
    """The project's addresses by name, such as `Documentation` and `Issues`; empty before the project has a public one."""
    if IN_CHECKOUT:
        import tomllib  # --help reads the file in a checkout, and metadata elsewhere

        urls: dict[str, str] = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"].get("urls", {})
        return urls
    from importlib import metadata

    try:
        lines = metadata.metadata("rosml").get_all("Project-URL") or []
    except metadata.PackageNotFoundError:
        return {}
    return {name: address for name, _, address in (line.partition(", ") for line in lines)}


def help_lines() -> tuple[str, ...]:
    if urls := addresses():
        return tuple(f"{name}: {address}" for name, address in urls.items())
    source = "that you cloned" if IN_CHECKOUT else "that rosml was installed from"
    return (
        "Pages: docs/. Messages and remedies: docs/troubleshooting.md.",
        f"Report problems as issues of the repository {source}.",
    )
