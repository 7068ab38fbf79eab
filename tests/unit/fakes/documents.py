"""Valid documents of each parser in `parsers`."""

from __future__ import annotations

import json
from typing import Any

from rosml.containerize import lock
from rosml.images.publish import issue
from rosml.images.records import store
from rosml.registry import oci

DIGEST = f"sha256:{'1' * 64}"

ROOTFS = {"type": "layers", "diff_ids": [oci.digest_of(b"")]}
SAVED = oci.encoded({"os": "linux", "architecture": "amd64", "rootfs": ROOTFS})
LAYERS = [oci.descriptor("application/vnd.oci.image.layer.v1.tar", b"")]
SAVED_CONTENT = oci.encoded({"schemaVersion": 2, "config": oci.descriptor(oci.CONFIG, SAVED), "layers": LAYERS})

SAVED_MANIFEST = oci.descriptor(oci.IMAGE, SAVED_CONTENT)

MANIFEST = """\
<?xml version="1.0" encoding="utf-8"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>robot</name>
  <version>0.1.0</version>
  <description>Moves é</description>
  <maintainer email="me@example.org">Me</maintainer>
  <license>MIT</license>
  <depend condition="$ROS_VERSION == 2">rclpy</depend>
  <test_depend>python3-pytest</test_depend>
</package>
""".encode()

ENV = b"""\
# comment
export BASE_IMAGE=ros:jazzy-base
COMMAND='ros2 run a b'
CMAKE_ARGS="-DA=\\"1\\" \\
 -DB=2"
PUSH=false # no
"""

REPOS = b"repositories:\n  a/b: {type: git, url: https://example.org/a.git, version: 1.10}\n"

LOCK = lock.Lock(
    base_image=lock.Image(name="ros:jazzy-base", digest=DIGEST),
    repositories={"up": lock.Pin(url="https://example.org/up.git", version="main", commit="c" * 40)},
    apt={"amd64": {"tree": "2.1", "libc6:i386": "1:2.36+b1~x"}},
    pip={"amd64": [f"toolz==1.0 --hash=sha256:{'0' * 64}", f"a @ git+https://example.org/a@{'c' * 40}"]},
)

KEYS = (
    b"boost:\n  ubuntu: &a [libboost-dev]\n  debian:\n    bookworm: *a\nnumpy: {ubuntu: {pip: {packages: [numpy]}}}\n"
)

INDEX = (
    b"distributions:\n  jazzy: {distribution: [jazzy/distribution.yaml], distribution_status: active}\ntype: index\n"
)

SUITE = """<testsuites><testsuite name="robot"><testcase name="good" classname="a"/>
<testcase name="later"><skipped/></testcase><testcase name="bad"><failure message="1 is not 2"/></testcase>
</testsuite><testsuite name="bad" failures="1"/></testsuites>"""

CTEST = """<Site><Testing><Test Status="failed"><Name>bad</Name><FullCommandLine>bad</FullCommandLine><Results>
<NamedMeasurement name="Exit Code"><Value>SEGFAULT</Value></NamedMeasurement>
<Measurement><Value>last</Value></Measurement></Results></Test></Testing></Site>"""

LISTS = ("packages", "changed", "replaced", "removed", "built", "lost", "absent", "outside", "pip")
APP: dict[str, Any] = {name: [] for name in LISTS}
APP |= {"architecture": "amd64", "apt": {"tree": "2.1"}, "forgotten": {}}

JOB = {"target": "run", "name": "ghcr.io/me/robot", "tags": ["latest"], "end": "-amd64", "platforms": ["linux/amd64"]}
JOB |= {"digest": DIGEST}

PACKAGES = {
    "system": {"name": "debian", "version": "12"},
    "apt": [{"name": "tree", "version": "2", "architecture": "amd64", "source": "tree", "source_version": "2"}],
    "python": [{"name": "toolz", "version": "1.0"}],
    "ros": [{"name": "robot", "version": "1.0.0", "licenses": ["MIT"]}],
}

PIP = {
    "version": "1",
    "install": [
        {
            "download_info": {
                "url": "https://example.org/a-1.whl",
                "archive_info": {"hash": f"sha256={'0' * 64}", "hashes": {"sha256": "0" * 64}},
            },
            "is_direct": False,
            "metadata": {"name": "a_b", "version": "1.0"},
        },
        {
            "download_info": {
                "url": "https://example.org/b",
                "vcs_info": {"vcs": "git", "commit_id": "c" * 40, "requested_revision": "main"},
                "subdirectory": "python",
            },
            "is_direct": True,
            "metadata": {"name": "b", "version": "1.0"},
        },
        {
            "download_info": {"url": "file:///x", "dir_info": {}},
            "is_direct": True,
            "metadata": {"name": "c", "version": "1"},
        },
    ],
}

STATUS = b"""\
Package: libc6
Status: install ok installed
Architecture: amd64
Source: glibc (2.36-9)
Version: 2.36-9+b1
Description: library
 of many lines
 .
 Moves \xc3\xa9

Package: tree
Status: install ok installed
Architecture: all
Version: 1:2.1
"""

FLEET = b"""\
apps:
  - app: ghcr.io/me/robot:v*
    base: ghcr.io/us/ros:jazzy-base
  - {app: a.example/b, check: run, command: c}
"""

LIBRARY = {"path": "a.so", "id": "0" * 40, "soname": "a", "machine": [2, 1, 62]}
LIBRARY |= {"needed": ["b"], "symbols": "AAAA", "uses": ["c@D"]}

FACTS = {
    "packages": [{"name": "a", "architecture": "all", "version": "1", "depends": "b (>= 1)", "files": ["c"]}],
    "libraries": [LIBRARY],
    "files": ["d"],
}

LAUNCH = b"""\
<launch>
  <arg name="x" default="y"/>
  <node pkg="a" exec="b" name="c" if="$(var x)"><param from="$(find-pkg-share a)/config/d.yaml"/></node>
  <include file="$(find a)/launch/e.launch"/>
</launch>
"""

LAUNCH_IN_PYTHON = b"""\
#!/usr/bin/env python3
import a, json
from launch_ros.actions import Node

def generate_launch_description():
    return [Node(package="a", executable="b")]
"""

ENTRY_POINTS = b"[console_scripts]\nb = a.b:main\nc = a.c:main [d]\n"

MODULES = b"""\
[submodule "a"]
\tpath = a
\turl = ../a.git
[submodule "b/c"]
\tpath = "b/c"
\turl = https://example.org/c.git
"""

SETTINGS = (
    b"submodule.a.path\na\0submodule.a.url\n../a.git\0submodule.b.path\nb\0submodule.b.url\nhttps://example.org/b\0"
)

REFS = f"{'c' * 40}\tHEAD\n{'c' * 40}\trefs/heads/main\n{'d' * 40}\trefs/tags/1.0\n{'e' * 40}\trefs/tags/1.0^{{}}\n".encode()

ENTRY = store.Entry(
    "alpha-base",
    "amd64",
    inputs="i",
    repository="ros",
    digest=DIGEST,
    parts={"cuda": DIGEST},
    size=1,
    passed=2,
    failures=("a",),
    scan={"findings": {"high": 1}, "packages": 2, "updated": "2026-11-22T03:00:00Z", "failing": ["CVE-1"]},
    seconds={"build": 1.5},
    superseded=(DIGEST,),
).to_json()

HEADERS = (
    b'Bearer realm="https://auth.test/token",service="a",scope="repository:a:pull"',
    b'</v2/a/tags/list?last=x&n=1000>; rel="next"',
    b"Fri, 31 Dec 2027 23:59:59 GMT",
    b"application/vnd.oci.image.index.v1+json; charset=utf-8",
)

LISTED = {
    "schemaVersion": 2,
    "mediaType": oci.INDEX,
    "manifests": [
        {"mediaType": oci.IMAGE, "digest": DIGEST, "size": 1, "annotations": {"a": "b"}, "artifactType": "a/b"}
        | {"platform": {"os": "linux", "architecture": "arm64", "variant": "v8"}}
    ],
}

BASED: dict[str, Any] = {
    "architecture": "amd64",
    "os": "linux",
    "config": {
        "Env": ["PATH=/bin", "A=b"],
        "Entrypoint": ["/entrypoint.sh"],
        "Cmd": ["bash"],
        "User": "1000:1000",
        "Labels": {
            "io.rosml.distribution": "alpha",
            "io.rosml.component": "core",
            "io.rosml.stack": "cpu",
            "io.rosml.app": "run",
            "io.rosml.parts": "cuda-cu1 torch-cu1",
            "io.rosml.brings": "torch=2.10.0",
            "io.rosml.restricted": "nccl",
            "io.rosml.lock": LOCK.line(),
            "io.rosml.variants": "cpu cu130:580",
            "org.opencontainers.image.base.name": "registry.test/ros:alpha-core",
            "org.opencontainers.image.base.digest": DIGEST,
        },
    },
    "history": [
        {"created_by": "ADD /"},
        {"created_by": "COPY / / # buildkit", "comment": "buildkit.dockerfile.v0"},
        {"created_by": "ARG APP_A=b", "empty_layer": True},
        {"created_by": "ENV A=b", "empty_layer": True},
    ],
    "rootfs": {"type": "layers", "diff_ids": [oci.digest_of(b"a"), oci.digest_of(b"b")]},
}

RELEASE = f"""\
Origin: Debian
Suite: stable
Date: Sat, 21 Nov 2026 10:11:12 UTC
SHA256:
 {"0" * 64} 1234 main/binary-amd64/Packages
 {"1" * 64} 1234 main/binary-all/Packages
""".encode()

LINES = b"deb http://archive.test/debian bookworm main\ndeb [arch=amd64] http://archive.test/debian x main # x\n"

STANZAS = b"Types: deb\nURIs: http://archive.test/debian\nSuites: bookworm\n bookworm-updates\nComponents: main\n\nTypes: deb-src\n"

SBOM = {
    "bomFormat": "CycloneDX",
    "specVersion": "1.6",
    "metadata": {"component": {"name": f"registry.test/ros@{DIGEST}", "type": "container"}},
    "components": [
        {"bom-ref": "1", "type": "operating-system", "name": "debian", "version": "12.12"},
        {"bom-ref": "2", "type": "library", "name": "tree", "version": "2.1", "purl": "pkg:deb/debian/tree@2.1"},
        {"bom-ref": "3", "type": "library", "name": "torch", "version": "2", "purl": "pkg:pypi/torch@2"},
    ],
}

VULNERABILITY = {"VulnerabilityID": "CVE-2026-1", "PkgName": "tree", "InstalledVersion": "2.1", "FixedVersion": "2.2"}
VULNERABILITY |= {"Severity": "HIGH", "Title": "bad", "PrimaryURL": "https://example.org"}

REPORT = {
    "SchemaVersion": 2,
    "Metadata": {"OS": {"Family": "debian", "Name": "12.12", "EOSL": True}},
    "Results": [{"Type": "debian", "Packages": [{"Name": "tree"}], "Vulnerabilities": [VULNERABILITY]}],
}  # fmt: skip

INFO = {"ServerVersion": "27", "SecurityOptions": ["name=seccomp"], "Runtimes": {"runc": {}}}
INFO |= {"CDISpecDirs": ["/etc/cdi"], "Name": "robot"}

IMAGE = {
    "Id": DIGEST,
    "Config": {"Env": ["A=b"], "Labels": {"a": "b"}, "Entrypoint": ["/x"], "Cmd": ["bash"], "User": ""},
}

IN_ENGINE = {
    "Id": DIGEST,
    "RepoDigests": [f"a@{DIGEST}"],
    "RootFs": {"Layers": [DIGEST]},
    "Config": IMAGE["Config"],
}

CONTAINER = b" ".join(
    json.dumps(value).encode()
    for value in (
        "/one",
        "running",
        DIGEST,
        {**IMAGE["Config"], "Image": "ros:jazzy"},  # type: ignore[dict-item]
        [{"Destination": "/dev/shm"}],
        {"NetworkMode": "host", "IpcMode": "host"},
    )
)

DEFAULTS = (
    b'# comment\nimage = "ros:jazzy"\noptions = ["--mws", "-e", "ROS_DOMAIN_ID=7"]\ncommand = ["ros2", "topic"]\n'
)

WORDS = b"""\
--env=ROS_DOMAIN_ID=7
--shm-size=512m
--gpus=2
--ulimit=nofile=1024:2048
--stop-timeout=3
--memory=2g
--mount=type=bind,source=/a,target=/b,readonly
--volume=/a:/b:ro
--publish=127.0.0.1:80:80/tcp
--health-interval=1m30s
--device=/dev/a:/dev/b:rw
--user=1000:1000
--security-opt=seccomp=a.json
--label=a=b
"""

COMPOSE = b"""\
# mine
services:
  talker:
    image: ros:jazzy  # x
    command: [ros2, run, a, b]
volumes:
  data:
"""

PYLOCK = b"""\
lock-version = "1.0"
[[packages]]
name = "a"
version = "1.0+cu1"
wheels = [{ name = "a-1-py3-none-any.whl", url = "https://index.test/a-1.whl", size = 10, upload-time = 2026-11-22T00:00:00Z }]
"""

PINS = b"""\
# head
torch==2.10.0 \\
    --hash=sha256:0000000000000000000000000000000000000000000000000000000000000000
    # via
    #   tensorflow
nvidia-nccl-cu12==2.1 ; sys_platform == 'linux'
"""

ISSUES = [{"number": 1, "title": issue.TITLE, "html_url": "https://github.test/1"}]

STEPS = b"\n".join(
    (
        b'{"vertexes": [{"digest": "a", "name": "[b 1/2] RUN --mount=type=cache x", "started": "2026-11-22T03:00:00.1234Z"}]}',
        b'{"logs": [{"vertex": "a", "stream": 1, "data": "aGVsbG8K", "timestamp": "2026-11-22T03:00:00Z"}]}',
        b'{"vertexes": [{"digest": "a", "name": "x", "completed": "2026-11-22T03:00:09Z", "error": "failed to push a: 403"}]}',
        b"WARNING: x",
    )
)

SYSTEM = b"""\
#!/bin/bash
ID=debian
VERSION_ID="12"
deb http://archive.test/debian bookworm main
exec "$@"
"""

RESULT: dict[str, Any] = {"target": "alpha-base", "architecture": "amd64", "digest": DIGEST, "scanned": "clean"}
RESULT |= {"scan": {"findings": {"high": 1}, "packages": 2}}
RESULTS = {"version": 1, "date": "2026-11-22T03:00:00Z", "entries": [RESULT]}

TESTS = {"Results": [{"Name": "Command Test: a", "Pass": True, "Duration": 5e9, "Errors": ["x"], "Stdout": "y"}]}

SERVICES: dict[str, Any] = {
    "registry": "127.0.0.1:5000",
    "buildx": ["docker", "buildx"],
    "builder": "rosml",
    "builder_kind": "ours",
}
SERVICES |= {"buildx_config": None, "uv": "uv", "ca_bundle": "", "bases": []}

PLAN: dict[str, Any] = {
    "version": 1,
    "date": "2026-11-22T03:00:00Z",
    "registry": "registry.test/rosml",
    "architectures": ["amd64"],
}
PLAN |= {"serve": [], "force": False, "package_state": {"jazzy": "x"}, "targets": ["alpha"]}
PLAN |= {"shards": [], "tasks": [], "unchanged": 0, "remarks": []}
