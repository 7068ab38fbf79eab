#!/usr/bin/env bash
# Last command of every step that changes an image: takes out what differs from one build to the next although the
# packages are the same (logs, caches, backups, package lists, the time of day), so that they give the same layer.
#   STEP_STARTED       when the step began (network.sh)
#   SOURCE_DATE_EPOCH  the time that what was made since then gets, in seconds since 1970
set -euo pipefail

"$(dirname "${BASH_SOURCE[0]}")/deb_hashes.sh" /usr/local/share/rosml/debs.txt

rm -rf /var/lib/apt/lists/* /var/cache/apt/* \
  /var/cache/debconf/*-old /var/lib/dpkg/*-old /var/cache/ldconfig/aux-cache \
  /etc/passwd- /etc/group- /etc/shadow- /etc/gshadow-
# Of these the step's own alone: an image of somebody else may keep models in a cache.
for folder in /var/log /root/.cache /tmp /var/tmp; do
  if [[ -d $folder ]]; then find $folder -depth -xdev ! -path $folder -newerct "${STEP_STARTED:?}" \( ! -type d -o -empty \) -delete; fi
done
rmdir --ignore-fail-on-non-empty /root/.cache 2>/dev/null || true # there may be none

# systemd's and dbus' packages make up a machine's identity: another one in every build, and the same one in every
# container of it.
rm -f /etc/machine-id /var/lib/dbus/machine-id

certificates=/etc/ssl/certs/java/cacerts
if [[ -s $certificates ]]; then
  "$(dirname "${BASH_SOURCE[0]}")/java_certificates.py" $certificates "${SOURCE_DATE_EPOCH:?}"
fi

# dpkg gives files the times of their packages; what was written here has the time of now. What the builder mounts is
# no part of the layer, but find -xdev names it.
listed=$(awk '$5 != "/" {print $5}' /proc/self/mountinfo)
mapfile -t mounted <<<"$listed"
for path in "${mounted[@]}"; do skipped+=(! -path "$path"); done
find / -xdev -newermt "${STEP_STARTED:?}" "${skipped[@]}" -exec touch --no-dereference --date="@${SOURCE_DATE_EPOCH:?}" {} +
