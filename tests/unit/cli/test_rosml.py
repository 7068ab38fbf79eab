"""The command `rosml`: its words, where it finds the matrix, what it needs, completion; and as an installed wheel."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
import zipfile
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import click
import pytest
from click.testing import CliRunner
from conftest import ROOT, SMALL

import rosml
from fakes.http_registry import local_registry
from rosml.base import environment, project_addresses
from rosml.cli import checkout, main
from rosml.cli.command import as_called, call
from rosml.images.image_set import load
from rosml.registry.client import Registry
from tests.e2e import parts

IMAGES = load.load(ROOT / "matrix.yaml").images
JOINED = next(image for image in IMAGES if image.stack)
DISTRIBUTIONS = list(dict.fromkeys(image.distribution for image in IMAGES))


def commands(group: click.Group, before: str = "") -> Iterator[tuple[str, click.Command]]:
    for name, command in group.commands.items():
        yield f"{before}{name}", command
        if isinstance(command, click.Group):
            yield from commands(command, f"{before}{name} ")


ALL = dict(commands(main.cli))


def test_its_help_ends_with_where_to_find_more(wheel: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pages = (
        "Help:\n  Pages: docs/. Messages and remedies: docs/troubleshooting.md.\n"
        "  Report problems as issues of the repository "
    )
    assert CliRunner().invoke(main.cli, ["--help"]).output.endswith(f"{pages}that you cloned.\n")
    assert installed(wheel, tmp_path, "--help").stdout.endswith(f"{pages}that rosml was installed from.\n")
    copy = tmp_path / "site"
    shutil.copytree(wheel, copy)
    (record,) = copy.glob("rosml-*.dist-info/METADATA")
    head, body = record.read_text().split("\n\n", 1)
    record.write_text(f"{head}\nProject-URL: Issues, https://forge.example/rosml/issues\n\n{body}")
    assert installed(copy, tmp_path, "--help").stdout.endswith("Help:\n  Issues: https://forge.example/rosml/issues\n")
    (tmp_path / "pyproject.toml").write_text('[project.urls]\nDocumentation = "https://docs.example/rosml"\n')
    monkeypatch.setattr(project_addresses, "ROOT", tmp_path)
    output = CliRunner().invoke(main.cli, ["--help"]).output
    assert output.endswith("Help:\n  Documentation: https://docs.example/rosml\n")


@pytest.mark.parametrize("words", ["", *(name for name, command in ALL.items() if isinstance(command, click.Group))])
def test_a_list_of_commands_has_one_whole_sentence_for_each(words: str) -> None:
    done = CliRunner(env={"COLUMNS": "80"}).invoke(main.cli, [*words.split(), "--help"])
    group = ALL[words] if words else main.cli
    assert isinstance(group, click.Group)
    for name, command in group.commands.items():
        lines = re.findall(rf"^  {name}  +(\S.*)$", done.output, re.MULTILINE)
        assert len(lines) == (0 if command.hidden else 1)
        assert all(line.endswith(".") and len(line) > 20 for line in lines), lines


def test_its_version(wheel: Path, tmp_path: Path) -> None:
    output = CliRunner().invoke(main.cli, ["--version"]).output
    assert output == installed(wheel, tmp_path, "--version").stdout == f"rosml, version {rosml.__version__}\n"
    assert (wheel / f"rosml-{rosml.__version__}.dist-info").is_dir()


def test_a_target_and_a_tag_are_both_understood() -> None:
    def explained(name: str) -> object:
        return json.loads(CliRunner().invoke(main.cli, ["explain", name, "--json"]).output)

    facts = explained(JOINED.target)
    assert facts == explained(JOINED.tags[0])
    assert isinstance(facts, dict) and facts["exists"] and len(facts["reasons"]) > 3


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_shells_complete(shell: str) -> None:
    def completion(instruction: str, **facts: str) -> str:
        env = {**os.environ, "_ROSML_COMPLETE": f"{shell}_{instruction}", **facts}
        return subprocess.run([sys.executable, "src"], cwd=ROOT, env=env, capture_output=True, text=True).stdout

    assert "rosml" in completion("source")
    begun = JOINED.target[:-2]
    words = {"COMP_WORDS": f"rosml explain {begun}", "COMP_CWORD": begun if shell == "fish" else "2"}
    assert JOINED.target in completion("complete", **words)
    assert "publish" in completion("complete", COMP_WORDS="rosml pu", COMP_CWORD="pu" if shell == "fish" else "1")


def test_a_command_to_try_is_one_that_its_caller_can_call(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "/usr/bin:/bin")
    monkeypatch.chdir(ROOT)
    assert (call(), call(tmp_path)) == ("./rosml", f"{ROOT}/rosml")
    monkeypatch.chdir(tmp_path)
    assert (call(), call(ROOT)) == (f"{ROOT}/rosml", "./rosml")
    (tmp_path / "rosml").symlink_to("/bin/true")
    monkeypatch.setenv("PATH", str(tmp_path))
    assert call() == f"{ROOT}/rosml", "that is another one"
    (tmp_path / "rosml").unlink()
    (tmp_path / "rosml").symlink_to(ROOT / "rosml")
    assert call() == "rosml"
    (tmp_path / "my set").mkdir()
    monkeypatch.setattr("rosml.cli.command.MATRIX", tmp_path / "my set/set.yaml")
    (tmp_path / "my set/rosml").touch()
    assert call() == f"'{tmp_path}/my set/rosml'"
    monkeypatch.setattr("rosml.cli.command.IN_CHECKOUT", False)
    assert call() == "rosml"


def test_setup_names_the_command_as_its_caller_calls_it() -> None:
    """It works in the checkout, wherever it was called."""
    for folder, program in ((Path("/"), f"{ROOT}/rosml"), (ROOT, "./rosml")):
        words = [sys.executable, str(ROOT / "scripts/bootstrap.py"), "status", "--nonsense"]
        env = {**os.environ, "PATH": ABSOLUTE}
        done = subprocess.run(words, cwd=folder, env=env, capture_output=True, text=True, check=False)
        assert f"Try '{program} setup status --help' for help." in done.stderr


@pytest.mark.parametrize(
    ("text", "called"),
    [
        ("run 'rosml setup', then run it again", "run './rosml setup', then run it again"),
        ("rosml setup down; rosml setup clean", "./rosml setup down; ./rosml setup clean"),
        ("it is: ./rosml list", "it is: ./rosml list"),
        ("ROS_CHANNEL=testing rosml image x, or rosml list", "ROS_CHANNEL=testing ./rosml image x, or ./rosml list"),
        ("cat x | rosml load - < x", "cat x | ./rosml load - < x"),
        ("Usage: rosml [OPTIONS]\nTry 'rosml --help'", "Usage: ./rosml [OPTIONS]\nTry './rosml --help'"),
        ("--push is an option of rosml containerize", "--push is an option of rosml containerize"),
        ("uvx --from git+https://… rosml init", "uvx --from git+https://… rosml init"),
        ("call /opt/rosml/rosml list; rosml is older", "call /opt/rosml/rosml list; rosml is older"),
    ],
)
def test_a_message_names_the_command_as_its_reader_calls_it(
    text: str, called: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    assert as_called(text) == called
    monkeypatch.setattr("rosml.cli.command.IN_CHECKOUT", False)
    assert as_called(text) == called.replace("./rosml", "rosml")


@pytest.mark.parametrize(
    ("words", "ours"),
    [
        ("image --arch arm64 x", "--platform"),
        ("part --architecture arm64", "--platform"),
        ("containerize --arch=arm64", "--platform"),
        ("plan --platform linux/arm64", "--architecture"),
    ],
)
def test_an_option_for_a_machine_is_named(words: str, ours: str) -> None:
    output = CliRunner().invoke(main.cli, words.split()).output
    assert re.search(rf"No such option '--\w+'\. It is {ours} here\.", output), output


def test_where_the_matrix_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In the checkout that the package is in, or with what came with the package; the current folder decides nothing."""
    package, project = tmp_path / "lib/site-packages/rosml", stranger(tmp_path / "project")
    monkeypatch.chdir(project)
    assert rosml.root_of(package) == package / "data"
    assert rosml.root_of(project / "vendor/rosml") == project / "vendor/rosml/data", "somebody installed it in there"
    assert rosml.root_of(project / "src/rosml") == project


def stranger(folder: Path) -> Path:
    """A folder that looks like a checkout. Its programs write down that they ran."""
    for name in (*checkout.PARTS, "src/rosml/x", ".state/bin/x", ".venv/bin/x"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    mark = f"open({str(folder / 'ran')!r}, 'a').write('x')"
    (folder / "scripts/bootstrap.py").write_text(f"{mark}\n")
    program = f"#!{sys.executable}\n{mark}\n"
    programs = [
        folder / name for name in ("rosml", "docker", "podman", "git", "buildx", ".state/bin/uv", ".venv/bin/python")
    ]
    for file in programs:
        file.write_text(program)
        file.chmod(0o755)
    facts: dict[str, object] = {
        "registry": "127.0.0.1:1",
        "buildx": [str(folder / "buildx")],
        "builder": "x",
        "builder_kind": "user",
    }
    facts |= {"buildx_config": None, "uv": str(folder / "buildx"), "ca_bundle": ""}
    (folder / ".state/services.json").write_text(json.dumps({**facts, "bases": [str(folder / "buildx")]}))
    return folder


# ---- Installed, without a checkout -----------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (file,) = folder.glob("rosml-*.whl")
    with zipfile.ZipFile(file) as archive:
        for member in archive.infolist():  # as pip does: what is a program stays one
            path = Path(archive.extract(member, folder / "site"))
            if member.external_attr >> 16 & 0o111:
                path.chmod(path.stat().st_mode | 0o111)
    return folder / "site"


def installed(
    wheel: Path, folder: Path, *words: str, cwd: Path | None = None, **environment: str
) -> subprocess.CompletedProcess[str]:
    """Runs the command in a folder, with nothing of the checkout in reach, nor packages besides if PYTHONPATH is set."""
    env = {"PATH": "/usr/bin:/bin", "HOME": str(folder / "home"), "PYTHONPATH": str(wheel), **environment}
    program = folder / "rosml"
    program.write_text("import sys\nfrom rosml.cli.main import run\nsys.exit(run())\n")
    argv = [sys.executable, *["-S"] * ("PYTHONPATH" in environment), str(program), *words]
    return subprocess.run(argv, cwd=cwd or folder, env=env, capture_output=True, text=True, check=False)


def from_source(repository: Path, words: str) -> subprocess.CompletedProcess[str]:
    argv = [sys.executable, "src", *words.split()]
    return subprocess.run(argv, cwd=repository, capture_output=True, text=True, check=False)


def test_what_needs_no_checkout(wheel: Path, tmp_path: Path) -> None:
    listed = installed(wheel, tmp_path, "list", "--json")
    assert listed.returncode == 0, listed.stderr
    assert json.loads(listed.stdout) == json.loads(CliRunner().invoke(main.cli, ["list", "--json"]).output), (
        "the same images, and the same inputs"
    )
    assert installed(wheel, tmp_path, "explain", JOINED.target).stdout.startswith(f"{JOINED.target} exists")
    assert not (wheel / "rosml/data/.state").exists()


def test_states_of_a_registry(wheel: Path, tmp_path: Path) -> None:
    with local_registry() as place:
        options = ("--registry", f"{place.address}/rosml", "--only", IMAGES[0].target, "--json")
        done = installed(wheel, tmp_path, "status", *options)
        assert done.returncode == 0, done.stderr
        assert {image["target"] for image in json.loads(done.stdout)["images"]} >= {IMAGES[0].target}
        page = installed(wheel, tmp_path, "catalogue", *options[:4])
        assert page.returncode == 0, page.stderr
    assert (tmp_path / "home/.cache/rosml/catalogue/index.html").is_file()
    assert not (wheel / "rosml/data/.state").exists()


def test_an_image_is_joined(wheel: Path, tmp_path: Path) -> None:
    with local_registry() as place, Registry(place.address) as client:
        ros = parts.ros().put(client, "me/ros", "ros1-bookworm-core", ["linux/amd64"])
        stack_parts = parts.stack(client, "me/part", ("cuda", "common", "torch"), "cu128")
        tag = f"{place.address}/me/mine:latest"
        done = installed(wheel, tmp_path, "join", ros, *stack_parts, "--tag", tag)
        assert done.returncode == 0, done.stderr
        assert done.stdout.startswith(f"{tag}@{client.head('me/mine', 'latest')}\n")
    assert not (wheel / "rosml/data/.state").exists()


def test_an_image_is_run(wheel: Path, tmp_path: Path) -> None:
    engine = '#!/bin/sh\ncase $1 in\n  run) printf "%s|" "$@"; exit 3 ;;\n  image) echo \'{"Id": "x", "Config": {}}\' ;;\n  *) echo "{}" ;;\nesac\n'
    (tmp_path / "docker").write_text(engine)
    (tmp_path / "docker").chmod(0o755)
    words = ("run", "--no-gpu", "--no-tz", "--no-user", "-eA=b c", "ubuntu", "echo", "a  b")
    done = installed(wheel, tmp_path, *words, PATH=str(tmp_path))
    assert (done.returncode, done.stderr) == (3, "")
    assert done.stdout.endswith("|-eA=b c|ubuntu|echo|a  b|")
    assert not (wheel / "rosml/data/.state").exists()


def test_images_are_run_without_what_publishing_needs(wheel: Path, tmp_path: Path) -> None:
    site = tmp_path / "site"
    site.mkdir()
    for name in environment.RUN:
        (site / name).symlink_to(Path(import_module(name).__file__ or "").parent)

    def call(*words: str) -> subprocess.CompletedProcess[str]:
        return installed(wheel, tmp_path, *words, PATH=str(tmp_path), PYTHONPATH=f"{wheel}:{site}")

    engine = '#!/bin/sh\ncase $1 in image) echo \'{"Id": "x", "Config": {}}\' ;; run) echo ran ;; esac\n'
    (tmp_path / "docker").write_text(engine)
    (tmp_path / "docker").chmod(0o755)
    assert (call("run", "ubuntu").stdout, call("--help").returncode) == ("ran\n", 0)
    assert call("run", "--export", "compose", "ubuntu").stdout.startswith("services:\n")
    for other in ("list", "containerize"):
        done = call(other)
        assert done.returncode == 2 and done.stderr.startswith(
            f"error: no command {other} here: not installed: {', '.join(environment.IMAGES)}\n"
        )
        assert "pipx install --force ." in done.stderr and "uv tool install" in done.stderr


ABSOLUTE = "/usr/bin:/bin"
OF_A_CHECKOUT = ("setup", "setup up", "setup clean", "image", "publish all")
CALLS = [
    *((words, ABSOLUTE) for words in (*OF_A_CHECKOUT, "containerize .", "list")),
    *((words, f"{here}:{ABSOLUTE}") for words in ("containerize .", "run x", "init -y ros") for here in ("", ".")),
]


@pytest.mark.parametrize(("words", "path"), CALLS)
def test_the_installed_command_runs_nothing_of_the_folder(wheel: Path, tmp_path: Path, words: str, path: str) -> None:
    """The folder looks like a checkout, and is a stranger's. No program of it runs, and its services are not believed."""
    folder = stranger(tmp_path / "a repository")
    (folder / "ros").mkdir()
    (folder / "ros/package.xml").write_text("<package><name>robot</name></package>")
    (tmp_path / "call").mkdir()
    done = installed(wheel, tmp_path / "call", *words.split(), cwd=folder, PATH=path)
    assert not (folder / "ran").exists()
    assert "Traceback" not in done.stderr
    if words in OF_A_CHECKOUT:
        remedy = f"call its own command: '{folder}/rosml'\n"
        assert (done.returncode, done.stderr.endswith(remedy)) == (2, True), done.stderr
    if words.startswith("init"):
        assert done.returncode == 0 and (folder / "ros/.env").is_file()
    if words == "list":
        assert done.returncode == 0 and done.stderr.startswith(
            f"warning: the matrix is the one that came with rosml, and not that of {folder}\n"
        )


def test_a_matrix_of_the_folder_is_read_if_it_is_named(wheel: Path, tmp_path: Path) -> None:
    stranger(tmp_path)
    (tmp_path / "matrix.yaml").write_text(SMALL)
    assert installed(wheel, tmp_path, "explain", IMAGES[0].target).returncode == 0, "it is not asked for"
    done = installed(wheel, tmp_path, "list", "--matrix", "matrix.yaml", "--json")
    assert (done.returncode, done.stderr) == (0, "")
    assert "alpha" in done.stdout and not (tmp_path / "ran").exists()
    (tmp_path / "matrix.yaml").write_text(f"{SMALL}mine: 1\n")
    done = installed(wheel, tmp_path, "list", "--matrix", "matrix.yaml")
    assert (done.returncode, done.stderr.startswith("matrix.yaml:")) == (2, True), done.stderr


@pytest.mark.parametrize("words", ["image", "diff HEAD", "publish all"])
def test_what_needs_one_says_so(wheel: Path, tmp_path: Path, words: str) -> None:
    done = installed(wheel, tmp_path, *words.split())
    assert done.returncode == 2
    assert "error: not in a checkout" in done.stderr
    assert "remedy: git clone the project" in done.stderr


@pytest.mark.parametrize("words", ["status", "catalogue"])
def test_without_a_checkout_a_registry_is_named(wheel: Path, tmp_path: Path, words: str) -> None:
    done = installed(wheel, tmp_path, words)
    assert done.returncode == 1
    assert done.stderr == "error: no registry is named\nremedy: name a registry with --registry\n"


def test_what_is_wrong_is_told_before_services_are_asked_for(repository: Path) -> None:
    for words, says in {
        "plan --date nonsense": "'nonsense' is no time",
        "plan --only nonsense": "no image named 'nonsense'",
        "publish test --plan matrix.yaml": "matrix.yaml is no plan",
    }.items():
        done = from_source(repository, words)
        assert (done.returncode, says in done.stderr) == (2, True), done.stderr


def test_a_file_that_is_no_text_is_named(repository: Path) -> None:
    for name, words in (("Dockerfile", "list --json"), ("docs/tags.md", "generate --check")):
        file = repository / name
        whole = file.read_bytes()
        file.write_bytes(b"# \n\xff" + whole)
        done = from_source(repository, words)
        assert done.returncode == 2
        assert done.stderr == f"error: {name}:2: not UTF-8 (byte 0xff)\nremedy: save the file as UTF-8\n"
        file.write_bytes(whole)


GONE = "mkdir gone && cd gone && rmdir ../gone && "


@pytest.mark.parametrize(
    ("before", "environment"),
    [(GONE, {}), ("", {"XDG_CACHE_HOME": "rel"}), ("", {"HOME": ""}), ("", {"_ROSML_COMPLETE": "nonsense"})],
    ids=["no folder", "odd cache", "no home", "completion"],
)
def test_odd_surroundings(wheel: Path, tmp_path: Path, before: str, environment: dict[str, str]) -> None:
    script = f'{before}"$0" -m rosml list --json'
    env = {"PATH": "/usr/bin:/bin", "HOME": str(tmp_path), "PYTHONPATH": str(wheel), **environment}
    argv = ["bash", "-c", script, sys.executable]
    done = subprocess.run(argv, cwd=tmp_path, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)


@pytest.mark.parametrize(("name", "value"), [("HTTPS_PROXY", "socks5://me:secret@x:1"), ("ALL_PROXY", "ftp://x")])
def test_a_proxy_of_another_kind(wheel: Path, tmp_path: Path, name: str, value: str) -> None:
    words = ("status", "--registry", "registry.invalid/x", "--only", IMAGES[0].target, "--json")
    done = installed(wheel, tmp_path, *words, cwd=None, **{name: value})
    assert done.returncode == 2 and "secret" not in done.stderr
    assert name in json.loads(done.stdout)["error"]


TARGETS = "|".join(re.findall(r"^([a-z-]+):.*## ", (ROOT / "Makefile").read_text(), re.MULTILINE))
MAKES = re.compile(rf"\bmake ({TARGETS})\b|publish\.py [a-z]")
"""A command in other words than its own."""


def texts_with_commands() -> Iterator[str]:
    """Texts of the library that name a command; what people write about code is none of them."""
    for file in sorted((ROOT / "src/rosml").rglob("*.py")):
        tree = ast.parse(file.read_text())
        notes = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        texts = [node for node in ast.walk(tree) if isinstance(node, ast.Constant) and id(node) not in notes]
        yield from (node.value for node in texts if isinstance(node.value, str) and "rosml " in node.value)


def exists(words: list[str]) -> bool:
    command: click.Command = main.cli
    while isinstance(command, click.Group) and words and words[0] in command.commands:
        command, words = command.commands[words[0]], words[1:]
    options = {name for parameter in command.get_params(click.Context(command)) for name in parameter.opts}
    words = words[: [*words, "--"].index("--")]  # a command in a container stands after it
    return command is not main.cli and {word for word in words if word.startswith("--")} <= options


def unknown_commands(text: str) -> list[str]:
    calls = re.findall(r"(?:['(]|[:;] |^ +)rosml ([a-z-]+(?: +(?:--)?[a-z-]+)*)", text, re.MULTILINE)
    return [call for call in calls if not exists(call.split())]


def test_every_command_that_a_message_names_is_one_that_there_is() -> None:
    texts = sorted(set(texts_with_commands()))
    assert len(texts) > 20
    assert [call for text in texts for call in unknown_commands(text)] == []


@pytest.mark.parametrize("name", ALL)
def test_each_has_its_help(name: str) -> None:
    """Which names commands that exist."""
    done = CliRunner().invoke(main.cli, [*name.split(), "--help"])
    assert done.exit_code == 0 and "Usage: " in done.output and ALL[name].help
    assert not MAKES.search(" ".join(done.output.split()).replace("`make test`", ""))
    assert not unknown_commands(ALL[name].help or "")


@pytest.mark.parametrize("name", ["", *ALL])
def test_help_fits_on_lines_of_100_columns(name: str) -> None:
    """Options, examples and tables, too, which click never wraps."""
    output = CliRunner(env={"COLUMNS": "100"}).invoke(main.cli, [*name.split(), "--help"]).output
    assert [line for line in output.splitlines() if len(line) > 100] == []


def test_an_interrupted_join_ends_at_once(wheel: Path, tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as hole:
        host = f"127.0.0.1:{hole.getsockname()[1]}"
        env = {"PATH": "/usr/bin:/bin", "HOME": str(tmp_path), "PYTHONPATH": str(wheel)}
        argv = [sys.executable, "-m", "rosml", "join", f"{host}/a:b", f"{host}/c:d", "--tag", f"{host}/x:y"]
        process = subprocess.Popen(argv, cwd=tmp_path, env=env, stderr=subprocess.PIPE, text=True)
        hole.accept()
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=20)
    assert process.returncode == 130
    assert "no tag was moved" in errors
