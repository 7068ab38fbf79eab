"""`rosml dev` with a real engine: a package is built, changed, tested and debugged in its container."""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

from rosml import ROOT
from tests.e2e import engine
from tests.e2e.calls import run
from tests.e2e.images import Publish
from tests.e2e.mini import use

DEBUG = """\
colcon build --cmake-args -DCMAKE_BUILD_TYPE=Debug && colcon test
gdb -batch -ex 'break compass::direction' -ex run -ex bt build/compass/devel/lib/compass/test_compass
python3 -c 'import debugpy; print("debugpy", debugpy.__version__)'
"""


def test_a_package_is_worked_on(published: Publish, checkout: Path, tmp_path: Path) -> None:
    folder = tmp_path / "my robot"
    shutil.copytree(ROOT / "examples/ros1", folder)
    with engine.running() as docker:
        if not docker.reads_zstd:  # our own builder makes images for the registry
            use(checkout, builder_kind="user")
        env = {
            **docker.variables(),
            "XDG_STATE_HOME": str(tmp_path / "state"),
            "XDG_CONFIG_HOME": str(tmp_path / "config"),
        }
        base = ["--network", "none", "--base-image", published("ros1-bookworm-core").reference]

        def dev(*command: str) -> tuple[int, str]:
            done = run(sys.executable, str(checkout / "src"), "dev", *base, str(folder), "--", *command, env=env)
            return done.code, done.out + done.err

        code, output = dev("colcon", "build")
        assert code == 0 and "1 package finished" in output, output
        kept = folder / ".rosml/dev"
        assert re.search(r"src/compass\.cpp", (kept / "compile_commands.json").read_text())
        assert str(folder / "src/compass/src/compass.cpp") in (kept / "host/compile_commands.json").read_text()
        shutil.rmtree(kept / "build")
        code, output = dev("sh", "-c", "ccache --zero-stats >/dev/null && colcon build && ccache --show-stats")
        assert code == 0 and "base image" not in output, "the image is made once"
        assert re.search(r"Hits: +[1-9]", output), output

        code, output = dev("bash", "-ec", DEBUG)
        assert code == 0 and "debugpy 1" in output, output
        assert re.search(r"TestBody .* at /docker-ros/ws/src/target/src/compass/test/test_compass\.cpp:\d+", output), (
            output
        )
        test = folder / "src/compass/test/test_compass.cpp"
        test.write_text(test.read_text().replace('"east"', '"west"'))
        code, output = dev("colcon", "test")
        assert code == 1 and "1 package had test failures: compass" in output, output
