#!/usr/bin/env bash
# The tools and groups that builders on top of an image rely on.
set -euo pipefail

tools=(
  awk sed find lsb_release openssl useradd groupadd sudo git git-lfs gcc g++ make cmake gdb curl wget nano vim less
  python python3 pip tini gosu colcon rosdep vcs xeyes
)
missing=()
for tool in "${tools[@]}"; do
  command -v "$tool" >/dev/null || missing+=("$tool")
done
[[ ${#missing[@]} -eq 0 ]] || { echo "missing: ${missing[*]}" >&2; exit 1; }

getent group sudo video
grep -q CODENAME= /etc/os-release
