#!/usr/bin/env bash
# Prints who the entrypoint made us: ids, groups, home, and where ~/ws leads.
set -euo pipefail
echo "$(id -u):$(id -g) $(id -Gn) $HOME $(readlink ~/ws)"
