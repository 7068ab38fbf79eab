#!/usr/bin/env bash
# Lists the files and links below /listed, sorted, as /files.gz: the same list for the same files, on any day. Without the
# slots of constraints that are empty: these are nobody's, until a part that is joined fills one.
set -euo pipefail

find /listed -mindepth 1 \( -type f -o -type l \) ! \( -path '*/rosml/constraints.d/*' -empty \) -printf '%P\n' | LC_ALL=C sort | gzip -9n >/files.gz
