"""Nothing unpinned is downloaded in a build: what comes from the network by a name of its own is compared with a digest, and
nothing is run as it comes. Packages of the distribution and of ROS are apt's, by signed lists."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

DOWNLOAD = r"\b(?:curl|wget)\s+(?:-|[\"']?(?:[a-z]+://|\$))"
SHELL = r"(?:sudo\s+(?:-\S+\s+)*)?(?:ba|da|z|k)?sh\b|python[0-9.]*\b|perl\b"

RULES = {
    "runs what it downloads": rf"(?:curl|wget)\b[^;&\n]*\|\s*(?:{SHELL})|(?:\bsh|\bbash|\bsource|\.|\beval)\s+(?:-c\s+)?[\"']?[<$]\((?:curl|wget)",
    "asks for the latest of something": r":latest\b|/latest\b|@latest\b|\blatest/|api\.github\.com",
    "pip without hashes": r"\bpip[0-9.]*[\"']?\s+install\b(?!.*--require-hashes)(?!.*--no-index)(?!.*(?:\$\{requirements\[@\]\}|/run/requests/pip))",
    "clones what moves": r"\bgit\s+(?:clone|pull|fetch)\b",
    "a package manager without hashes": r"\b(?:npm|pnpm|yarn|gem|cargo|go|conda|mamba)\s+(?:install|add|i)\b|\bpipx\b|\bnpx\b|\buvx\b",
    "trusts whoever answers": r"--insecure\b|--no-check-certificate\b|--allow-unauthenticated\b|\[[^]]*trusted=yes|--trusted-host",
}
"""What a line must not do. `${requirements[@]}` and `/run/requests/pip` are those of a user's own repository, in components/containerize."""

STEPS = {
    "ADD of an address without a checksum": r"^ADD\s(?!.*--checksum=sha256:[0-9a-f]{64}\b).*\b(?:https?|ftp|git)(?:://|@)",
    "FROM an image without a digest": r"^FROM\s+(?:--platform=\S+\s+)?(?!\S*@sha256:)\S*[/:.]",
    "COPY from an image without a digest": r"^COPY\s.*--from=(?!\S*@sha256:)\S*[/:.]",
    "a frontend without a digest": r"^#\s*syntax\s*=(?!.*@sha256:)",
}
"""What a step of a Dockerfile must not do, besides."""


def lines(text: str) -> Iterator[str]:
    """Lines with those that continue them, without comments."""
    whole = re.sub(r"^[ \t]*#(?!\s*syntax)[^\n]*\n", "", text, flags=re.MULTILINE)
    yield from (re.sub(r"\s+#\s.*", "", line) for line in re.sub(r"\\\n", " ", whole).splitlines())


def functions(text: str) -> list[str]:
    """A script's functions, and what is outside of them."""
    bodies = re.findall(r"^\w+\(\) \{\n.*?^\}\n", text, re.MULTILINE | re.DOTALL)
    for body in bodies:
        text = text.replace(body, "")
    return [*bodies, text]


def findings(name: str, text: str) -> list[str]:
    """What is wrong with a file, a line each."""
    dockerfile = Path(name).name == "Dockerfile"
    if name.endswith(".py"):
        text = re.sub(r"`[^`\n]*`", "", text)  # a command that a docstring speaks of
    rules = {**RULES, **(STEPS if dockerfile else {})}
    wrong = [
        f"{name}: {what}: {line.strip()[:150]}"
        for line in lines(text)
        for what, pattern in rules.items()
        if re.search(pattern, line)
    ]
    # Where a download is, there is its digest: in the same step, or in the same function.
    for part in lines(text) if dockerfile else functions("\n".join(lines(text)) + "\n"):
        if (download := re.search(DOWNLOAD, part)) and not re.search(r"sha(256|512)sum\b", part):
            wrong.append(f"{name}: a download without a digest: {part[download.start() :].splitlines()[0][:150]}")
    return wrong


def test_builds_download_nothing_unpinned() -> None:
    files = [ROOT / "Dockerfile", ROOT / "tests/e2e/docker_ros/Dockerfile"]
    files += [path for path in sorted((ROOT / "components").rglob("*")) if path.is_file() and path.suffix != ".asc"]
    files = [path for path in files if "__pycache__" not in path.parts]
    assert len(files) > 40
    assert [line for path in files for line in findings(str(path.relative_to(ROOT)), path.read_text())] == []


def test_the_one_download_is_seen() -> None:
    """Without its comparison it is a finding: the rule reads the scripts as they are written."""
    text = (ROOT / "components/ros/source.sh").read_text()
    [finding] = findings("source.sh", text.replace("sha256sum", "cat"))
    assert finding.startswith("source.sh: a download without a digest: curl --silent")


DIGEST = "0" * 64

BAD = {
    "curl -fsSL https://example.org/install.sh | bash": "runs what it downloads",
    "curl --location \\\n  https://example.org/x |\\\n  sh": "runs what it downloads",
    'bash -c "$(curl -fsSL https://example.org/x)"': "runs what it downloads",
    "curl -o x.deb https://example.org/x.deb && dpkg -i x.deb": "a download without a digest",
    'curl --output x "$url"': "a download without a digest",
    "get() {\n  wget -q $1\n}\ncheck() {\n  sha256sum --check\n}": "a download without a digest",
    "url=https://github.com/a/b/releases/latest/download/x.deb": "asks for the latest",
    '"${UV:?}" pip install \\\n  torch': "pip without hashes",
    "git clone --depth 1 https://github.com/a/b": "clones what moves",
    "go install example.org/x@v1": "a package manager without hashes",
    "curl -k --insecure https://example.org/x | sha256sum": "trusts whoever answers",
    'echo "deb [trusted=yes] http://example.org/ ./"': "trusts whoever answers",
}
BAD_STEPS = {
    "ADD https://example.org/x.tar.gz /x": "ADD of an address without a checksum",
    "ADD git@github.com:a/b.git /x": "ADD of an address without a checksum",
    "FROM --platform=linux/amd64 docker.io/library/debian AS x": "FROM an image without a digest",
    "COPY --from=ghcr.io/astral-sh/uv:0.9 /uv /uv": "COPY from an image without a digest",
    "# syntax=docker/dockerfile:1": "a frontend without a digest",
    "RUN wget -q https://example.org/x\nRUN sha256sum --check list": "a download without a digest",
}
GOOD = {
    "script.sh": "packages=(\n  vim wget curl ca-certificates\n)\n# curl -s https://example.org | bash\necho 1 # pip install x\n"
    'get() {\n  curl --output "$1" "$url"\n  [[ $(sha256sum "$1") == "$digest"* ]]\n}\n'
    "uv pip install --no-deps \\\n  --require-hashes --requirement lock.txt\npip install --no-index x\n"
    "apt-get install --yes git curl\n",
    "Dockerfile": f"FROM os AS base\nFROM docker.io/library/debian:bookworm@sha256:{DIGEST}\nFROM assembler-${{PART}} AS x\n"
    f"COPY --link --from=part /out/ /\nADD --checksum=sha256:{DIGEST} https://example.org/x /x\n"
    f"RUN curl -o x https://example.org/x && \\\n    echo {DIGEST} x | sha256sum --check\n",
}


@pytest.mark.parametrize("sample", BAD)
def test_bad_lines_are_found(sample: str) -> None:
    for name, text in (("script.sh", sample), ("Dockerfile", f"RUN {sample}")):
        if name == "Dockerfile" and "() {" in sample:
            continue
        assert any(BAD[sample] in finding for finding in findings(name, f"{text}\n")), findings(name, text)


@pytest.mark.parametrize("sample", BAD_STEPS)
def test_bad_steps_are_found(sample: str) -> None:
    assert any(BAD_STEPS[sample] in finding for finding in findings("Dockerfile", f"{sample}\n"))


@pytest.mark.parametrize("name", GOOD)
def test_good_ones_are_not(name: str) -> None:
    assert findings(name, GOOD[name]) == []
