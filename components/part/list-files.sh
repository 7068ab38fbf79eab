#!/usr/bin/env bash
# Lists the files and links below /listed, sorted, as /files.gz: the same list for the same files, on any day.
set -euo pipefail

find /listed -mindepth 1 \( -type f -o -type l \) -printf '%P\n' | LC_ALL=C sort | gzip -9n >/files.gz
