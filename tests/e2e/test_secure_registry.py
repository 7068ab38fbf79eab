"""Publishing into a registry with TLS, an authority of its own, users and passwords: where they come from, what is said when
they are wrong, and that nobody reads them in an output, a log or a file."""

from __future__ import annotations

import json
import os
import shutil
import ssl
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from rosml.images.records.store import Records
from rosml.machine.services import Services
from rosml.registry import certificates
from rosml.registry.client import Registry
from rosml.registry.place import Place
from tests.e2e import mini as minis
from tests.e2e import secure
from tests.e2e.app_builds import write
from tests.e2e.builders import builder
from tests.e2e.calls import Run, rosml, run
from tests.e2e.images import NATIVE
from tests.e2e.mini import NOTHING, Mini, use
from tests.e2e.secure import NAME, PASSWORD, Secure, encoded

pytestmark = pytest.mark.usefixtures("own_builders")

ONLY = ("--only", "ros1-bookworm-core*", "--serve", NATIVE)
SECRETS = (PASSWORD, encoded(NAME, PASSWORD), encoded(NAME, "wrong-" + PASSWORD), json.dumps(PASSWORD)[1:-1])
HELPER = '#!/bin/sh\ntest "$1" = get || exit 1\nread -r server\nprintf "%s" "$(cat "$0.secret")"\n'


@dataclass
class Company(Mini):
    """The small project, on a machine that publishes into a company's registry.

    Attributes:
        secure: the registry. docker: the folder of Docker's config file.
    """

    secure: Secure
    docker: Path

    @property
    def registry(self) -> str:
        return f"{self.secure.host}/{self.prefix}"

    def elsewhere(self) -> Company:
        return Company(**{**vars(self), "prefix": super().elsewhere().prefix})

    def client(self) -> Registry:
        return Registry(self.secure.host)

    def login(self, **config: object) -> None:
        """Leaves Docker's config file as a way to log in does."""
        (self.docker / "config.json").write_text(json.dumps(config))


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Docker's configuration folder, of these tests alone."""
    with pytest.MonkeyPatch.context() as patch:
        folder = tmp_path_factory.mktemp("home") / "docker"
        patch.setenv("DOCKER_CONFIG", str(folder))
        patch.delenv("DOCKER_AUTH_CONFIG", raising=False)
        for name in ("no_proxy", "NO_PROXY"):
            patch.setenv(name, secure.own_address())
        yield folder


@pytest.fixture(scope="module")
def registry(environment: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Secure]:
    """One that asks for the password itself."""
    with secure.registry(tmp_path_factory.mktemp("secure") / "registry") as secured:
        secured.docker_config(environment, {})
        yield secured


@pytest.fixture(scope="module")
def issuing(registry: Secure, environment: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Secure]:
    """One that wants tokens; there is a user who may only read."""
    users = {NAME: "pull,push,delete", "reader": "pull"}
    with secure.registry(tmp_path_factory.mktemp("issuing") / "registry", users=users) as secured:
        place = environment / "certs.d" / secured.host
        place.mkdir()
        secured.authority.cert_pem.write_to_path(str(place / "ca.crt"))
        yield secured


@pytest.fixture(scope="module")
def project(
    services: Services, registry: Secure, issuing: Secure, environment: Path, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Company]:
    """The small project, whose builder was told of the certificates as by `rosml setup`."""
    folder = tmp_path_factory.mktemp("company")
    name = f"company-{os.getpid()}"
    trusted = certificates.by_host()
    assert set(trusted) == {registry.host, issuing.host}
    with builder(name, folder / "builder", services, certificates=trusted):
        (folder / "project").mkdir()
        mini = minis.make(folder / "project", services)
        trusting = use(mini.folder, builder=name, builder_kind="user")
        yield Company(mini.folder, trusting, mini.prefix, registry, environment)


@pytest.fixture
def company(project: Company) -> Company:
    project.mark()
    project.login(auths={project.secure.host: {"auth": encoded(NAME, PASSWORD)}})
    shutil.rmtree(project.folder / ".state/log", ignore_errors=True)
    return project.elsewhere()


def nothing_secret(company: Company, *runs: Run) -> None:
    """No output, log, or file of the checkout has a password."""
    texts = {f"output {number}": run.out + run.err for number, run in enumerate(runs)}
    for folder in (company.folder, company.secure.log.parent):
        for file in folder.rglob("*"):
            if file.is_file() and not file.is_relative_to(company.secure.storage) and file.stat().st_size < 1 << 24:
                texts[str(file)] = file.read_text(errors="replace")
    texts |= {str(file): file.read_text(errors="replace") for file in company.folder.parent.glob("*/log")}  # builders
    for place, text in texts.items():
        for secret in SECRETS:
            assert secret not in text, f"{place} has a secret"


def refused(outcome: Run, *says: str) -> None:
    """One sentence, and what to do about it."""
    lines = [line for line in outcome.err.splitlines() if not line.startswith("==>")]
    assert outcome.code in (1, 2), outcome
    assert len([line for line in lines if line.startswith("error:")]) == 1, outcome.err
    assert len([line for line in lines if line.startswith("remedy:")]) == 1, outcome.err
    assert len(lines) == 2, outcome.err
    for text in says:
        assert text in outcome.err


def test_everything(company: Company, tmp_path: Path) -> None:
    """Build, join, test, index, promote, status, undo, and an image of one's own."""
    first = company.publish("all", *ONLY, "--json")
    assert first.code == 0, first.err
    company.check()
    tags = company.tags()
    assert {"ros:ros1-bookworm-core", "ros-tf:ros1-bookworm-core-cpu", "part:tensorflow-cpu-py311"} <= tags.keys()
    status = company.publish("status", *ONLY, "--json")
    assert {item["state"] for item in json.loads(status.out)["images"]} == {"published"}
    company.mark(ros="2")
    second = company.publish("all", *ONLY, "--json")
    assert second.code == 0, second.err
    assert company.tags()["ros:ros1-bookworm-core"] != tags["ros:ros1-bookworm-core"]
    undone = company.publish("undo", "--json")
    assert undone.code == 0, undone.err
    assert company.tags()["ros:ros1-bookworm-core"] == tags["ros:ros1-bookworm-core"]
    pruned = company.publish("prune", "--days", "0", "--newest", "0", "--apply")
    assert pruned.code == 0, pruned.err
    mine = f"{company.registry}/mine:latest"
    parts = [f"{company.registry}/part:{name}" for name in minis.PARTS]
    ros = f"{company.registry}/ros:ros1-bookworm-core"
    joined = rosml("join", ros, *parts, "--tag", mine, "--json", root=company.folder)
    assert company.client().head(f"{company.prefix}/mine", "latest") == json.loads(joined.out)["digest"]
    nothing_secret(company, first, status, second, undone, pruned, joined)


@pytest.mark.parametrize("way", ["a credential helper", "the environment"])
def test_another_way_to_log_in(way: str, company: Company, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The environment counts more than the config file."""
    host = company.secure.host
    if way == "the environment":
        company.login(auths={host: {"auth": encoded(NAME, "wrong-" + PASSWORD)}})
        monkeypatch.setenv("DOCKER_AUTH_CONFIG", json.dumps({"auths": {host: {"auth": encoded(NAME, PASSWORD)}}}))
    else:
        secret = json.dumps({"ServerURL": host, "Username": NAME, "Secret": PASSWORD})
        write(tmp_path, {"docker-credential-local": HELPER, "docker-credential-local.secret": secret})
        monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
        company.login(credHelpers={host: "local"})
    outcome = company.publish("all", "--only", "ros1-bookworm-core", "--serve", NATIVE)
    assert outcome.code == 0, outcome.err
    assert "ros:ros1-bookworm-core" in company.tags()
    nothing_secret(company, outcome)


@pytest.mark.parametrize("password", ["wrong-" + PASSWORD, ""])
@pytest.mark.parametrize("tokens", [False, True])
def test_a_password_that_is_wrong_or_missing(
    company: Company, registry: Secure, issuing: Secure, password: str, tokens: bool
) -> None:
    company.secure = issuing if tokens else registry
    before = company.secure.repositories
    company.login(auths={company.secure.host: {"auth": encoded(NAME, password)}} if password else {})
    outcome = company.publish("all", *ONLY)
    refused(outcome, f"{company.secure.host}: access denied", f"remedy: docker login {company.secure.host}")
    assert company.secure.repositories == before
    nothing_secret(company, outcome)


def test_tokens_by_scope(company: Company, issuing: Secure) -> None:
    company.secure = issuing
    company.login(auths={issuing.host: {"auth": encoded(NAME, PASSWORD)}})
    outcome = company.publish("all", *ONLY, "--json")
    assert outcome.code == 0, outcome.err
    company.check()
    assert {"ros:ros1-bookworm-core", "ros-tf:ros1-bookworm-core-cpu"} <= company.tags().keys()
    assert f"repository:{company.prefix}/ros-tf:pull,push" in issuing.scopes
    nothing_secret(company, outcome)


def test_a_user_who_may_only_read_is_told_before_anything_is_built(company: Company, issuing: Secure) -> None:
    company.secure = issuing
    company.login(auths={issuing.host: {"auth": encoded("reader", PASSWORD)}})
    outcome = company.publish("all", *ONLY)
    refused(outcome, "push to", "with the account that is logged in", f"docker login {issuing.host}")
    assert "==> build" not in outcome.err
    assert not [name for name in issuing.repositories if name.startswith(company.prefix)]


@pytest.mark.parametrize("why", ["unknown", "expired"])
def test_a_certificate_that_is_not_trusted(
    company: Company, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, why: str
) -> None:
    with secure.registry(tmp_path / "registry", expired=why == "expired") as secured:
        host = secured.host
        login = {"auths": {host: {"auth": encoded(NAME, PASSWORD)}}}
        secured.docker_config(tmp_path / "docker", login, trust=why == "expired")
        if host.startswith("127."):
            pytest.skip("this machine has only a loopback address, where a registry without certs.d speaks plain http")
        monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
        company.secure = secured
        says = f"{host}: its certificate is not trusted: "
        if why == "expired":
            says = f"{says}certificate has expired\nremedy: its operator has to renew it"
        outcome = company.publish("all", *ONLY)
        refused(outcome, says)
        assert why == "expired" or f"{tmp_path}/docker/certs.d/{host}/ca.crt" in outcome.err
        program, target = str(company.folder / "src"), f"{host}/a:b"
        joined = run(sys.executable, program, "join", target, f"{host}/c:d", "--tag", f"{host}/e:f")
        refused(joined, says)
        assert secured.repositories == []
        nothing_secret(company, outcome, joined)
        log = secured.log.read_text()
        assert "Authorization" not in log and "PUT" not in log


def test_a_bundle_for_everything(
    company: Company, services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """SSL_CERT_FILE at `rosml setup`, which the builder has in its environment, and nothing in certs.d."""
    host = company.secure.host
    if host.startswith("127."):
        pytest.skip("this machine has only a loopback address, where a registry without certs.d speaks plain http")
    bundle = tmp_path / "bundle.pem"
    usual = services.ca_bundle or ssl.get_default_verify_paths().cafile
    bundle.write_bytes((Path(usual).read_bytes() if usual else b"") + company.secure.authority.cert_pem.bytes())
    company.secure.docker_config(tmp_path / "docker", {"auths": {host: {"auth": encoded(NAME, PASSWORD)}}}, trust=False)
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    machine = tmp_path / "machine"
    shutil.copytree(company.folder, machine, symlinks=True)
    (machine / "components/part/install-assembler.sh").write_text(NOTHING)  # nothing is tested
    name = f"bundle-{os.getpid()}"
    use(machine, builder=name, builder_kind="user", ca_bundle=str(bundle))
    company.folder = machine
    with builder(name, tmp_path / name, services, env={"SSL_CERT_FILE": str(bundle)}):
        outcome = company.publish("build", "--only", "ros1-bookworm-core", "--json")
    assert outcome.code == 0, outcome.err
    book = Records(Place(Registry(host, ca_bundle=str(bundle)), company.prefix))
    entry = book.read("ros1-bookworm-core", NATIVE)
    assert entry
    manifest = book.registry.manifest(f"{company.prefix}/ros", entry.digest)
    assert manifest and sum(layer.size for layer in manifest.layers) == entry.size
    nothing_secret(company, outcome)


def test_a_builder_that_was_not_told(company: Company, services: Services, tmp_path: Path) -> None:
    """Between the certificate's arrival and `rosml setup`."""
    machine = tmp_path / "machine"
    shutil.copytree(company.folder, machine, symlinks=True)
    use(machine, builder=services.builder, builder_kind=services.builder_kind)
    company.folder = machine
    outcome = company.publish("build", "--only", "ros1-bookworm-core")
    assert outcome.code == 1
    assert (
        "x509: certificate signed by unknown authority" in outcome.err
        and "rosml setup', which tells the builder" in outcome.err
    )
    assert company.tags() == {}
    nothing_secret(company, outcome)
