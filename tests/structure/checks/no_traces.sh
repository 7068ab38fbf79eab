#!/usr/bin/env bash
# Nothing of the machine that built the image is left in it: no index address, proxy or certificate.
set -uo pipefail
root=${CHECK_ROOT:-}

found=$(
  env | grep -i -E '_proxy=|index_url=|ssl_cert|ca_bundle='
  pip config list 2>/dev/null | grep -i -E 'index|proxy|cert|trusted'
  ls -d "$root"/root/{.pip,.config/pip,.netrc,.cache} 2>/dev/null
  find "$root/usr/local/share/ca-certificates" "$root/run/secrets" -type f 2>/dev/null
  grep -r -i -E 'proxy|CAInfo' "$root/etc/apt/apt.conf.d"
)
[[ -z $found ]] || { echo "$found" >&2; exit 1; }
