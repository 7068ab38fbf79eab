#!/usr/bin/env bash
# Called by who builds a dev container, as root: adds the part PART, and those that it needs, to the image.
set -euo pipefail
fail() {
  echo "error: $1; $2" >&2
  exit 1
}

[[ -n ${PART:-} ]] || fail "no part is named" 'name one: "part": "ghcr.io/me/rosml/part:torch-cu130-py312"'
missing=()
for program in python3 tar zstd; do command -v "$program" >/dev/null || missing+=("$program"); done
# What parts need of the system's own Python: docs/parts.md.
for module in packaging setuptools six wheel; do
  python3 -c "import $module" 2>/dev/null || missing+=("python3-$module")
done
if [[ ! -e /etc/ssl/certs/ca-certificates.crt ]]; then missing+=(ca-certificates); fi
if [[ ${#missing[@]} -gt 0 ]]; then
  command -v apt-get >/dev/null || fail "the image has no ${missing[*]}" "install them, or take an image of Debian or Ubuntu"
  apt-get update
  DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "${missing[@]}"
  rm -rf /var/lib/apt/lists/*
fi
exec python3 "$(dirname "$0")/add_part.py" "$PART" /
