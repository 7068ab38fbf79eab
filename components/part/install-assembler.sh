#!/usr/bin/env bash
# The tools that assemble parts: the distribution's Python, for its bytecode, and uv (pinned by hash).
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

apt-get update
apt-get install --yes ca-certificates python3 python3-pip
python3 -m pip install --no-deps --require-hashes --no-cache-dir --disable-pip-version-check --target /opt/uv \
  --requirement /run/requirements.txt
rm -rf /var/lib/apt/lists/*
