#!/usr/bin/env bash
# Text is UTF-8, in a locale that is there, and LC_ALL is left to whoever wants another one.
set -euo pipefail
[[ -z ${LC_ALL+set} ]] || { echo "LC_ALL is set: $LC_ALL" >&2; exit 1; }
said=$(locale 2>&1)
[[ $(locale charmap) == UTF-8 && $said == *LC_CTYPE=\"C.UTF-8\"* && $said != *"Cannot set"* ]] || { echo "$said" >&2; exit 1; }
