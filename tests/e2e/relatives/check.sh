#!/usr/bin/env bash
# The contract as far as it needs no ROS: all checks are run, and those that fail are named at the end.
set -euo pipefail
checks=$(dirname "${BASH_SOURCE[0]}")/checks
failed=()
check() {
  local name=$1
  shift
  "$@" || failed+=("$name")
}
ros='colcon|rosdep|vcs' # what rows of ROS bring
tools() { sed -E "s/ ($ros)\b//g" "$checks/tools.sh" | bash -s; }
user() {
  DOCKER_UID=1234 DOCKER_GID=2345 /tini -- /entrypoint.sh "$checks/user.sh" | tee /tmp/user
  grep -q '1234:2345 .*sudo.*video.* /home/dockeruser /docker-ros/ws' /tmp/user
}
root() { [[ $(DOCKER_UID=1234 DOCKER_GID=2345 /entrypoint.sh sudo id -u) == 0 ]]; }
code() { local code=0; /tini -- /entrypoint.sh bash -c 'exit 37' || code=$?; [[ $code == 37 ]]; }
nobody() { ! getent passwd 1000; }
banner() { /usr/local/share/rosml/banner.sh | tee /tmp/banner; grep -q "OS.*$(. /etc/os-release && echo "$PRETTY_NAME")" /tmp/banner; }

check locale "$checks/locale.sh"
check "programs with other rights" "$checks/setuid.sh"
check tools tools
check python "$checks/python.sh"
check user user
check sudo root
check "exit code" code
check "uid 1000" nobody
check banner banner
check traces "$checks/no_traces.sh"
check pip "$checks/pip_install.py" # the last one: it changes Python's packages for a moment
[[ ${#failed[@]} -eq 0 ]] || { printf 'relative: failed: %s\n' "${failed[@]}" >&2; exit 1; }
echo "relative: holds"
