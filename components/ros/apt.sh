# shellcheck shell=bash
# Sourced by the steps that use apt, after components/build/network.sh: apt_update and apt_install try often enough for
# a flaky mirror, and where another try cannot help they stop with one sentence that names the remedy.
keys=$(dirname "${BASH_SOURCE[0]}")/keys
pauses=(1 3 9 27 0)
scratch=$(mktemp -d)
mkdir -m 700 "$scratch/gnupg"
log=$scratch/log
trap 'rm -rf "$APT_CONFIG" "$APT_CONFIG.sources" "$scratch"' EXIT
export LC_ALL=C.UTF-8 # apt's answers are read below

fail() {
  echo "error: $1; $2" >&2
  exit 1
}

# A secret and not an argument: arguments are part of the image's history.
mirror=$(cat /run/secrets/ros-apt-mirror 2>/dev/null || true)
[[ -z $mirror || $mirror =~ ^https?://[A-Za-z0-9._~:@/-]+$ ]] ||
  fail "ROS_APT_MIRROR is not an address" "set it to one such as http://host:3142, or unset it"

# use_mirror ADDRESS: lets apt read copies of the sources that name the mirrors, ROS's own for the source with this address
# and the operating system's for all others. The image keeps the official addresses.
use_mirror() {
  local file of parts=$APT_CONFIG.sources/parts
  [[ -n $mirror$os_mirror ]] || return 0
  mkdir -p "$parts"
  for file in /etc/apt/sources.list.d/*; do
    [[ -e $file ]] || continue # a base image may have none
    if grep -q -x -F "URIs: $1" "$file"; then of=$mirror; else of=$os_mirror; fi
    below "$of" <"$file" >"$parts/${file##*/}"
  done
  echo "Dir::Etc::SourceParts \"$parts\";" >>"$APT_CONFIG"
}

# Runs a command; what it says is shown, and kept for said.
logged() { "$@" 2>&1 | tee "$log"; }

# The first line of it that matches, without apt's own prefix.
said() { grep --max-count=1 -E "$1" "$log" | sed -E 's/^ *([A-Z]: )?//'; }

# Signatures that another try would not mend. gpgv says NO_PUBKEY and EXPKEYSIG; sqv (Ubuntu 26.04) has sentences.
judge_signature() {
  local key file
  if key=$(said 'NO_PUBKEY|Missing key'); then
    key=$(grep -o -E '[0-9A-F]{16,}' <<<"$key" | head -n 1)
    for file in "$keys"/*.asc; do
      [[ $(fingerprint <"$file") != *"$key" ]] ||
        fail "an apt source is signed with another key, of components/ros/keys/${file##*/}" \
          "live and snapshot are mixed up, or two archives: check 'apt' or 'archive' in matrix.yaml, and the mirror"
    done
    fail "an apt source is signed with the key $key, which is not a pinned one" \
      "check the mirror, and if the archive has a new key, pin it in apt_sources of matrix.yaml, in components/ros/keys or in components/archive-keys"
  elif key=$(said 'EXPKEYSIG|KEYEXPIRED|not alive|key .*expired'); then
    fail "the key of an apt source has expired ($key)" \
      "pin a newer release in apt_sources of matrix.yaml, or the prolonged key in components/ros/keys or components/archive-keys"
  elif key=$(said 'BADSIG|GPG error|OpenPGP|is not signed'); then
    fail "an apt source has no valid signature ($key)" "check the mirror"
  fi
}

# The fingerprint of the first key on standard input.
fingerprint() {
  gpg --homedir "$scratch/gnupg" --batch --show-keys --with-colons 2>/dev/null |
    awk -F : '$1 == "fpr" && !seen++ {print $10}'
}

# `apt-get update`, but it fails when an index is missing; apt itself goes on with what it has.
apt_update() {
  local pause missing='^[WE]: (Failed to fetch|Some index files failed)'
  for pause in "${pauses[@]}"; do
    if logged apt-get update -o Acquire::Retries=1 -o Acquire::http::Timeout=30 && ! said "$missing" >/dev/null; then
      return
    fi
    judge_signature
    if said ' 404 ' >/dev/null && said 'does not have a Release file' >/dev/null; then
      fail "there is no such apt repository ($(said 'does not have a Release file'))" \
        "check 'apt' and 'codename', or 'archive', in matrix.yaml, and the mirror"
    fi
    sleep "$pause"
  done
  fail "an apt source does not answer, after ${#pauses[@]} tries ($(said '^[WE]: '))" \
    "check the network and HTTP_PROXY, or name a mirror in ROS_APT_MIRROR"
}

# require_sync ADDRESS: ROS's apt source, as apt_update left it, is of the suite $ROS_CODENAME, and of $ROS_SYNC_DATE where
# that is said: an image's components are of one moment. A suite has two names, such as stable and bookworm.
require_sync() {
  local path=${1#*://} release suite sync
  release=$(find /var/lib/apt/lists -name "*${path//\//_}_dists_${ROS_CODENAME:?}_*Release")
  grep -q -x -F -e "Suite: $ROS_CODENAME" -e "Codename: $ROS_CODENAME" "$release" || {
    suite=$(sed -n 's/^Codename: //p' "$release")
    fail "$1 has the suite '$suite' in the place of '$ROS_CODENAME'" "check the mirror"
  }
  sync=$(date --utc --date "$(sed -n 's/^Date: //p' "$release")" +%FT%TZ)
  [[ -z ${ROS_SYNC_DATE:-} || $sync == "$ROS_SYNC_DATE" ]] ||
    fail "$1 is of $sync, and not of $ROS_SYNC_DATE any more" "run it again: new packages were published meanwhile"
}

# Installs packages. What did not arrive is asked for again with a fresh index: a sync may have replaced it just then.
#   apt_install PACKAGE…
# NOT_FOUND: what to do about a name that no source has, if the name is not of matrix.yaml.
apt_install() {
  local pause why
  local unknown='check its name in matrix.yaml (past its end of life, a distribution is on the snapshot only: {channel: final})'
  if [[ -n ${ROS_ARCHIVE:-} ]]; then unknown="check its name in matrix.yaml, and whether $ROS_ARCHIVE has it"; fi
  for pause in "${pauses[@]}"; do
    if logged apt-get install --yes "$@"; then return; fi
    if why=$(said 'Unable to locate package|has no installation candidate'); then
      fail "no apt source has a package ($why)" "${NOT_FOUND:-$unknown}"
    elif said 'unmet dependencies' >/dev/null; then
      fail "no apt source has what a package needs ($(said 'Depends: '))" \
        "check that the base image has Ubuntu's universe, and that the mirror is whole"
    elif ! said 'Failed to fetch|Hash Sum mismatch|unexpected size' >/dev/null; then
      fail "apt could not install the packages ($(said '^E: '))" "the lines above say more"
    fi
    sleep "$pause"
    apt_update
  done
  fail "packages did not arrive, after ${#pauses[@]} tries ($(said 'Failed to fetch'))" \
    "check the network and HTTP_PROXY, or name a mirror in ROS_APT_MIRROR"
}
