"""Linters, one test each, so that pytest's summary counts them."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from fakes import exports
from rosml.containerize.init import file_texts
from rosml.images.image_set import load, own_set
from rosml.run.exports import compose_file
from tests.pages import blocks

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(sys.executable).parent
"""Where the linters' Python packages put their commands."""


def shellcheck() -> str:
    """Its package has wheels for x86-64 alone; elsewhere it is the machine's own."""
    program = shutil.which("shellcheck", path=f"{PROGRAMS}:{os.environ['PATH']}")
    assert program, "shellcheck is not there: apt-get install shellcheck"
    return program


def check(program: str, *arguments: str | Path) -> None:
    """Runs a linter in the checkout; fails with all that it says."""
    argv = [str(PROGRAMS / program), *map(str, arguments)]
    environment = {name: value for name, value in os.environ.items() if name != "ROSML_MATRIX"}
    done = subprocess.run(argv, cwd=ROOT, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        pytest.fail(f"{program}:\n{done.stdout}{done.stderr}", pytrace=False)


def shell_scripts() -> list[Path]:
    """Every shell script of the project."""
    folders = (".github", "components", "containerize", "tests", "scripts", "tools")
    scripts = [path for name in folders for path in (ROOT / name).rglob("*.*sh")]
    return sorted([*scripts, ROOT / ".ci/run", ROOT / "rosml"])


def test_ruff_check() -> None:
    check("ruff", "check", "--quiet", ".")


def test_ruff_format() -> None:
    check("ruff", "format", "--quiet", "--check", "--diff", ".")


def test_mypy() -> None:
    check("mypy", "--no-error-summary")


def test_shellcheck() -> None:
    scripts = shell_scripts()
    assert len(scripts) > 1
    check(shellcheck(), "--external-sources", *scripts)


UNSEEN = re.compile(r"<\(|\[\[ (?:! )?-[nz] \"?\$\(|\bfor \w+ in .*\$\(")
"""Where bash takes a command that failed for one that said nothing: `< <(…)`, `[[ -z $(…) ]]`, `for x in $(…)`."""


def test_no_script_of_a_build_takes_a_failure_for_nothing_to_do() -> None:
    folders = ("components", "tests/structure")
    scripts = [path for path in shell_scripts() if path.relative_to(ROOT).as_posix().startswith(folders)]
    lines = [
        f"{path.relative_to(ROOT)}:{number}: {line.strip()}: give the output a name, or a file, first"
        for path in scripts
        if path.name != "entrypoint.sh"  # it starts a container, with the groups that there are
        for number, line in enumerate(path.read_text().splitlines(), 1)
        if UNSEEN.search(line)
    ]
    assert not lines, "\n".join(lines)
    assert UNSEEN.search("mapfile -t names < <(colcon list)") and UNSEEN.search("if [[ -z $(colcon list) ]]; then")


def actionlint(*files: Path) -> None:
    """Checks workflows; all of the project's own if none is named."""
    program = shutil.which("actionlint", path=f"{ROOT / '.state/bin'}:{os.environ['PATH']}")
    assert program, "actionlint is not there: make lint builds it"
    local = r'specifying action "\$/\S+" in invalid format'  # it knows no actions of the workflow's own repository
    check(program, "-no-color", "-shellcheck", shellcheck(), "-pyflakes", "", "-ignore", local, *files)


def test_actionlint() -> None:
    """Workflows, and what they pass to shells."""
    actionlint()


def test_actionlint_of_the_examples() -> None:
    """The workflows that users copy."""
    files = sorted((ROOT / "examples").rglob(".github/workflows/*.yml"))
    assert files
    actionlint(*files)


@pytest.mark.parametrize("page", ["use/ci", "containerize/ci", "rebase"])
def test_actionlint_of_the_documentation(page: str, tmp_path: Path) -> None:
    """The workflows that users are shown."""
    shown = [block for block in blocks(ROOT / f"docs/{page}.md") if block.title.startswith(".github/workflows/")]
    assert shown
    for block in shown:
        (tmp_path / Path(block.title).name).write_text(block.text)
    actionlint(*tmp_path.iterdir())


EXPORTS = {
    "usual": """--mws -v data:/data --gpus '"device=0,1"' -e "A=$HOME 'y' \n" x ros2 launch $X""",
    "network": "--ros-network --cap-add SYS_NICE --ulimit rtprio=99 --health-cmd true x y 1e3",
    "networks": "--network lan -p 80:80 --mount type=tmpfs,dst=/t,tmpfs-mode=1777 --cpus=1.5 -m=1g x",
}
"""Calls of `rosml run`."""


@pytest.mark.parametrize("line", map(shlex.split, EXPORTS.values()), ids=EXPORTS)
def test_compose_takes_what_run_exports(line: list[str], tmp_path: Path) -> None:
    """Also what --add makes of a file with others; a file with a wrong word is refused."""
    program = shutil.which("composecheck", path=ROOT / ".state/bin")
    assert program, "composecheck is not there: make lint builds it"
    file = tmp_path / "compose.yaml"
    file.write_text(exports.text(*line, kind="compose"))
    check(program, file)
    file.write_text("# mine\nservices:\n  other:\n    image: y\n    # ports: [1]\nvolumes:\n  mine:\n")
    compose_file.add(file, exports.call(*line))
    check(program, file)
    file.write_text(file.read_text().replace("image: x", "images: x"))
    assert subprocess.run([program, file], capture_output=True, check=False).returncode == 1


@pytest.mark.parametrize("place", ["", "ghcr.io/me/rosml"])
def test_what_init_writes(place: str, tmp_path: Path) -> None:
    """`rosml init` of a package with upstream sources and requirements: its workflow and its Dockerfile."""
    project = file_texts.Project(
        name="robot",
        tag="ros:jazzy-base",
        place=place,
        ros=2,
        gpu=True,
        command="ros2 launch 'a b' x.launch.py",
        ended=True,
        pip=("requirements.txt",),
        repos="my robot.repos",
        is_one_of_several=True,
        packages=(".",),
        forge="github",
        source="me/rosml",
        revision="main",
    )
    for name, text in file_texts.texts(project).items():
        (tmp_path / Path(name).name).write_text(text)
    actionlint(tmp_path / Path(file_texts.GITHUB).name)
    check("hadolint", "--no-color", tmp_path / file_texts.DOCKERFILE)


@pytest.mark.parametrize("registry", ["ghcr.io/me/images", "registry.example.com/robots/images"])
def test_what_init_writes_for_a_set(registry: str, tmp_path: Path) -> None:
    """`rosml init --images`: its command and its workflow."""
    image_set = load.load(ROOT / "matrix.yaml", ROOT)
    chosen = own_set.chosen(image_set, [], [], registry, "")
    for address in ("https://github.com/me/rosml", "https://git.example.com/me/rosml"):
        for name, text in own_set.files(image_set, chosen, own_set.Upstream(address, "0" * 40)).items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text)
        check(shellcheck(), tmp_path / own_set.COMMAND)
    check(shellcheck(), tmp_path / own_set.NIGHT)
    actionlint(tmp_path / own_set.WORKFLOW)
    zizmor(tmp_path)


def zizmor(*places: str | Path) -> None:
    """The security of workflows and actions."""
    check("zizmor", "--offline", "--pedantic", "--strict-collection", "--no-progress", "--quiet", *places)


def test_zizmor() -> None:
    zizmor(".github", "containerize", "examples/ci")


def test_hadolint() -> None:
    check("hadolint", "--no-color", ROOT / "Dockerfile", ROOT / "tests/e2e/docker_ros/Dockerfile")
    examples = sorted((ROOT / "examples").rglob("Dockerfile"))
    newest = ("--ignore", "DL3008", "--ignore", "DL3013")  # as people write it
    check("hadolint", "--no-color", *newest, *examples)


def test_oxlint() -> None:
    """The page's JavaScript, which no build step reads before a browser does."""
    files = sorted((ROOT / "src/rosml/images/catalogue/page").glob("*.js"))
    assert files
    check("oxlint", "--config", "tests/lint/oxlint.json", "--deny-warnings", *files)


def test_generated_files_are_current() -> None:
    check("python", "scripts/generate_bake.py", "--check")
