#!/usr/bin/env bash
# Called by who builds a dev container, as root: adds the part PART, and those that it needs, to the image.
set -euo pipefail
fail() {
  echo "error: $1; $2" >&2
  exit 1
}

[[ -n ${PART:-} ]] || fail "no part is named" 'name one: "part": "ghcr.io/me/rosml/part:torch-cu130-py312"'
missing=()
for program in tar zstd; do command -v "$program" >/dev/null || missing+=("$program"); done
# The system's own, which alone reads where parts are.
python=/usr/bin/python3
[[ -e $python ]] || missing+=(python3)
# What parts need of the system's own Python: docs/parts.md.
for module in packaging setuptools six wheel; do
  "$python" -c "import $module" 2>/dev/null || missing+=("python3-$module")
done
if [[ ! -e /etc/ssl/certs/ca-certificates.crt ]]; then missing+=(ca-certificates); fi
if [[ ${#missing[@]} -gt 0 ]]; then
  command -v apt-get >/dev/null || fail "the image has no ${missing[*]}" "install them, or take an image of Debian or Ubuntu"
  apt-get update
  DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "${missing[@]}"
  rm -rf /var/lib/apt/lists/*
fi
exec "$python" "$(dirname "$0")/add_part.py" "$PART" /
