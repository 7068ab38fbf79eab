#!/usr/bin/env bash
# Every link of a part leads somewhere: its parts fit together.
set -euo pipefail
root=${CHECK_ROOT:-}
dangling=$(find "$root/usr/local" "$root"/usr/lib/*-linux-gnu -xdev -xtype l -newermt 2025-12-31 ! -newermt 2026-01-02)
[[ -z $dangling ]] || { echo "$dangling" >&2; exit 1; }
