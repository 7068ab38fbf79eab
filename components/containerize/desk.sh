#!/usr/bin/env bash
# Adds what people work with to an app's dependencies, for rosml dev: ccache, debuggers for C++ and Python, and a colcon that builds
# and tests as CI does. No other image is made from here.
#   CMAKE_ARGS, COLCON_ARGS  as workspace.sh gets them
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"
# shellcheck source=components/ros/apt.sh
source "$here/../ros/apt.sh"
export NOT_FOUND='check the apt sources of the base image' SOURCE_DATE_EPOCH=1767225600

has_module() { python3 -c "import $1" 2>/dev/null; }

use_mirror "$(sed -n 's/^ros-source //p' /usr/local/share/rosml/versions.d/ros 2>/dev/null)"
apt_update
packages=()
for program in ccache gdb; do
  if ! command -v "$program" >/dev/null; then packages+=("$program"); fi
done
if ! has_module colcon_defaults; then packages+=(python3-colcon-defaults); fi
# Ubuntu 22.04 and older have no package of it.
debugger=$(apt-cache search --names-only '^python3-debugpy$')
if [[ -n $debugger ]] && ! has_module debugpy; then packages+=(python3-debugpy); fi
if [[ ${#packages[@]} -gt 0 ]]; then apt_install "${packages[@]}"; fi

desk=/usr/local/lib/rosml/desk
install -D --mode=755 "$here/desk_command.sh" $desk/command.sh
install --mode=644 "$here/compile_commands.py" $desk/
for name in colcon catkin catkin_make catkin_make_isolated; do
  if command -v "$name" >/dev/null; then ln -s command.sh "$desk/$name"; fi
done
printf '%s\n' "${COLCON_ARGS:-}" >$desk/colcon_args
arguments=()
eval "arguments=(${CMAKE_ARGS:-})"
# CMake before 3.17 does not read the variables of the image.
if [[ $(printf '%s\n' 3.17 "$(cmake --version | sed -n 's/^cmake version //p')" | sort --version-sort | head -n 1) != 3.17 ]]; then
  arguments=(-DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_{C,CXX}_COMPILER_LAUNCHER=ccache "${arguments[@]}")
fi
# A slim base image decides this in CI; see workspace.sh.
if [[ -e /usr/local/lib/rosml/bin/python3 ]]; then
  arguments=(--no-warn-unused-cli -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython{,3}_EXECUTABLE=/usr/bin/python3 "${arguments[@]}")
fi
python3 - /docker-ros/ws /run/requests/blacklist "${arguments[@]}" >$desk/colcon.yaml <<'END'
import json, sys

workspace, blacklist, *arguments = sys.argv[1:]
with open(blacklist, encoding="utf-8") as file:
    skipped = {"packages-skip": names} if (names := file.read().split()) else {}
spaces = {"build-base": f"{workspace}/build", "install-base": f"{workspace}/install"}
upstream, target = (f"{workspace}/src/{name}" for name in ("upstream", "target"))
both = {"base-paths": [upstream, target]}
said = {
    "build": {**both, **spaces, **skipped, "cmake-args": arguments},
    "test": {"base-paths": [target], **spaces, **skipped, "return-code-on-test-failure": True},
    "test-result": {"test-result-base": f"{workspace}/build"},
    **dict.fromkeys(("graph", "info", "list"), both),
}
print(json.dumps(said, indent=1))  # YAML as well
END
# The workspace of a container is a folder of the machine. What the base image has built there moves to where setup files find it.
if [[ -d /docker-ros/ws/install && ! -e /opt/ws_base_image/install ]]; then
  mkdir -p /opt/ws_base_image
  mv /docker-ros/ws/install /opt/ws_base_image/
fi
# A login shell sets PATH again.
echo "PATH=$desk:\$PATH" >/etc/profile.d/rosml-desk.sh

"$here/../build/clean.sh"
