#!/usr/bin/env bash
# g++ and binutils for TARGETARCH, as <triplet>-g++ and so on: the machine's own, or a cross compiler.
set -euo pipefail

# shellcheck source=components/build/network.sh
source /run/components/build/network.sh

case ${TARGETARCH:?} in
  "$(dpkg --print-architecture)") package=g++ ;;
  amd64) package=g++-x86-64-linux-gnu ;;
  arm64) package=g++-aarch64-linux-gnu ;;
  *) echo "install-assembler: no compiler is known for architecture '$TARGETARCH' (known: amd64, arm64)" >&2 && exit 64 ;;
esac
apt-get update
apt-get install --yes "$package"
rm -rf /var/lib/apt/lists/*
