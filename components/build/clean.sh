#!/usr/bin/env bash
# Last command of every step that installs packages: removes what differs from one build to the next although the
# packages are the same (logs, caches, backups, package lists), so that the same packages give the same layer.
set -euo pipefail

rm -rf /var/lib/apt/lists/* /var/log/* /var/cache/apt/* \
  /var/cache/debconf/*-old /var/lib/dpkg/*-old /var/cache/ldconfig/aux-cache \
  /root/.cache /tmp/* /var/tmp/*
