#!/usr/bin/env bash
# Makes the layer independent of when and by whom it was assembled: owner, permissions, times.
set -euo pipefail

chown -hR 0:0 "${OUT:?}"
chmod -R u=rwX,go=rX "$OUT"
# 2026-01-01T00:00:00Z. Fixed here and not taken from SOURCE_DATE_EPOCH, so that a different epoch for the image's
# `created` field leaves the layer as it is.
find "$OUT" -exec touch --no-dereference --date=@1767225600 {} +
