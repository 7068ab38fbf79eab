#!/usr/bin/env bash
# Installs packages for install.sh, between the scripts of the repository: what the lists in /run/needed say, and what the repository asks
# for in /run/requests. apt's settings are those of install.sh, and more.
#   install_packages.sh KIND…   as of install.sh
#   APT_UPDATED   apt's lists are there
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/ros/apt.sh
source "$here/../ros/apt.sh"
trap 'rm -rf "$scratch"' EXIT
cat "${APT_CONFIG:-/dev/null}" >"$scratch/apt.conf"
export APT_CONFIG=$scratch/apt.conf
export NOT_FOUND='check its name in docker/additional-debs.txt, or in the rule of rosdep that has it'
kinds=("$@")

# listed WAY: all that one way of rosdep installs, into $scratch/WAY.
listed() {
  local kind lists=()
  for kind in "${kinds[@]}"; do lists+=("/run/needed/$kind.$1"); done
  sort -u "${lists[@]}" >"$scratch/$1"
}

# update_once: apt's lists, if this step has none yet.
updated=${APT_UPDATED:-}
update_once() {
  if [[ -z $updated ]]; then apt_update; fi
  updated=true
}

requests=/run/requests
if [[ $* == downstream ]]; then
  requests=$scratch/requests
  mkdir "$requests"
  touch "$requests/apt" "$requests/pip"
fi

lock=$requests/lock/$(dpkg --print-architecture)
pip_lock=/usr/local/share/rosml/pip.lock

# Archives of apt that earlier builds left on this builder, each by its sha256, in a folder that is in no layer. Any build may have
# written there, so only an archive counts that has the hash which signed lists say; apt itself would look at its size alone.
kept=/run/debs
archives=$scratch/archives
if [[ -d $kept ]]; then
  chmod 711 "$scratch" # apt downloads as a user of its own
  mkdir -p "$archives/partial"
  echo "Dir::Cache::Archives \"$archives\";" >>"$APT_CONFIG"
  # The settings of images say no; what is for one program goes before them.
  echo 'Binary::apt-get::APT::Keep-Downloaded-Packages "true";' >>"$APT_CONFIG"
fi

# take_kept PACKAGE…: gives apt the archives of these packages, and of what they need, that are kept.
take_kept() {
  local _address name _size hash
  if [[ ! -d $kept ]] || ! apt-get install --yes --print-uris -o Acquire::ForceHash=SHA256 "$@" >"$scratch/wanted" 2>/dev/null; then
    return # in the second case, apt_install says why
  fi
  while read -r _address name _size hash; do
    hash=${hash#SHA256:}
    if [[ $hash =~ ^[0-9a-f]{64}$ && -f $kept/$hash && ! -L $kept/$hash ]] && cp "$kept/$hash" "$archives/$name"; then
      touch "$kept/$hash" 2>/dev/null || true # used now
      sha256sum --check --status <<<"$hash  $archives/$name" || rm -f "$archives/$name" "$kept/$hash"
    fi
  done <"$scratch/wanted"
}

# keep: leaves archives for builds to come, and takes away what none used for a month. Other steps may do so at the same time; their
# processes have the same numbers. A full disk fails no build.
keep() {
  local file hash copy
  [[ -d $kept ]] || return 0
  find "$kept" -type f -mtime +30 -delete
  for file in "$archives"/*.deb; do
    [[ -f $file ]] || continue
    hash=$(sha256sum <"$file")
    hash=${hash%% *}
    if [[ -e $kept/$hash ]] || ! copy=$(mktemp "$kept/.XXXXXXXXXX"); then continue; fi
    { chmod 644 "$copy" && cp "$file" "$copy" && mv "$copy" "$kept/$hash"; } || rm -f "$copy"
  done
}

listed apt
listed pip
mapfile -t debs <"$scratch/apt"
mapfile -t -O "${#debs[@]}" debs <"$requests/apt"
mapfile -t requirements <"$scratch/pip"
if [[ " $* " == *" build "* ]]; then
  if ! command -v g++ >/dev/null || ! command -v cmake >/dev/null; then debs+=(build-essential cmake); fi
  if ! command -v colcon >/dev/null; then
    update_once
    colcon=$(apt-cache madison python3-colcon-common-extensions) # of ROS's own apt source; Debian has its parts
    if [[ -n $colcon ]]; then debs+=(python3-colcon-common-extensions); else debs+=(colcon); fi
  fi
  # What the build and the tests call colcon for: without some of these it builds nothing, or leaves no setup.bash.
  for extension in bash cmake metadata output package_information package_selection ros; do
    if ! python3 -c "import colcon_$extension" 2>/dev/null; then debs+=("python3-colcon-${extension//_/-}"); fi
  done
fi
if [[ ${#requirements[@]} -gt 0 || -s $requests/pip ]] && ! python3 -m pip --version >/dev/null 2>&1; then debs+=(python3-pip); fi

# catkin leaves Python tests out where it is missing, and manifests seldom name it.
if [[ " $* " == *" test "* && ${ROS_VERSION:-} == 1 ]]; then
  update_once
  nose=$(apt-cache search --names-only '^python3-nose$')
  if [[ -n $nose ]]; then debs+=(python3-nose); fi
fi

# In an image for programs that are built: what they need, without packages with headers.
if [[ -e /etc/dpkg/dpkg.cfg.d/rosml-runtime && ${#debs[@]} -gt 0 ]]; then
  update_once
  needed=$("$here/../ros/runtime_packages.py" "${debs[@]}")
  mapfile -t debs <<<"$needed"
fi

missing=()
for name in "${debs[@]}"; do
  [[ -n $name ]] || continue
  status=$(dpkg-query --show --showformat '${db:Status-Status}' "$name" 2>/dev/null || true)
  if [[ $status != installed ]]; then missing+=("$name"); fi
done
if [[ ${#missing[@]} -gt 0 ]]; then
  update_once
  take_kept "${missing[@]}"
  apt_install "${missing[@]}"
  keep
fi
if [[ ${#requirements[@]} -gt 0 || -s $requests/pip ]]; then
  PYTHONHASHSEED=0 "$here/pip_install.py" "$pip_lock" "$lock/pip" --requirement "$requests/pip" "${requirements[@]}"
fi
