"""The documentation: no broken link or anchor, neither on a forge nor on the site, which asks no other host for anything;
and files that it describes are as it says."""

from __future__ import annotations

import ast
import json
import re
import urllib.parse
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
import yaml
from conftest import ROOT

from rosml.base.errors import RosmlError
from rosml.base.project_addresses import addresses
from rosml.images.catalogue import tags_page
from rosml.images.image_set import locked
from rosml.images.image_set.model import ImageSet
from scripts import docs
from tests.pages import Block, blocks, pages

PAGES = pages()


def prose(text: str) -> str:
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^ *```.*?^ *```", "", text, flags=re.MULTILINE | re.DOTALL))


def links(page: Path) -> list[str]:
    return re.findall(r"\]\(([^)\s]+)\)", prose(page.read_text()))


def anchors(page: Path) -> set[str]:
    """The anchors of a page's headings, as forges make them."""
    counts: dict[str, int] = {}
    text = re.sub(r"^ *```.*?^ *```", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)
    for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE):
        words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
        slug = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        counts[slug] = counts.get(slug, -1) + 1
    return {slug if not number else f"{slug}-{number}" for slug, last in counts.items() for number in range(last + 1)}


def broken(page: Path, link: str) -> str:
    path, _, anchor = link.partition("#")
    if "://" in link:
        address = urllib.parse.urlsplit(link)
        right = address.scheme == "https" and re.fullmatch(r"[\w-]+(\.[\w-]+)+", address.netloc)
        return "" if right else "no https address"
    target = (page.parent / path).resolve() if path else page
    if not target.is_relative_to(ROOT) or not target.is_file():
        return "no such file"
    if anchor and (target.suffix != ".md" or anchor not in anchors(target)):
        return f"no heading for #{anchor}"
    return ""


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_no_link_is_broken(page: Path) -> None:
    assert {link: wrong for link in links(page) if (wrong := broken(page, link))} == {}


# ---- The site --------------------------------------------------------------------------------------------------------


class Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.fetched: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        attributes = {name: value or "" for name, value in attrs}
        if "src" in attributes or ("href" in attributes and tag == "link" and attributes.get("rel") != "canonical"):
            self.fetched.append(attributes.get("src") or attributes["href"])


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> dict[Path, Reader]:
    folder = tmp_path_factory.mktemp("docs")
    assert docs.main.main(["--output", str(folder)], standalone_mode=False) is None
    readers = {}
    for file in (folder / "site").rglob("*.html"):
        readers[file] = Reader()
        readers[file].feed(file.read_text())
    return readers


def test_the_site_is_built(site: dict[Path, Reader]) -> None:
    names = {f"{file.parent.name}/{file.name}" for file in site}
    assert {f"site/{name}.html" for name in ("index", "SECURITY", "CONTRIBUTING")} <= names
    assert len(site) >= len(PAGES)


def test_the_site_asks_no_other_host(site: dict[Path, Reader]) -> None:
    assert [name for page in site.values() for name in page.fetched if re.match(r"(https?:)?//", name)] == []
    root = next(file for file in site if file.name == "404.html").parent
    styles = list(root.rglob("*.css"))
    assert styles
    assert [file.name for file in styles if re.search(r"(url\(|@import )[\"']?(https?:)?//", file.read_text())] == []


def test_every_page_of_the_site_says_where_to_ask(site: dict[Path, Reader]) -> None:
    assert [file.name for file in site if docs.footer(addresses()) not in file.read_text()] == []
    assert (
        docs.footer({"Issues": "https://forge.example/?a&b"}) == '<a href="https://forge.example/?a&amp;b">Issues</a>'
    )


def test_a_site_with_broken_links_is_not_built(tmp_path: Path) -> None:
    docs.stage(ROOT, tmp_path)
    gone = ("nothing.md", "../nothing.md", "contract.md#nothing")
    with (tmp_path / "docs/docs/limits.md").open("a") as page:
        page.write("".join(f"\n[gone]({link})\n" for link in gone))
    with pytest.raises(RosmlError) as caught:
        docs.build(tmp_path)
    message = re.sub(r"\x1b\[[0-9;]*m", "", caught.value.message)
    for link in gone:
        assert f"[gone]({link})" in message
    assert "Traceback" not in message


def test_every_page_is_in_the_navigation() -> None:
    def leaves(node: Any) -> Iterator[str]:
        if isinstance(node, str):
            yield node
        for inner in node.values() if isinstance(node, dict) else node if isinstance(node, list) else ():
            yield from leaves(inner)

    text = re.sub(r"!!python/\S+", "", (ROOT / "mkdocs.yml").read_text())
    nav = list(leaves(yaml.safe_load(text)["nav"]))
    assert sorted(nav) == sorted({str(page.relative_to(ROOT)) for page in PAGES})


# ---- What pages say --------------------------------------------------------------------------------------------------


def test_the_status_page_has_a_line_for_each_thing() -> None:
    page = (ROOT / "docs/status.md").read_text()
    rows = [line for line in page.splitlines() if line.startswith("| ") and not re.match(r"\| (---|what) ", line)]
    assert len(rows) > 20
    for row in rows:
        _, state, where = (cell.strip() for cell in row.strip("|").split(" | "))
        assert state in ("built and tested", "tested against a local replacement", "not run")
        details = re.fullmatch(r"<details><summary>(?P<summary>.{5,60})</summary>.+</details>", where)
        assert details, row


def test_the_page_of_tags_says_which_images_lack_a_lock(real: ImageSet, small: ImageSet) -> None:
    page = tags_page.render((ROOT / "docs/tags.md").read_text(), real)
    text = page.partition(tags_page.BEGIN)[2].partition("\n| distribution |")[0]
    lacking = {(i.repository, i.stack, i.distribution) for i in real.images if not i.locked and i.tags}
    assert lacking, "then the sentence is not there"
    for repository, stack, distribution in lacking:
        (line,) = [line for line in text.splitlines() if line.startswith(f"- `{repository}:<d>-<c>-{stack}`: ")]
        assert distribution in re.split(r": |, | and ", line)
    assert text.count("\n- ") == len({(repository, stack) for repository, stack, _ in lacking})
    whole = locked.with_locks(small, small.locks)
    assert "cannot be built" not in tags_page.tables(whole)


def test_the_page_of_tags_says_which_distributions_lack_an_image(real: ImageSet) -> None:
    table, _, rest = (ROOT / "docs/tags.md").read_text().partition("\nNot for every `<d>`: ")
    sentence = rest.partition("\n\n")[0]
    repositories = re.findall(r"`(ros-\w+):<d>-<c>-(\w+)`", table.rpartition("| you have |")[2])
    assert len(repositories) >= 7
    existing = {(image.distribution, image.repository, image.stack) for image in real.images}
    lacking = {name for name in real.matrix.distributions for tag in repositories if (name, *tag) not in existing}
    assert set(re.findall(r"[\w-]+", sentence)) & real.matrix.distributions.keys() == lacking
    for stack in ("cu121", "cpu38"):
        assert {name for name, repository, other in existing if (repository, other) == ("ros-torch", stack)} <= lacking
        assert f"`{stack}`" in sentence


def titled(name: str) -> Iterator[Block]:
    return (block for page in PAGES for block in blocks(page) if block.title == name)


@pytest.mark.parametrize("name", [".github/workflows/test.yml", ".gitlab-ci.yml", "compose.yaml"])
def test_yaml_of_the_documentation_is_yaml(name: str, real: ImageSet) -> None:
    [block] = titled(name)
    content = yaml.safe_load(block.text)
    assert isinstance(content, dict)
    [image] = re.findall(r"(?:image|container): \S*/(ros\S*)", block.text)
    assert image in tags(real)


def test_the_workflow_of_the_documentation_can_pull_private_packages() -> None:
    [block] = titled(".github/workflows/test.yml")
    workflow = yaml.safe_load(block.text)
    assert workflow["permissions"] == {"contents": "read", "packages": "read"}
    [job] = workflow["jobs"].values()
    assert job["container"]["credentials"] == {"username": "${{ github.actor }}", "password": "${{ github.token }}"}


def test_a_dev_container_is_json() -> None:
    [block] = titled(".devcontainer/devcontainer.json")
    assert json.loads(block.text)["workspaceFolder"].startswith("/docker-ros/ws")


def tags(image_set: ImageSet) -> set[str]:
    return {tag for image in image_set.images for tag in image.tags}


def test_every_image_that_a_page_builds_on_is_one_that_there_is(real: ImageSet) -> None:
    base_images = [
        (block.page, image)
        for page in PAGES
        for block in blocks(page)
        for image in re.findall(r"^FROM <registry>/(\S+)", block.text, re.MULTILINE)
    ]
    assert len(base_images) >= 3
    assert [item for item in base_images if item[1] not in tags(real)] == []


def test_old_tags_lead_to_tags_that_there_are(real: ImageSet) -> None:
    page = (ROOT / "docs/migrate.md").read_text().partition("\n## From rocker\n")[0]  # whose table has options
    rows = re.findall(r"^\| (`[^`]*:.*?) \| (.*) \|$", page, re.MULTILINE)
    assert len(rows) > 15
    existing, repository = tags(real), ""
    for _, new in rows:
        if new.startswith("none"):
            continue
        for tag in re.findall(r"`([^`]+)`", new):
            repository = tag.partition(":")[0] if ":" in tag else repository
            assert (tag if ":" in tag else f"{repository}:{tag}") in existing, new


def installed() -> tuple[set[str], set[str]]:
    """The packages of every image: of those to build in, and of those that only run."""
    script = (ROOT / "components/base/install.sh").read_text()
    only_run, build = (
        {name for line in text.splitlines() if not line.strip().startswith("#") for name in line.split()}
        for text in re.findall(r"^  packages=\(\n(.*?)^  \)$", script, re.MULTILINE | re.DOTALL)
    )
    return build, only_run


def test_packages_of_other_images_are_where_the_page_says(real: ImageSet) -> None:
    section = (ROOT / "docs/migrate.md").read_text().partition("\n### Packages\n")[2].partition("\n### ")[0]
    rows = re.findall(r"^\| (`.*`) \| (.*) \|$", section, re.MULTILINE)
    build, only_run = installed()
    tools = {name: {*system.tools.split()} for name, system in real.matrix.operating_systems.items()}
    for theirs, place in rows:
        packages, ours = ({*re.findall(r"`([^`]+)`", cell)} for cell in (theirs, place))
        if place.startswith("in every image"):
            assert packages <= build and packages & only_run == ours, theirs
        elif place.startswith("with `"):
            assert ours <= build & only_run, theirs
        elif place.startswith("with ROS"):
            for system, names in tools.items():
                assert (packages if system.startswith("ubuntu") else ours) <= names, system
        else:
            assert re.match("a line in `docker/additional-|the same", place), place
            assert not packages & (build | only_run).union(*tools.values()), theirs
    assert {"zip", "unzip", "iputils-ping", "gdb", "software-properties-common"} <= {*re.findall(r"`([^`]+)`", section)}


THEIRS = {
    *(
        "permission denied while trying to connect to the Docker daemon socket",
        "to the docker API",
        "exec format error",
    ),
    *('could not select device driver "" with capabilities: [[gpu]]', "no space left on device"),
    "nvidia-container-cli: requirement error: unsatisfied condition: cuda>=13.0",
    *("archive/tar: invalid tar header", "unsupported frontend capability"),
    *("manifest unknown", "pull access denied", "repository does not exist", "toomanyrequests"),
    *("dial tcp 127.0.0.1:…: connect: connection refused", "No module named 'rclpy'", "ros2: command not found"),
    *("cannot allocate memory in static TLS block", "detected dubious ownership in repository"),
    *("torch.cuda.is_available()", "False"),
    *("cannot open display", "could not connect to display", "Bus error"),
    "CUDA error: no kernel image is available for execution on the device",
    *("DataLoader worker … is killed", 'Could not find a package configuration file provided by "…"'),
}
"""Messages of other programs, as people search for them."""


def looked_up() -> set[str]:
    page = (ROOT / "docs/troubleshooting.md").read_text().partition("## Python packages")[0]
    rows = [line.split(" | ")[0] for line in page.splitlines() if line.startswith("| ") and "---" not in line]
    return {message for row in rows for message in re.findall(r"`([^`]+)`", row)}


def test_each_message_to_look_up_is_one_that_is_printed() -> None:
    code = "".join(file.read_text() for file in (ROOT / "src/rosml").rglob("*.py"))
    code = code.replace("{about.program}", "docker").replace("{engine.program}", "docker")
    code += " ".join(f"no {kind} named" for kind in re.findall(r'\bunknown\(\s*"(\w+)"', code))
    messages = looked_up()
    assert messages > THEIRS
    assert [message for message in sorted(messages - THEIRS) if message not in code] == []


def literal(text: ast.expr | None) -> list[str]:
    """What stands so in a text, between the values that are put into it."""
    if isinstance(text, ast.BinOp):
        return [*literal(text.left), *literal(text.right)]
    parts = text.values if isinstance(text, ast.JoinedStr) else [text]
    return [part.value for part in parts if isinstance(part, ast.Constant) and isinstance(part.value, str)]


def error_texts(file: Path) -> Iterator[str]:
    """The longest words that stand so in each message of a file: of errors, and of notes that are a sentence and its remedy."""
    for function in (node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.FunctionDef)):
        texts: list[ast.expr | None] = []
        for node in ast.walk(function):
            value = node.value if isinstance(node, (ast.Yield, ast.Return)) else None
            if isinstance(node, ast.Call) and ast.unparse(node.func).endswith("notes.append"):
                value = node.args[0]
            if isinstance(value, ast.Tuple) and len(value.elts) == 2:
                texts.append(value.elts[0])
            if isinstance(node, ast.Call) and ast.unparse(node.func) == "RosmlError":
                texts.append(node.args[0])
            if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "text":
                texts.append(node.value)
        for text in texts:
            longest = max((words.strip(" ,;:(0123456789") for words in literal(text)), key=len, default="")
            if " " in longest:
                yield longest


def test_messages_that_newcomers_meet_are_there_to_look_up() -> None:
    code = ROOT / "src/rosml"
    files = [
        *(code / "containerize/init").glob("*.py"),
        code / "containerize/packages/manifest.py",
        code / "cli/containerize/init.py",
    ]
    messages = {message for file in files for message in error_texts(file)} | {
        "waiting for a builder",
        "there is no image",
    }
    assert len(messages) > 25
    page = looked_up()
    assert [message for message in sorted(messages) if not any(message in text for text in page)] == []
