"""People find an image, copy its line, compare it and see its history: in Chromium or Chrome, on any screen, with mouse or keys."""

from __future__ import annotations

import functools
import http.server
import json
import logging
import re
import tarfile
import threading
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
import yaml

from fakes.shelf import Shelf
from rosml import ROOT
from rosml.images.catalogue.model import Image, Published
from rosml.images.catalogue.read import Gatherer
from rosml.images.image_set import load
from rosml.images.publish import cosign
from rosml.registry.place import Place
from tests.page.conftest import MIDDLE, NARROW, NOW, REGISTRY, WIDE, PageOf, Window, Windows, expect, tree

LOG = logging.getLogger("page")
TORCH = "ros1-bookworm-base-torch-cu128"
ANY = "#/?status=any"
"""The list with images that are not published."""

ROUTES = {
    "list": "#/",
    "any": ANY,
    "none": "#/?q=nothing-has-this-name",
    "image": f"#/image/{TORCH}",
    "absent": "#/image/jazzy-base-torch-cu128",
    "unknown": "#/image/nothing",
    "compare": "#/compare",
    "compared": f"#/compare?a={TORCH}&b=ros1-trixie-base-torch-cu128",
    "layers": "#/layers",
    "start": "#/start",
}


def image(published: Published, target: str) -> Image:
    return next(item for item in published.images if item.target == target)


def with_image(published: Published, item: Image, **changes: Any) -> Published:
    images = [i.model_copy(update=changes) if i is item else i for i in published.images]
    return published.model_copy(update={"images": tuple(images)})


def texts(page: Any, selector: str) -> list[str]:
    return [text.strip() for text in page.locator(selector).all_text_contents()]


def listed(page: Any) -> list[str]:
    """Targets in the list, all of them."""
    page.locator(".rest button").evaluate("(button) => button.click()")  # show all of them
    return texts(page, ".list tbody th a")


def clipboard(page: Any) -> str:
    return str(page.evaluate("navigator.clipboard.readText()"))


# ---- Find ------------------------------------------------------------------------------------------------------------


def test_published_images_are_shown_alone_and_all_are_one_step_away(window: Windows, published: Published) -> None:
    page = window().open()
    order = [item.target for item in published.images]
    built = [item.target for item in published.images if item.status == "built"]
    assert listed(page) == built
    assert texts(page, ".summary") == [f"All {len(built)} published images"]
    page.get_by_role("button", name=f"Show {len(order) - len(built)} more that are not built yet").click()
    assert listed(page) == built + [target for target in order if target not in built]
    assert texts(page, ".summary") == [f"All {len(order)} images, {len(built)} published here"]
    assert not page.locator('input[value="built"]').is_checked() and page.url.endswith(ANY)
    page.get_by_role("button", name="Show published ones alone").click()
    assert listed(page) == built and page.url.endswith("#/")


def test_a_text_that_means_no_published_image_shows_the_others(window: Windows) -> None:
    page = window().open()
    page.get_by_label("Search names").fill(f"{REGISTRY}/ros-torch:jazzy")
    assert listed(page) == ["jazzy-base-torch-cu130"]
    assert texts(page, ".summary")[0].startswith("None of the ") and texts(page, ".summary")[0].endswith(": 1 image")
    page.get_by_label("Search names").fill("core")
    assert {target[:4] for target in listed(page)} == {"ros1"}
    page.get_by_label("Search names").fill("")
    page.locator('input[value="jazzy"]').check()
    assert page.get_by_text("No published image matches.").is_visible() and listed(page) == []
    page.get_by_role("button", name=re.compile(r"^Show \d+ more that are not built yet$")).click()
    assert {target.partition("-")[0] for target in listed(page)} == {"jazzy"}


def test_where_nothing_is_published_all_are_shown(page_of: PageOf) -> None:
    shelf = Shelf(load.load(ROOT / "matrix.yaml", ROOT))
    catalogue = Gatherer(shelf.image_set, Place(shelf.registry, "rosml")).gather(NOW)
    windows = page_of(catalogue)
    page = windows().open()
    assert listed(page) == [item.target for item in catalogue.images]
    assert not page.locator("button.every").is_visible()


def test_enter_opens_the_first_image(window: Windows) -> None:
    page = window().open()
    page.keyboard.press("/")
    page.keyboard.type("gpu jazzy core")
    page.keyboard.press("Enter")
    expect(page.locator("h1")).to_have_text("jazzy-core-cuda-cu128")
    assert page.evaluate("document.activeElement.tagName") == "H1"
    page.go_back()
    assert page.get_by_label("Search names").input_value() == "gpu jazzy core"
    page.get_by_label("Search names").fill("nothing-has-this-name")
    page.keyboard.press("Enter")
    assert page.locator("h1").text_content() == "Images"


FILTERS: dict[str, tuple[dict[str, str], Callable[[Image], bool]]] = {
    "distribution": ({"distribution": "jazzy"}, lambda i: i.distribution == "jazzy"),
    "component": ({"component": "desktop-full"}, lambda i: i.component == "desktop-full"),
    "framework": ({"framework": "ml"}, lambda i: i.framework == "ml"),
    "stack": ({"stack": "cu130"}, lambda i: i.stack == "cu130"),
    "architecture": ({"architecture": "arm64"}, lambda i: "linux/arm64" in i.platforms),
    "support": ({"support": "end of life"}, lambda i: i.distribution in ("noetic", "foxy", "iron")),
    "changed": ({"changed": "last"}, lambda i: bool(i.builds) and i.builds[0].created[:10] == "2026-11-22"),
    "status": ({"status": "not built"}, lambda i: i.status == "not built"),
    "two groups": (
        {"distribution": "ros1-trixie", "framework": "torch"},
        lambda i: (i.distribution, i.framework) == ("ros1-trixie", "torch"),
    ),
}


@pytest.mark.parametrize("name", FILTERS)
def test_filters(name: str, window: Windows, published: Published) -> None:
    values, matches = FILTERS[name]
    page = window().open(ANY)
    for group, value in values.items():
        page.locator(f'fieldset[data-group="{group}"] input[value="{value}"]').check()
    expected = {item.target for item in published.images if matches(item)}
    assert set(listed(page)) == expected
    assert texts(page, ".summary")[0].startswith(f"{len(expected)} of {len(published.images)} images")
    for group, value in values.items():
        number = page.locator(f'fieldset[data-group="{group}"] label:has(input[value="{value}"]) .number')
        assert number.text_content() == str(len(expected)), "the number beside a choice is what it gives"


def test_two_values_of_a_group_give_both(window: Windows) -> None:
    page = window().open(ANY)
    number = page.locator('fieldset[data-group="stack"] label:has(input[value="cu130"]) .number')
    before = number.text_content()
    for value in ("cu121", "cu130"):
        page.locator(f'fieldset[data-group="stack"] input[value="{value}"]').check()
        assert number.text_content() == before != "0", "one value of a group takes nothing from another"
    assert {target.rsplit("-", 1)[1] for target in listed(page)} == {"cu121", "cu130"}


WORDS_IN_PIECES = """(node) => [...node.textContent.matchAll(/\\S+/g)].filter((word) => {
    const range = document.createRange();
    range.setStart(node.firstChild, word.index);
    range.setEnd(node.firstChild, word.index + word[0].length);
    return range.getClientRects().length > 1;
}).map((word) => word[0])"""


def test_a_published_image_has_the_platforms_of_its_index(page_of: PageOf, published: Published) -> None:
    """What else the matrix allows is said apart."""
    item = image(published, "ros1-bookworm-core")
    build = item.builds[0].model_copy(update={"platforms": item.builds[0].platforms[:1]})
    changed = with_image(published, item, builds=(build, *item.builds[1:]))
    windows = page_of(changed)
    page = windows().open()
    assert texts(page, 'tr:has(a[href="#/image/ros1-bookworm-core"]) td:nth-child(3)') == ["amd64not published: arm64"]
    assert texts(page, 'tr:has(a[href="#/image/ros1-bookworm-base"]) td:nth-child(3)') == ["amd64, arm64"]
    for width in (1000, 1280, 1300, 1500):
        page.set_viewport_size({"width": width, "height": 900})
        assert page.locator(".place .sub").evaluate(WORDS_IN_PIECES) == [], width
    page.locator('fieldset[data-group="architecture"] input[value="arm64"]').check()
    assert "ros1-bookworm-base" in listed(page) and "ros1-bookworm-core" not in listed(page)
    page = windows().open("#/image/ros1-bookworm-core")
    assert "linux/amd64not published: linux/arm64" in texts(page, ".facts dd")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("TRIXIE torch cu128 base-run", {"ros1-trixie-base-run-torch-cu128", "ros1-trixie-base-run-ml-cu128"}),
        ("ros-ml:ros1-bookworm-desktop-cu128", {"ros1-bookworm-desktop-ml-cu128"}),
        ("numpy 1.26.4 ros-tf:ros1-bookworm-core-cpu", {"ros1-bookworm-core-tensorflow-cpu"}),
        ("nothing-has-this-name", set()),
    ],
)
def test_free_text(text: str, expected: set[str], window: Windows) -> None:
    page = window().open()
    page.get_by_label("Search names, versions and digests").fill(text)
    assert set(listed(page)) == expected
    assert page.get_by_text("No image matches").is_visible() == (not expected)


def carries(item: Image, *names: str) -> bool:
    return all(name in item.promised for name in names)


def on(item: Image, published: Published, **facts: Any) -> bool:
    """Whether an image's distribution has some facts."""
    distribution = published.distributions[item.distribution]
    return all(getattr(distribution, name) == value for name, value in facts.items())


WORDS: dict[str, Callable[[Image, Published], bool]] = {
    "gpu": lambda i, _: carries(i, "cuda"),
    "NVIDIA": lambda i, _: carries(i, "cuda"),
    "lts": lambda i, p: on(i, p, lts=True),
    "noble": lambda i, p: on(i, p, os="ubuntu-24.04"),
    "jammy": lambda i, p: on(i, p, os="ubuntu-22.04"),
    "ubuntu:24.04": lambda i, p: on(i, p, os="ubuntu-24.04"),
    "ubuntu 24.04": lambda i, p: on(i, p, os="ubuntu-24.04"),
    "ubuntu-24.0": lambda i, p: on(i, p, os="ubuntu-24.04"),
    "debian 12": lambda i, p: on(i, p, os="bookworm"),
    "debian 14": lambda i, p: False,
    "py312": lambda i, p: on(i, p, python="3.12"),
    "python3.12": lambda i, p: on(i, p, python="3.12"),
    "python 3.1": lambda i, p: not on(i, p, python="3.8"),
    "jazzy 3.12": lambda i, _: i.distribution == "jazzy",
    "ros 1": lambda i, p: on(i, p, ros=1),
    "ros 2": lambda i, p: on(i, p, ros=2),
    "ros2": lambda i, p: on(i, p, ros=2),
    "ros 3": lambda i, p: False,
    "jetson": lambda i, _: (
        carries(i, "cuda") and "linux/arm64" in i.platforms and not i.addons
    ),  # ONNX Runtime has no code for it
    "onnxruntime": lambda i, _: "onnx" in i.addons,
    "x86 lyrical core-run": lambda i, _: (i.distribution, i.component) == ("lyrical", "core-run"),
    "aarch64": lambda i, _: "linux/arm64" in i.platforms,
    "pytorch": lambda i, _: carries(i, "torch"),
    "tf": lambda i, _: carries(i, "tensorflow"),
    "torch 2.14": lambda i, _: i.promised.get("torch") == "2.14.1",
    "cuda12.8": lambda i, _: i.promised.get("cuda") == "12.8.90",
    "driver 580": lambda i, _: "cuda" in i.promised,
    "driver 550": lambda i, _: i.promised.get("cuda", "").startswith("12."),
    "eol": lambda i, p: (p.distributions[i.distribution].eol or "9") < NOW,
    "latest": lambda i, _: "latest" in i.promised_tags,
    "ros-torch:jazzy": lambda i, _: i.target == "jazzy-base-torch-cu130",
    "FROM ghcr.io/me/rosml/ros-torch:jazzy": lambda i, _: i.target == "jazzy-base-torch-cu130",
    "docker pull localhost:5000/x/ros-torch:jazzy": lambda i, _: i.target == "jazzy-base-torch-cu130",
    "ros-torch:jazzy-base-cu13": lambda i, _: i.target in ("jazzy-base-torch-cu130", "jazzy-base-torch-cu132"),
    "worm": lambda i, p: False,
    "(+": lambda i, p: False,
}


def test_words_that_people_type(window: Windows, published: Published) -> None:
    """Words of the matrix, and tags that an image will get; digits are not found within digests or other numbers."""
    page = window().open()
    search = "(text) => rosml.catalogue.images.filter(rosml.search(text)).map((image) => image.target)"
    wrong = {}
    for text, matches in WORDS.items():
        expected = {item.target for item in published.images if matches(item, published)}
        if different := set(page.evaluate(search, text)) ^ expected:
            wrong[text] = sorted(different)
    assert wrong == {}
    assert page.evaluate(search, image(published, TORCH).builds[0].digest[:30]) == [TORCH]


def test_a_search_can_be_linked_to_and_cleared(window: Windows, published: Published) -> None:
    first = window().open()
    first.get_by_label("Search names").fill("base")
    first.locator('input[value="ros1-bookworm"]').check()
    address = first.url
    second = window()
    page = second.open("#" + address.partition("#")[2])
    assert listed(page) == listed(first)
    assert page.locator('input[value="ros1-bookworm"]').is_checked()
    page.get_by_role("button", name="Clear all filters").click()
    assert page.evaluate("document.activeElement.id") == "search"
    assert len(listed(page)) == sum(item.status == "built" for item in published.images)


def test_sorting(window: Windows, published: Published) -> None:
    page = window().open("#/?status=built")
    head = page.get_by_role("button", name="Size")
    head.click()
    sizes = {i.target: i.builds[0].platforms[0].size.compressed for i in published.images if i.builds}
    in_order = [sizes[target] for target in listed(page)]
    assert in_order == sorted(in_order, reverse=True) and len(set(in_order)) > 10
    assert page.locator("th:has(button:text('Size'))").get_attribute("aria-sort") == "descending"
    head.click()
    in_order = [sizes[target] for target in listed(page)]
    assert in_order == sorted(in_order)


def test_more_rows_come_when_the_end_is_near(window: Windows) -> None:
    page = window().open()
    rows = page.locator(".list tbody tr")
    before = rows.count()
    assert before < 200
    page.evaluate("scrollTo(0, document.body.scrollHeight)")
    expect(rows.nth(before)).to_be_attached()


# ---- Use -------------------------------------------------------------------------------------------------------------


def test_the_from_line_is_copied(window: Windows) -> None:
    page = window().open(f"#/?q={TORCH}")
    page.get_by_role("button", name=f"Copy the FROM line of {TORCH}").click()
    line = f"FROM {REGISTRY}/ros-torch:ros1-bookworm-base-cu128"
    page.get_by_text(f"Copied: {line}").wait_for()
    assert clipboard(page) == line


def test_without_the_browsers_clipboard_it_is_copied_as_well(window: Windows) -> None:
    opened = window()
    opened.page.add_init_script("navigator.clipboard.writeText = () => Promise.reject(new Error('no'))")
    page = opened.open(f"#/?q={TORCH}")
    page.get_by_role("button", name=f"Copy the FROM line of {TORCH}").click()
    page.get_by_text("Copied: FROM").wait_for()
    assert clipboard(page) == f"FROM {REGISTRY}/ros-torch:ros1-bookworm-base-cu128"


def test_any_tag_or_digest_can_be_copied(window: Windows, published: Published) -> None:
    item = image(published, TORCH)
    page = window().open(f"#/image/{TORCH}")
    assert texts(page, "#tag option") == [
        f"{tag.name} ({word})"
        for tag in item.tags
        for word in [
            {
                "main": "full name",
                "versions": "with versions",
                "floating": "short name",
                "dated": "of a day, never moves",
            }[tag.kind]
        ]
    ]
    dated = item.tags[-2]
    page.get_by_role("tab", name="Dockerfile").click()
    page.get_by_label("Tag", exact=True).select_option(dated.name)
    page.get_by_label("pin to the digest").check()
    line = f"FROM {REGISTRY}/ros-torch:{dated.name}@{dated.digest}"
    assert texts(page, ".panel pre") == [line]
    page.get_by_role("button", name="Copy the FROM line").click()
    page.get_by_text("Copied: FROM").wait_for()
    assert clipboard(page) == line


def used(page: Any, way: str) -> list[str]:
    """The texts below a tab of an image's page."""
    page.get_by_role("tab", name=way, exact=True).click()
    return [str(text) for text in page.locator(".panel pre").all_text_contents()]


def test_an_image_is_used_in_the_ways_of_the_docs(window: Windows) -> None:
    """One source of words: what the page says of an image is what docs/use.md and the page below it say."""
    pages = "".join((ROOT / "docs" / name).read_text() for name in ("use.md", "use/dev-container.md"))
    fences = dict(re.findall(r'```\w+ title="([^"]+)"\n(.*?)```', pages, re.DOTALL))
    call = r"rosml.usage[name](rosml.byTarget.get('jazzy-base-torch-cu128'), what)"
    page = window().open()
    reference = "<registry>/ros-torch:jazzy-base-cu128"

    def usage(name: str, what: str) -> Any:
        return page.evaluate(f"([name, what]) => {call}", [name, what])

    assert yaml.safe_load(usage("compose", reference)) == yaml.safe_load(fences["compose.yaml"])
    files = usage("devcontainer", reference)
    assert files[".devcontainer/Dockerfile"] == fences[".devcontainer/Dockerfile"]
    ours, theirs = (json.loads(item[".devcontainer/devcontainer.json"]) for item in (files, fences))
    assert ours == theirs
    assert f"\n{usage('run', 'IMAGE')}\n" in pages
    for image_name, target in (
        ("ros-torch:jazzy-base-cu130", "jazzy-base-torch-cu130"),
        ("ros-torch:ros1-bookworm-core-cu130", "ros1-bookworm-core-torch-cu130"),
    ):
        dockerfile = page.evaluate(
            "([target, name]) => rosml.usage.dockerfile(rosml.byTarget.get(target), name)",
            [target, f"<registry>/{image_name}"],
        )
        lines = [line for line in dockerfile.splitlines() if "rosdep" not in line]
        assert "```dockerfile\n" + "\n".join(lines) + "\n```" in pages


def test_gpus_are_asked_for_by_images_that_have_cuda_alone(window: Windows) -> None:
    page = window().open(f"#/image/{TORCH}")
    (line,) = used(page, "docker run")
    assert line == (
        "docker run --rm -it --gpus all -e DOCKER_UID=$(id -u) -e DOCKER_GID=$(id -g)"
        f' -v "$PWD:/docker-ros/ws" {REGISTRY}/ros-torch:ros1-bookworm-base-cu128'
    )
    page.get_by_role("button", name="Copy the docker run line").click()
    page.get_by_text("Copied: docker run").wait_for()
    assert clipboard(page) == line
    service = yaml.safe_load(used(page, "compose")[0])["services"]["detector"]
    assert service["deploy"] and service["command"] == "rosrun my_package detector.py"
    page = window().open("#/image/ros1-bookworm-base")
    assert "--gpus" not in used(page, "docker run")[0] and "deploy" not in used(page, "compose")[0]
    assert "gpu" not in "".join(used(page, "dev container"))


SIGNERS = {
    "https://github.com/me/rosml/.github/workflows/nightly.yml@refs/heads/main": (
        f"cosign verify --certificate-oidc-issuer {cosign.ISSUER} \\\n"
        "  --certificate-identity https://github.com/me/rosml/.github/workflows/nightly.yml@refs/heads/main"
    ),
    f"sha256:{'0' * 64}": "cosign verify --key cosign.pub --insecure-ignore-tlog=true",
}


@pytest.mark.parametrize("signer", SIGNERS)
def test_a_signature_is_verified_where_there_is_one(signer: str, page_of: PageOf, published: Published) -> None:
    item = image(published, TORCH)
    build = item.builds[0].model_copy(update={"signed": (signer,)})
    changed = with_image(published, item, builds=(build, *item.builds[1:]))
    windows = page_of(changed)
    page = windows().open(f"#/image/{TORCH}")
    assert used(page, "cosign") == [f"{SIGNERS[signer]} \\\n  {REGISTRY}/ros-torch@{build.digest}"]
    page = windows().open("#/image/ros1-bookworm-base")
    assert page.get_by_role("tab").all_text_contents() == ["docker run", "Dockerfile", "compose", "dev container"]


def test_tabs_by_keys(window: Windows) -> None:
    page = window().open(f"#/image/{TORCH}")
    page.get_by_role("tab", name="docker run").focus()
    for key, name in (("ArrowRight", "Dockerfile"), ("End", "dev container"), ("ArrowRight", "docker run")):
        page.keyboard.press(key)
        assert focused(page) == name and page.locator('[role=tab][aria-selected="true"]').all_text_contents() == [name]
    page.keyboard.press("ArrowLeft")
    tab_to(page, "Copy .devcontainer/devcontainer.json", most=3)
    nodes = tree(page)
    assert ("tablist", "Ways to use it") in nodes and ("tabpanel", "dev container") in nodes


def test_an_image_shows_what_is_inside(window: Windows, published: Published) -> None:
    item = image(published, "ros1-bookworm-core-tensorflow-cpu")
    page = window().open(f"#/image/{item.target}")
    assert texts(page, ".platform h3") == ["linux/amd64", "linux/arm64"]
    for number, platform in enumerate(item.builds[0].platforms):
        section = page.locator(".platform").nth(number)
        section.locator("summary").first.click()
        shown = dict(
            zip(
                section.locator("details").first.locator("tbody th").all_text_contents(),
                section.locator("details").first.locator("td").all_text_contents(),
                strict=True,
            )
        )
        assert shown == platform.versions
        parts = section.locator(".scroll").first.locator("tbody th").all_text_contents()
        assert parts == list(platform.parts)
        assert platform.tests and f"{platform.tests.passed} passed" in (section.text_content() or "")
        summary = "scan passed2 high, 27 medium known, none of which the policy stops; 525 packages"
        assert summary in (section.text_content() or "")


def rows(page: Any, table: str) -> list[list[str]]:
    return [texts(row, "th, td") for row in page.get_by_role("region", name=table).locator("tbody tr").all()]


def test_packages_come_from_the_sboms(window: Windows) -> None:
    opened = window()
    page = opened.open(f"#/image/{TORCH}")
    assert not any("packages/" in address for address in opened.requests), "until somebody asks"
    page.get_by_text("Packages, from the SBOMs").click()
    page.get_by_text("6 packages", exact=True).wait_for()
    assert rows(page, "Packages for linux/amd64") == [
        ["bash", "5.2", "Debian", "ros1-bookworm-base"],
        ["common", "2.1", "Python", "common-cu128-py311"],
        ["cuda", "2.1", "Python", "cuda-cu128"],
        ["pillow", "11.0", "Python", "torch-cu128-py311"],
        ["ros-base", "1.2", "Debian", "ros1-bookworm-base"],
        ["torch", "2.2", "Python", "torch-cu128-py311"],
    ]
    page.get_by_label("Search packages").fill("debian 1.2")
    page.get_by_text("1 of 6 packages").wait_for()
    assert texts(page, "[aria-label='Packages for linux/amd64'] tbody th") == ["ros-base"]


def test_the_worst_vulnerabilities_are_named_with_the_policys_verdict(
    page_of: PageOf, window: Windows, published: Published
) -> None:
    page = window().open(f"#/image/{TORCH}")
    page.get_by_text("The worst 20 of 29 vulnerabilities").click()
    vulnerabilities = rows(page, "Vulnerabilities for linux/amd64")
    assert len(vulnerabilities) == 20
    where = ["libexample1", "1:1.0-1+deb12u1"]
    accepted = "accepted until 2027-03-31: it is compiled out"
    assert vulnerabilities[:3] == [
        ["CVE-2026-1000", "high", *where, "1:1.0-1+deb12u2", "ros1-bookworm-base", accepted],
        ["CVE-2026-1001", "high", *where, "1:1.1~rc1", "ros1-bookworm-base", "listed only"],
        ["CVE-2026-1002", "medium", *where, "none", "ros1-bookworm-base", "listed only"],
    ]
    assert page.get_by_text("9 others not shown").is_visible()
    address = "https://www.cve.org/CVERecord?id=CVE-2026-1000"
    assert page.get_by_role("link", name="CVE-2026-1000").get_attribute("href") == address
    page = window().open("#/image/ros1-bookworm-core")
    page.get_by_text("Vulnerabilities by name").first.click()
    assert len(rows(page, "Vulnerabilities for linux/amd64")) == 3
    content = published.model_dump()
    of_torch = next(item for item in content["images"] if item["target"] == TORCH)
    scan = of_torch["builds"][0]["platforms"][0]["scan"]
    stops = {**scan["named"][0], "id": "X-1", "fails": True, "ignored": "", "until": ""}
    of_torch["builds"][0]["platforms"][0]["scan"] = {**scan, "outcome": "policy failed", "named": [stops]}
    windows = page_of(Published.model_validate(content))
    page = windows().open(f"#/image/{TORCH}")
    page.get_by_text("The worst 1 of 29 vulnerabilities").click()
    (stopping,) = rows(page, "Vulnerabilities for linux/amd64")
    assert (stopping[0], stopping[-1]) == ("X-1", "stops the image")


def test_an_image_says_what_changed_since_the_build_before(window: Windows) -> None:
    page = window().open(f"#/image/{TORCH}")
    news = page.locator("section:has(#news)")
    assert "The build of 2026-11-22 compared with that of 2026-11-21:" in (news.text_content() or "")
    assert "numpy 1.26.4 → 1.26.5" in (news.text_content() or "")
    page.get_by_text("Packages that changed for linux/amd64").click()
    expect(news.locator("tbody tr")).to_have_count(1)
    assert rows(page, "Packages that changed for linux/amd64") == [["torch", "2.1", "2.2", "Python"]]
    page = window().open("#/image/ros1-bookworm-core")
    assert "2026-11-21 compared with that of 2026-11-20" in (page.locator("section:has(#news)").text_content() or "")
    page.get_by_text("Packages that changed for linux/arm64").click()
    page.get_by_role("region", name="Packages that changed for linux/arm64").wait_for()
    assert rows(page, "Packages that changed for linux/arm64") == [
        ["ros-core", "1.1", "1.2", "Debian"],
        ["tzdata", "1", "removed", "Debian"],
    ]


def test_an_image_says_which_addons_it_can_take(window: Windows, published: Published) -> None:
    """With the commands, for the parts that it lacks."""
    page = window().open(f"#/image/{TORCH}")
    section = page.locator("section", has=page.locator("#addons"))
    taken = image(published, TORCH).takes
    assert texts(section, "summary") == ["onnx: onnxruntime", "triton: tritonclient"] and [*taken] == ["onnx", "triton"]
    section.locator("summary").first.click()
    name = f"{REGISTRY}/ros-torch:ros1-bookworm-base-cu128"
    parts = "grpc-cu128-py311,onnxruntime-cc-cu128,onnxruntime-cu128-py311"
    assert texts(section, "pre")[:2] == [
        f"rosml containerize --base-image {name} --addons onnx",
        f"rosml join {name} {REGISTRY}/part:{{{parts}}} --tag NAME",
    ]
    plain = window().open("#/image/ros1-trixie-core")
    summaries = texts(plain.locator("section", has=plain.locator("#addons")), "summary")
    assert "onnx-cpu: onnxruntime" in summaries
    assert "tensorrt-rtx-cu130: TensorRT-RTX, in private registries alone" in summaries


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        (
            "nvcc",
            "nvcc is the add-on devel. Images of cu130, cu132 can take it, and images of ROS alone, in private registries. For example ros1-",
        ),
        ("jazzy tensorrt", "TensorRT-RTX is the add-on tensorrt-rtx. Images of cu130, cu132 can take it"),
        (
            "onnxruntime",
            "onnxruntime is the add-on onnx. Images of cu128, cu130, cu132, cu121, cpu, cpu314 can take it",
        ),
        ("jazzy torch", ""),
    ],
)
def test_an_addon_is_found_though_no_tag_has_it(window: Windows, text: str, hint: str) -> None:
    page = window().open()
    page.get_by_label("Search names").fill(text)
    (text_of_hint,) = texts(page, ".hints")
    assert text_of_hint.startswith(hint) if hint else not text_of_hint
    if text == "onnxruntime":
        assert all("-onnx-" in target for target in listed(page)) and listed(page)
    if text == "nvcc":
        page.locator(".hints a").click()
        page.locator("#addons").wait_for()


def test_a_page_without_packages_offers_none(page_of: PageOf, published: Published) -> None:
    windows = page_of(published)
    page = windows().open(f"#/image/{TORCH}")
    assert page.locator("#news").is_visible() and page.get_by_text(re.compile("Packages(,| that)")).count() == 0


def test_what_is_not_published_says_why(window: Windows, published: Published) -> None:
    page = window().open("#/image/jazzy-base-torch-cu128")
    assert page.get_by_text("not built yet").is_visible()
    assert page.get_by_text(image(published, "jazzy-base-torch-cu128").reason).is_visible()
    assert page.get_by_role("tab").count() == 0
    assert texts(page, "pre") == ["./rosml image jazzy-base-torch-cu128"]
    promised = image(published, "jazzy-base-torch-cu128").promised_tags
    assert texts(page, "#main ul li") == [f"ros-torch:{tag}" for tag in promised]


BADGES = {
    "jazzy-base-torch-cu130": ["LTS until 2029-05-31", "NVIDIA driver 580 or newer"],
    "noetic-base-cuda-cu121": ["end of life since 2025-05-31", "NVIDIA driver 525 or newer"],
    "kilted-base": ["end of life on 2026-11-30"],
    "jazzy-wheels-core": ["experimental"],
    "rolling-base": [],
    "ros1-trixie-base-torch-cpu": [],
}


def test_badges_say_what_one_has_to_know_first(window: Windows) -> None:
    page = window().open(ANY)
    for target, badges in BADGES.items():
        page.get_by_label("Search names").fill(target)
        row = page.locator(f'tr:has(a[href="#/image/{target}"])')
        assert texts(row, ".badge") == badges
        page.evaluate(f"location.hash = '#/image/{target}'")
        expect(page.locator("h1")).to_have_text(target)
        assert texts(page, ".badge") == badges
        assert ("take ros1-trixie or ros1-bookworm" in texts(page, ".facts .sub")) is target.startswith("noetic")
        page.go_back()
        page.locator(".list").wait_for()
    page = window().open("#/image/jazzy-base-torch-cu130")
    facts = " ".join(texts(page, ".facts dd"))
    assert "PyTorch, amd64: sm_75 sm_80 sm_86 sm_90 sm_100 sm_120" in facts
    assert "PyTorch, arm64: sm_80 sm_90 sm_100 sm_110 sm_120" in facts


# ---- Start -----------------------------------------------------------------------------------------------------------


def choices(page: Any, name: str) -> list[str]:
    return [str(option.get_attribute("value")) for option in page.get_by_label(name).locator("option").all()]


def unpacked(page: Any, folder: Path) -> dict[str, str]:
    """The files that the page gives."""
    with page.expect_download() as download:
        page.get_by_role("button", name="Download rosml.tar").click()
    assert download.value.suggested_filename == "rosml.tar"
    download.value.save_as(folder / "rosml.tar")
    with tarfile.open(folder / "rosml.tar") as archive:
        archive.extractall(folder, filter="data")
    names = [path for path in folder.rglob("*") if path.is_file() and path.name != "rosml.tar"]
    return {path.relative_to(folder).as_posix(): path.read_text() for path in names}


def test_choices_lead_to_files_with_a_tag_that_exists(window: Windows, published: Published, tmp_path: Path) -> None:
    page = window(accept_downloads=True).open("#/start")
    assert choices(page, "ROS distribution") == ["ros1-bookworm", "ros1-trixie"], "published ones alone"
    assert "core-run" not in choices(page, "Component"), "which has no compiler"
    page.get_by_label("ROS distribution").select_option("ros1-trixie")
    assert page.evaluate("document.activeElement.id") == "choose-distribution"
    page.get_by_label("GPU").select_option("525")
    reference = f"{REGISTRY}/ros-torch:ros1-trixie-base-cu128"
    assert texts(page, "pre >> nth=0") == [reference]
    assert page.get_by_role("status").filter(has_text="Your image").text_content() == f"Your image: {reference}"
    files = unpacked(page, tmp_path)
    assert set(files) == {
        "Dockerfile",
        ".dockerignore",
        "compose.yaml",
        ".env",
        ".devcontainer/devcontainer.json",
        ".devcontainer/Dockerfile",
    }
    assert files["Dockerfile"].splitlines()[0] == f"FROM {reference}"
    service = yaml.safe_load(files["compose.yaml"])["services"]["detector"]
    assert service["build"] == "." and "volumes" not in service, "a mount would hide what was built"
    assert f"BASE_IMAGE={reference}\n" in files[".env"]
    page.reload()
    assert texts(page, "pre >> nth=0") == [reference], "the address keeps the choices"


def test_every_choice_gives_an_image_that_runs_there(window: Windows, published: Published) -> None:
    page = window().open("#/start")
    images = {f"{REGISTRY}/{i.repository}:{tag.name}": i for i in published.images for tag in i.tags}
    seen = set()
    for framework in choices(page, "Framework"):
        page.get_by_label("Framework").select_option(framework)
        for gpu in choices(page, "GPU"):
            page.get_by_label("GPU").select_option(gpu)
            (reference,) = texts(page, "pre >> nth=0")
            item = images[reference]
            seen.add((framework, gpu, item.stack))
            assert item.framework == framework
            if gpu == "none":
                assert not carries(item, "cuda")
            elif gpu == "jetson":
                assert "linux/arm64" in item.platforms and carries(item, "cuda")
            else:
                assert int(item.gpu["driver"]) <= int(gpu)
    assert {("torch", "580", "cu130"), ("torch", "525", "cu128"), ("torch", "jetson", "cu130")} <= seen
    assert {("tensorflow", "525", "cu128"), ("tensorflow", "none", "cpu"), ("none", "none", None)} <= seen


def test_without_published_images_there_is_nothing_to_start_from(page_of: PageOf) -> None:
    shelf = Shelf(load.load(ROOT / "matrix.yaml", ROOT))
    windows = page_of(Gatherer(shelf.image_set, Place(shelf.registry, "rosml")).gather(NOW, ["jazzy-base"]))
    page = windows().open("#/start")
    assert page.get_by_text("No image to build on is published").is_visible()
    assert page.get_by_role("button", name="Download").count() == 0


# ---- History and comparison ------------------------------------------------------------------------------------------


def test_history_tells_what_changed_between_two_nights(window: Windows) -> None:
    page = window().open(f"#/image/{TORCH}")
    nights = page.locator(".history > li")
    assert [text[:10] for text in texts(page, ".history .when")] == ["2026-11-22", "2026-11-21", "2026-11-20"]
    last, middle = (nights.nth(number).text_content() or "" for number in (0, 1))
    assert (
        "torch-cu128-py311 changed; an update pulls 813 MB and keeps 6 of 7 layers; the image keeps its size;" in last
    )
    assert "numpy 1.26.4 → 1.26.5" in last
    assert "ros1-bookworm-core, ros1-bookworm-base changed; an update pulls 51.0 MB" in middle
    assert "the image grows by 20.0 kB; ROS's packages moved" in middle
    assert "ROS's packages moved from lists-1 to lists-2" in middle
    assert "numpy" not in middle, "which was the same"
    assert page.get_by_text("3 runs moved the tag ros1-bookworm-base-cu128").is_visible()


def test_a_build_is_compared_with_the_one_before(window: Windows) -> None:
    page = window().open(f"#/image/{TORCH}")
    page.get_by_role("link", name="Compare the build of 2026-11-22 with the one before").click()
    verdict = page.locator("#verdict").text_content() or ""
    assert verdict == ("They share 6 of 7 layers, 2.32 GB. Whoever has the first pulls 813 MB for the second.")
    assert page.get_by_role("combobox", name="First").input_value() == "ros-torch:ros1-bookworm-base-cu128-20261121"


def test_two_tags_are_compared(window: Windows, published: Published) -> None:
    page = window().open("#/compare")
    page.get_by_role("combobox", name="First").fill(f"{REGISTRY}/ros-torch:ros1-bookworm-base-cu128")
    page.get_by_role("combobox", name="Second").fill("ros1-trixie-base-ml-cu128")
    page.get_by_role("button", name="Compare", exact=True).click()
    page.locator("#verdict").wait_for()
    pair = [image(published, name).builds[0].platforms[0] for name in (TORCH, "ros1-trixie-base-ml-cu128")]
    shared = set(pair[0].layers) & set(pair[1].layers)
    pulled = sum(published.layers[position].compressed for position in set(pair[1].layers) - shared)
    verdict = page.locator("#verdict").text_content() or ""
    assert f"share {len(shared)} of {len(pair[1].layers)} layers" in verdict
    assert f"pulls {pulled / 1e9:.2f} GB for the second" in verdict
    rows = dict(
        zip(
            texts(page, "[aria-label=Versions] tbody th"),
            texts(page, "[aria-label=Versions] tbody td:nth-of-type(2)"),
            strict=True,
        )
    )
    different = {
        name
        for name in pair[0].versions.keys() | pair[1].versions.keys()
        if pair[0].versions.get(name) != pair[1].versions.get(name)
    }
    assert rows.keys() == different and rows["tensorflow"] == "2.20.0"
    page.get_by_label("show those that are the same").check()
    assert len(texts(page, "[aria-label=Versions] tbody th")) == len(pair[0].versions.keys() | pair[1].versions.keys())
    where = texts(page, "[aria-label=Layers] tbody td:last-child")
    assert where.count("both") == len(shared) and len(where) == len({*pair[0].layers, *pair[1].layers})


def test_a_typo_is_told(window: Windows) -> None:
    page = window().open("#/compare")
    page.get_by_role("combobox", name="First").fill("ros1-bookworm-core")
    page.get_by_role("combobox", name="Second").fill("ros1-bookworm-cor")
    page.keyboard.press("Enter")
    assert page.get_by_role("alert").text_content() == "No published tag or image is called ros1-bookworm-cor"
    assert page.evaluate("document.activeElement.id") == "second"


def test_every_tag_that_is_offered_can_be_compared(page_of: PageOf) -> None:
    """After twelve nights as well, of which each left a dated tag."""
    shelf = Shelf(load.load(ROOT / "matrix.yaml", ROOT))
    for night in range(12):
        shelf.torch = str(night)
        shelf.night(f"2026-11-{11 + night}T03:00:00Z", ["ros1-bookworm"])
    catalogue = Gatherer(shelf.image_set, Place(shelf.registry, "rosml")).gather(NOW, [TORCH])
    windows = page_of(catalogue)
    opened = windows()
    page = opened.open(f"#/image/{TORCH}")
    tags = page.locator("#tag option").evaluate_all("(options) => options.map((option) => option.value)")
    assert len([tag for tag in tags if re.search(r"-202611\d\d$", tag)]) == 12
    for tag in tags:
        page = opened.open(f"#/compare?a={TORCH}&b=ros-torch%3A{tag}")
        assert page.locator("#verdict").is_visible(), tag
        assert not page.get_by_role("alert").is_visible(), tag


def test_a_tag_whose_build_cannot_be_read_is_told_so(page_of: PageOf, published: Published) -> None:
    item = image(published, TORCH)
    first = item.builds[-1].tags[0]
    changed = with_image(published, item, builds=item.builds[:-1])
    windows = page_of(changed)
    page = windows().open(f"#/compare?a={TORCH}&b=ros-torch%3A{first}")
    alert = f"ros-torch:{first} is published, but what it points at could not be read"
    assert page.get_by_role("alert").text_content() == alert


def test_first_and_second_are_swapped(window: Windows) -> None:
    page = window().open(f"#/compare?a={TORCH}&b=ros1-bookworm-base")
    page.get_by_role("button", name="Swap").click()
    expect(page).to_have_url(re.compile("#.*a=ros%3Aros1-bookworm-base"))
    assert "They share 4 of 7 layers" in (page.locator("#verdict").text_content() or "")


# ---- Shared layers ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("platform", ["linux/amd64", "linux/arm64"])
def test_the_picture_shows_each_layer_in_each_image(platform: str, window: Windows, published: Published) -> None:
    page = window().open("#/layers")
    page.get_by_label("Platform").select_option(platform)
    expect(page.locator("#platform")).to_have_value(platform)
    images = [p for i in published.images if i.builds for p in i.builds[0].platforms if p.platform == platform]
    used = {position for item in images for position in item.layers}
    apart = sum(published.layers[position].compressed for item in images for position in item.layers)
    stored = sum(published.layers[position].compressed for position in used)
    lead = page.locator(".lead").text_content() or ""
    assert lead.startswith(f"{len(images)} images consist of {len(used)} layers.")
    assert f"{int(100 * (apart - stored) / apart)} %" in lead
    assert page.locator(".picture g").count() == len(used)
    cells = page.evaluate(
        "[...document.querySelectorAll('.picture rect')].reduce((n, r) => n + r.width.baseVal.value, 0)"
    )
    assert cells == sum(len(set(item.layers)) for item in images), "a column for each image that has it"


def test_a_part_leads_to_its_images(window: Windows) -> None:
    page = window().open("#/layers")
    row = page.locator("tr:has(th:text-is('torch-cu128-py311'))")
    row.locator("summary").click()
    assert "ros1-bookworm-core-torch-cu128" in row.locator("a").all_text_contents()
    row.get_by_role("link", name=TORCH).click()
    assert page.locator("h1").text_content() == TORCH


# ---- For everybody ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("route", ROUTES)
def test_accessible(route: str, scheme: str, window: Windows) -> None:
    """By the rules of axe; in the dark only contrast is another matter."""
    axe = pytest.importorskip("axe_playwright_python.sync_playwright", reason="uv run --group page pytest tests/page")
    page = window(scheme=scheme).open(ROUTES[route])
    page.evaluate("[...document.querySelectorAll('details')].slice(0, 4).forEach((item) => { item.open = true; })")
    for tab in page.get_by_role("tab").all()[2:3]:
        tab.click()
    rules = {"runOnly": ["color-contrast"]} if scheme == "dark" else {}
    response = axe.Axe().run(page, options={"preload": False, **rules}).response
    assert [(item["id"], item["nodes"][0]["html"][:200]) for item in response["violations"]] == []
    assert len(response["passes"]) > (0 if rules else 15), "it looked"


@pytest.mark.parametrize("route", ROUTES)
def test_narrow_screens_scroll_in_one_direction(route: str, window: Windows) -> None:
    page = window(NARROW).open(ROUTES[route])
    page.evaluate("document.querySelectorAll('details').forEach((item) => { item.open = true; })")
    assert page.evaluate("document.documentElement.scrollWidth") <= NARROW["width"]
    assert page.locator("h1").is_visible()


def test_a_narrow_comparison_cuts_nothing_off(window: Windows) -> None:
    page = window(NARROW).open(ROUTES["compared"])
    for name in ("Facts", "Versions"):
        frame = page.get_by_role("region", name=name, exact=True)
        assert frame.evaluate("(frame) => frame.scrollWidth <= frame.clientWidth"), name
    assert ("cell", "differs") in tree(page), "which only the colour shows to others"


def test_long_words_fit_a_narrow_screen(page_of: PageOf, published: Published) -> None:
    long = "a" * 90
    item = image(published, TORCH)
    (platform,) = item.builds[0].platforms
    odd = platform.model_copy(update={"ros_sync": "debian bookworm 239d", "versions": {long: long}, "inputs": "0" * 64})
    build = item.builds[0].model_copy(update={"platforms": (odd,), "created": "2026-11-21T09:00:00Z"})
    changed = with_image(published, item, builds=(build, *item.builds[1:]), reason=long)
    packages = {sbom.digest: [(long, long, "deb")] for sbom in published.sboms}
    windows = page_of(changed, packages)
    page = windows(NARROW).open(f"#/image/{TORCH}")
    page.evaluate("document.querySelectorAll('details').forEach((item) => { item.open = true; })")
    page.get_by_label("Search packages").wait_for()
    assert page.evaluate("document.documentElement.scrollWidth") <= NARROW["width"]
    news = page.locator("section:has(#news)").text_content() or ""
    assert "The build of 2026-11-21 09:00 compared with that of 2026-11-21 03:00:" in news


@pytest.mark.parametrize("source", ["https://github.com/me/rosml", "javascript:alert(1)", None])
def test_the_page_leads_to_its_source(source: str | None, page_of: PageOf, published: Published) -> None:
    windows = page_of(published.model_copy(update={"source": source, "images": (), "parts": ()}))
    link = windows().open().get_by_role("link", name="Source, documentation and questions")
    assert [item.get_attribute("href") for item in link.all()] == ([source] if source and source[:5] == "https" else [])


def test_a_narrow_list_can_be_used(window: Windows) -> None:
    page = window(NARROW).open()
    assert not page.locator('input[value="ros1-bookworm"]').is_visible(), "filters are folded"
    page.get_by_text("Filters", exact=True).click()
    page.locator('input[value="ros1-trixie"]').check()
    button = page.get_by_role("button", name="Copy the FROM line of ros1-trixie-core", exact=True)
    box = button.bounding_box()
    assert box and box["x"] >= 0 and box["x"] + box["width"] <= NARROW["width"]
    button.click()
    page.get_by_text(f"Copied: FROM {REGISTRY}/ros:ros1-trixie-core").wait_for()


@pytest.mark.parametrize("size", [NARROW, MIDDLE, WIDE], ids=lambda size: size["width"])
def test_a_screen_reader_gets_a_table(size: dict[str, int], window: Windows) -> None:
    """Cards are rows as well, and each says name, content, platforms, size, checks, date and status."""
    page = window(size).open(f"#/?q={TORCH}")
    nodes = tree(page)
    assert ("table", "Images") in nodes
    assert ("rowheader", f"{TORCH} ros-torch:ros1-bookworm-base-cu128") in nodes
    assert ("link", TORCH) in nodes and ("button", f"Copy the FROM line of {TORCH}") in nodes
    cells = [name for role, name in nodes if role in ("cell", "gridcell")]
    assert len(cells) == 7 and cells[1] == "amd64" and cells[4:6] == ["2026-11-22", "built"]
    assert all(text in " ".join(cells) for text in ("PyTorch 2.10.0", "unpacked", "scan passed"))
    assert ("searchbox", "Search names, versions and digests") in nodes
    assert not any(role in ("button", "link", "checkbox", "combobox") and not name for role, name in nodes)


def focused(page: Any) -> str:
    return str(
        page.evaluate(
            "(() => { const a = document.activeElement; return a.getAttribute('aria-label') || a.value || a.textContent; })()"
        )
    )


def tab_to(page: Any, text: str, most: int = 60) -> None:
    """Presses Tab until something has the focus."""
    seen = []
    for _ in range(most):
        page.keyboard.press("Tab")
        seen.append(focused(page))
        if seen[-1] == text:
            return
    pytest.fail(f"Tab does not lead to {text}: {seen}")


def test_keyboard_alone(window: Windows) -> None:
    page = window().open()
    page.keyboard.press("Tab")
    assert focused(page) == "Skip to the content"
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.id") == "main"
    page.keyboard.press("/")
    assert page.evaluate("document.activeElement.id") == "search"
    page.keyboard.type("torch base")
    tab_to(page, "ros1-bookworm")
    page.keyboard.press("Space")
    assert page.locator('input[value="ros1-bookworm"]').is_checked()
    ring = page.evaluate("getComputedStyle(document.activeElement.closest('label')).outlineStyle")
    assert ring == "solid", "one sees where one is"
    tab_to(page, f"Copy the FROM line of {TORCH}")
    page.keyboard.press("Enter")
    page.get_by_text("Copied: FROM").wait_for()
    tab_to(page, f"Compare {TORCH} with another one")
    page.keyboard.press("Enter")
    expect(page).to_have_title(re.compile("^Compare"))
    assert page.evaluate("document.activeElement.tagName") == "H1", "a new view begins at its heading"
    tab_to(page, "", most=3)  # the second field, which is empty
    page.keyboard.press("Shift+Tab")
    page.keyboard.press("Shift+Tab")
    assert focused(page) == "ros-torch:ros1-bookworm-base-cu128-20261122"


def test_colours_are_the_systems_or_those_that_one_chose(window: Windows) -> None:
    opened = window(scheme="dark")
    page = opened.open()

    def back() -> str:
        return str(page.evaluate("getComputedStyle(document.body).backgroundColor"))

    dark = back()
    page.get_by_label("Colours").select_option("light")
    light = back()
    assert light != dark
    page.reload()
    assert back() == light, "it was remembered"
    page.get_by_label("Colours").select_option("")
    assert back() == dark


# ---- Anywhere --------------------------------------------------------------------------------------------------------


@pytest.fixture
def host(folder: Path) -> Iterator[str]:
    """A static host that has the folder below a path."""
    handler = functools.partial(Quiet, directory=str(folder.parent))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}/{folder.name.replace(' ', '%20')}/"
        finally:
            server.shutdown()
            thread.join()


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_: Any) -> None:
        pass


def test_a_static_host_will_do(window: Windows, host: str, published: Published) -> None:
    opened = window()
    page = opened.open(ANY, base=host)
    assert len(listed(page)) == len(published.images)
    assert {address.partition("127.0.0.1:")[0] for address in opened.requests} <= {"http://", "data:,"}
    assert page.get_by_role("link", name="catalogue.json").get_attribute("href") == "catalogue.json"
    assert page.request.get(f"{host}catalogue.json").json()["format"] == 1


@pytest.mark.parametrize(("hours", "notice"), [(1, ""), (47, ""), (49, "This catalogue is 2 days old.")])
def test_a_catalogue_that_nobody_writes_anew_says_so(
    hours: int, notice: str, page_of: PageOf, published: Published
) -> None:
    created = (datetime.now(UTC) - timedelta(hours=hours)).strftime("%Y-%m-%dT%H:%M:%SZ")
    windows = page_of(published.model_copy(update={"created": created}))
    page = windows().open()
    assert page.locator("#old").is_visible() == bool(notice)
    assert (page.locator("#old").text_content() or "").startswith(notice)


def test_what_a_registry_says_is_text_and_never_markup(page_of: PageOf, published: Published) -> None:
    """Labels, versions and names of tests come out of images: whoever builds one must not script the page."""
    evil = "<img src=x onerror=\"document.title='owned'\"></script>\u2028"
    item = image(published, TORCH)
    platform = item.builds[0].platforms[0]
    tests = platform.tests and platform.tests.model_copy(update={"failures": (evil,)})
    odd = platform.model_copy(update={"versions": {evil: evil}, "tests": tests, "ros_sync": evil})
    build = item.builds[0].model_copy(update={"platforms": (odd,)})
    changed = with_image(published, item, builds=(build, *item.builds[1:]), reason=evil)
    sboms = tuple(sbom.model_copy(update={"part": evil}) for sbom in published.sboms)
    changed_all = changed.model_copy(update={"sboms": sboms})
    windows = page_of(changed_all, {sbom.digest: [(evil, evil, evil)] for sbom in sboms})
    opened = windows()
    for route in (f"#/image/{TORCH}", "#/", f"#/compare?a={TORCH}&b={evil}", "#/layers"):
        page = opened.open(route)
        if "image" in route:
            page.get_by_text("Packages, from the SBOMs").click()
            page.get_by_label("Search packages").wait_for()
        assert page.locator("main img").count() == 0 and "owned" not in page.title()


def test_a_thousand_images_are_little_work_for_a_browser(browser: Any, thousand: Path) -> None:
    """What makes the list quick: few files, and only as many rows as one sees, laid out some times and not for each."""
    facts = json.loads((thousand / "catalogue.json").read_text())
    assert len(facts["images"]) > 1000 and all(len(item["builds"][0]["platforms"]) == 2 for item in facts["images"])
    opened: Window = Windows(browser, thousand)(WIDE)
    session = opened.page.context.new_cdp_session(opened.page)
    session.send("Performance.enable")
    page = opened.open()
    metrics = {item["name"]: item["value"] for item in session.send("Performance.getMetrics")["metrics"]}
    LOG.info("%d images: %s, %d requests", len(facts["images"]), metrics, len(opened.requests))
    assert 60 <= page.locator(".list tbody tr").count() < 200
    assert metrics["Nodes"] < 5_000
    assert metrics["LayoutCount"] < 20
    assert len(opened.requests) <= 16
    assert opened.complaints == []
    page.context.close()
