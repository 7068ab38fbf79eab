#!/usr/bin/env bash
# The tools and groups that builders on top of an image rely on.
set -euo pipefail

tools=(
  awk sed find lsb_release openssl useradd groupadd sudo git git-lfs gcc g++ make cmake ninja gdb curl wget nano vim less zip unzip ping
  python python3 pip tini gosu colcon rosdep vcs xeyes
  locale-gen
)
missing=()
for tool in "${tools[@]}"; do
  command -v "$tool" >/dev/null || missing+=("$tool")
done
[[ ${#missing[@]} -eq 0 ]] || { echo "missing: ${missing[*]}" >&2; exit 1; }

# Of packages that are no programs: completion in shells, time zones.
for file in /usr/share/bash-completion/bash_completion /usr/share/zoneinfo/Europe/Berlin; do
  [[ -s ${CHECK_ROOT:-}$file ]] || { echo "missing: $file" >&2; exit 1; }
done

getent group sudo video || { echo "the groups sudo and video are not both there" >&2; exit 1; }
grep -q CODENAME= "${CHECK_ROOT:-}/etc/os-release" || { echo "no CODENAME in /etc/os-release" >&2; exit 1; }

# An interactive shell of root's is set up by whoever replaces /etc/bash.bashrc as well.
grep -q /usr/local/share/rosml/shell.bash "${CHECK_ROOT:-}/root/.bashrc" || { echo "/root/.bashrc sources no ROS" >&2; exit 1; }
