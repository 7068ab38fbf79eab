"""`rosml run --export kubernetes`: a cluster starts what `rosml run` would."""

from __future__ import annotations

import re
from typing import Any

import kubernetes_validate
import pytest
import yaml

from fakes.exports import text
from rosml.base.errors import RosmlError
from rosml.run.context import Health

RELEASES = ("1.30", "1.37")
"""Releases of Kubernetes whose schemas take the files."""

QUIET = ("--no-tz", "--no-user")
CUDA = {"io.rosml.gpu.driver": "580"}
DIGEST, OTHER = f"sha256:{'a' * 64}", f"sha256:{'b' * 64}"


def file(*line: str, **facts: Any) -> dict[str, Any]:
    """The file, which the schemas take."""
    document = yaml.safe_load(text(*line, kind="kubernetes", **facts))
    for release in RELEASES:
        kubernetes_validate.validate(document, release, strict=True)
    return dict(document)


def pod(*line: str, **facts: Any) -> dict[str, Any]:
    """A pod's fields beside its container."""
    spec = dict(file(*line, **facts)["spec"]["template"]["spec"])
    del spec["containers"]
    return spec


def container(*line: str, **facts: Any) -> dict[str, Any]:
    (only,) = file(*line, **facts)["spec"]["template"]["spec"]["containers"]
    return dict(only)


@pytest.mark.parametrize(
    ("typed", "written"),
    [("$X ${Y} 5$", "$X ${Y} 5$"), ("$(date)", "$$(date)"), ("$$ $$(x) $$", "$$$ $$$$(x) $$$")],
)
def test_a_dollar_is_read_as_it_was_typed(typed: str, written: str) -> None:
    """A cluster reads `$$` as `$`. podman 4 does not, so there are few: a variable of a shell is the same for both."""
    assert re.sub(r"\$([$(]?)", lambda it: "$" if it[1] == "$" else it[0], written) == typed
    assert container("x", "sh", "-c", typed)["args"][-1] == written


def test_a_whole_file() -> None:
    line = [
        "--ros-network",
        "-v",
        "./bags:/bags:ro",
        "--cpus",
        "1.5",
        "-m",
        "512m",
        "ghcr.io/me/ros:jazzy",
        "ros2",
        "x",
    ]
    name = {"app.kubernetes.io/name": "robot"}
    ids = {"DOCKER_UID": "1234", "DOCKER_GID": "5678", "DOCKER_USER": "jo", "TZ": "Europe/Berlin"}
    document = file(*line, labels=CUDA, digests=(f"ghcr.io/me/ros@{DIGEST}",), environment={"DOCKER_UID": ""})
    assert (document["kind"], document["metadata"]) == ("Deployment", {"name": "robot", "labels": name})
    assert document["spec"]["strategy"] == {"type": "Recreate"}
    template = document["spec"]["template"]
    assert document["spec"]["selector"]["matchLabels"] == template["metadata"]["labels"] == name
    (only,) = template["spec"].pop("containers")
    assert only == {
        "name": "robot",
        "image": f"ghcr.io/me/ros:jazzy@{DIGEST}",
        "args": ["ros2", "x"],
        "env": [{"name": key, "value": value} for key, value in ids.items()],
        "resources": {"limits": {"nvidia.com/gpu": "1", "cpu": "1.5", "memory": "512Mi"}},
        "volumeMounts": [{"name": "volume-0", "mountPath": "/bags", "readOnly": True}],
    }
    network = {"hostNetwork": True, "hostIPC": True, "dnsPolicy": "ClusterFirstWithHostNet"}
    assert template["spec"] == {
        **network,
        "volumes": [{"name": "volume-0", "hostPath": {"path": "/home/jo/robot/bags"}}],
    }


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        (["--user", "1:2"], {"securityContext": {"runAsUser": 1, "runAsGroup": 2}}),
        (["--privileged", "--read-only"], {"securityContext": {"privileged": True, "readOnlyRootFilesystem": True}}),
        (["--cap-add", "cap_sys_nice", "--cap-drop=ALL"], {"securityContext": {"capabilities": {"add": ["SYS_NICE"], "drop": ["ALL"]}}}),
        (["--security-opt", "seccomp=unconfined"], {"securityContext": {"seccompProfile": {"type": "Unconfined"}}}),
        (["--security-opt", "no-new-privileges"], {"securityContext": {"allowPrivilegeEscalation": False}}),
        (["--gpus", "2"], {"resources": {"limits": {"nvidia.com/gpu": "2"}}}),
        (["--memory-reservation", "1.5g"], {"resources": {"requests": {"memory": "1.5Gi"}}}),
        (["-p", "127.0.0.1:80:8080/udp"], {"ports": [{"containerPort": 8080, "hostPort": 80, "hostIP": "127.0.0.1", "protocol": "UDP"}]}),
        (["-w", "/a b"], {"workingDir": "/a b"}),
        (["--pull", "missing"], {"imagePullPolicy": "IfNotPresent"}),
        (["-it", "--init=false", "--restart=always", "--network=bridge", "--ipc=private"], {}),
    ],
)  # fmt: skip
def test_an_option_of_the_container(typed: list[str], expected: dict[str, Any]) -> None:
    fields = container(*QUIET, *typed, "x")
    assert fields == {"name": "robot", "image": "x", **expected}


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        (["--pid", "host"], {"hostPID": True}),
        (["--group-add", "44", "--group-add", "20"], {"securityContext": {"supplementalGroups": [44, 20]}}),
        (["--sysctl", "net.core.somaxconn=9"], {"securityContext": {"sysctls": [{"name": "net.core.somaxconn", "value": "9"}]}}),
        (["--shm-size=8g"], {"volumes": [{"name": "volume-0", "emptyDir": {"medium": "Memory", "sizeLimit": "8Gi"}}]}),
        (["--tmpfs", "/t"], {"volumes": [{"name": "volume-0", "emptyDir": {"medium": "Memory"}}]}),
        (["--mount", "type=bind,src=./a,dst=/b"], {"volumes": [{"name": "volume-0", "hostPath": {"path": "/home/jo/robot/a"}}]}),
        (["--add-host", "arm:10.0.0.1"], {"hostAliases": [{"ip": "10.0.0.1", "hostnames": ["arm"]}]}),
        (["--platform", "linux/arm64"], {"nodeSelector": {"kubernetes.io/arch": "arm64"}}),
    ],
)  # fmt: skip
def test_an_option_of_the_pod(typed: list[str], expected: dict[str, Any]) -> None:
    assert pod(*QUIET, *typed, "x") == expected


@pytest.mark.parametrize(
    ("line", "says"),
    [
        *((["-v", value, "x"], f"-v {value} has no counterpart") for value in ("data:/d", "/d")),
        (["-v", "/a:/b:Z", "x"], "Z of -v"),
        (["-v", "/a/../b:/b", "x"], "the mount of /a/../b"),
        (["--mount", "type=bind,src=/a,dst=/b:c", "x"], "the mount of /a at '/b:c'"),
        (["--env-file", "e", "x"], "--env-file has no counterpart"),
        (["-e", "A", "x"], "-e A without a value"),
        (["-e", "A B=1", "x"], "the variable 'A B'"),
        *((["-l", label, "x"], "--label") for label in ("a=b c", "app.kubernetes.io/name=x")),
        *((["--user", user, "x"], "--user '") for user in ("jo", "\u0661")),
        *((["--gpus", value, "x"], "--gpus") for value in ('"device=0,1"', "all", "0,1")),
        (["--device", "/dev/video0", "x"], "--device=/dev/video0"),
        *(([option, "x"], option) for option in ("--restart=no", "--network=robots")),
        *((["-p", value, "x"], f"-p {value}") for value in ("80", "99999:1")),
        *(([f"--{name}", value, "x"], f"--{name}") for name, value in [
            ("ulimit", "rtprio=99"), ("memory", "0"), ("cpus", "0"), ("sysctl", "a"), ("cap-add", ""), ("pull", "newer"),
            ("hostname", "A"), ("hostname", "a" * 64), ("platform", "windows/amd64"), ("runtime", "a b"), ("add-host", "a:b c"),
        ]),
        (["--network=host", "--hostname=a", "x"], "--hostname does not go with"),
        (["--privileged", "--security-opt=no-new-privileges", "x"], "refuses no-new-privileges together with"),
        (["--entrypoint", "", "x"], "nothing to start"),
        (["--health-cmd=x", "--health-interval=5", "x"], "--health-interval=5 is no duration"),
        *(([image, "x"], "no name of an image") for image in ("dir:/a", "sha256:" + "b" * 64)),
    ],
)  # fmt: skip
def test_options_that_a_cluster_refuses(line: list[str], says: str) -> None:
    with pytest.raises(RosmlError) as caught:
        text(*line, kind="kubernetes", id="b" * 64)
    assert says in caught.value.message and caught.value.remedy and caught.value.exit_code == 2


@pytest.mark.parametrize(
    ("health", "typed", "expected"),
    [
        (Health(), [], None),
        (Health(("a", "b"), 5, 0.5, 10, 2), [], {"command": ["a", "b"], "periodSeconds": 5, "timeoutSeconds": 1, "failureThreshold": 2, "initialDelaySeconds": 10}),
        (Health(("a",)), [], {"command": ["a"], "periodSeconds": 30, "timeoutSeconds": 30, "failureThreshold": 3}),
        (Health(("a",), 5), ["--no-healthcheck"], None),
        (Health(("a",), 5), ["--health-cmd=none"], None),
        (Health(("a",), 5), ["--health-cmd", "b $X", "--health-interval", "1m30s"], {"command": ["/bin/sh", "-c", "b $X"], "periodSeconds": 90, "timeoutSeconds": 30, "failureThreshold": 3}),
    ],
)  # fmt: skip
def test_the_probe_is_the_images(health: Health, typed: list[str], expected: dict[str, Any] | None) -> None:
    probe = container(*typed, "x", health=health).get("livenessProbe")
    if probe:
        probe |= probe.pop("exec")
    assert probe == expected


@pytest.mark.parametrize(
    ("image", "digests", "expected"),
    [
        ("ros:jazzy", (f"ros@{DIGEST}",), f"ros:jazzy@{DIGEST}"),
        ("ros:jazzy", (f"evil/ros@{DIGEST}",), "ros:jazzy"),
        (f"ros@{OTHER}", (f"ros@{DIGEST}",), f"ros@{OTHER}"),
        ("ros", (), "ros"),
    ],
)
def test_the_digest_is_that_of_the_images_own_repository(image: str, digests: tuple[str, ...], expected: str) -> None:
    """podman also names that of this machine's architecture, which is not the one over all."""
    assert container(image, digests=digests, digest=OTHER)["image"] == expected
    warns = "has no digest" in text(image, kind="kubernetes", digests=digests, digest=OTHER)
    assert warns == ("@" not in expected)


@pytest.mark.parametrize(
    ("labels", "typed", "count", "comment"),
    [
        (CUDA, [], "1", "--no-gpu leaves it out"),
        (CUDA, ["--no-gpu"], None, "--gpus 1 asks for it"),
        (CUDA, ["--gpus=2"], "2", "--no-gpu leaves it out"),
        ({"io.rosml.gpu.driver": "580\nspec: {}"}, [], None, ""),
        ({}, [], None, ""),
    ],
)
def test_a_gpu_for_an_image_that_was_made_for_one(
    labels: dict[str, str], typed: list[str], count: str | None, comment: str
) -> None:
    limits = container(*typed, "x", labels=labels).get("resources", {}).get("limits", {})
    assert limits.get("nvidia.com/gpu") == count
    assert ("made for a GPU" in text(*typed, "x", kind="kubernetes", labels=labels)) == bool(comment)
    assert comment in text(*typed, "x", kind="kubernetes", labels=labels)


@pytest.mark.parametrize(("name", "expected"), [("Robot_1", "robot-1"), ("a" * 80, "a" * 63), ("1.2", "1-2")])
def test_names_are_those_of_a_cluster(name: str, expected: str) -> None:
    assert file("--name", name, "x")["metadata"]["name"] == expected
