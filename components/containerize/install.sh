#!/usr/bin/env bash
# Installs what the lists in /run/needed say, of the kinds that are named: build, exec, test. With build, also the tools that
# build a workspace, if the base image lacks them. Besides, what the repository asks for itself, in /run/requests: packages of
# apt and pip, and scripts before and after. If it has a lock file, apt and pip install what that has. The kind downstream is for
# packages that are in no image, on top of all that: neither counts.
#   install.sh KIND…
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"
# shellcheck source=components/ros/apt.sh
source "$here/../ros/apt.sh"
export NOT_FOUND='check its name in docker/additional-debs.txt, or in the rule of rosdep that has it'

if [[ " $* " == *" build "* && -e /etc/dpkg/dpkg.cfg.d/rosml-runtime ]]; then
  fail "the base image is only for programs that are built" "name the one without -run"
fi

# listed WAY: all that one way of rosdep installs, into $scratch/WAY.
listed() {
  local kind lists=()
  for kind in "${kinds[@]}"; do lists+=("/run/needed/$kind.$1"); done
  sort -u "${lists[@]}" >"$scratch/$1"
}

# update_once: apt's lists, if this step has none yet.
updated=
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

# follow_lock: apt takes the versions of the lock file, older ones as well.
lock=$requests/lock/$(dpkg --print-architecture)
pip_lock=/usr/local/share/rosml/pip.lock
follow_lock() {
  [[ -e $lock/apt ]] || return 0
  {
    if [[ -e /etc/apt/preferences ]]; then cat /etc/apt/preferences && echo; fi
    awk '{ printf "Package: %s\nPin: version %s\nPin-Priority: 1001\n\n", $1, $2 }' "$lock/apt"
  } >"$scratch/preferences"
  echo "Dir::Etc::Preferences \"$scratch/preferences\";" >>"$APT_CONFIG"
}

# packages: all that are installed, as the lock file has them.
packages() {
  dpkg-query --show --showformat '${db:Status-Status} ${Package} ${Architecture} ${Version}\n' |
    awk -v native="$(dpkg --print-architecture)" '$1 == "installed" { print $2 ($3 == "all" || $3 == native ? "" : ":" $3), $4 }' | sort
}

# require_locked BEFORE: of what is installed now and was not in that list, the lock file has all.
require_locked() {
  local others
  [[ -e $lock/apt ]] || return 0
  packages >"$scratch/installed"
  comm -13 "$1" "$scratch/installed" >"$scratch/added"
  others=$(grep -v -x -F -f "$lock/apt" "$scratch/added" || [[ $? == 1 ]]) # 1: the lock file has all
  [[ -z $others ]] || fail "the lock file does not have what apt installed: ${others//$'\n'/, }" \
    "the archive has other versions now, or your packages need others: write the lock file anew with --lock"
}

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

# script FILE NAME: runs a script of the repository.
script() {
  [[ -s $requests/$1 ]] || return 0
  # shellcheck source=components/containerize/image_variables.sh
  (cd "${WORKSPACE:-/}" && source "$here/image_variables.sh" && exec bash -e "$requests/$1") ||
    fail "the script $2 the installation of dependencies ended with $?" "the lines above say why"
}

use_mirror "$(sed -n 's/^ros-source //p' /usr/local/share/rosml/versions.d/ros 2>/dev/null)"
packages >"$scratch/packages"
follow_lock
rm -f "$pip_lock"
export SOURCE_DATE_EPOCH=1767225600 # as the files of all parts: nothing here depends on the commit
kinds=("$@")
if [[ -d /run/additional ]]; then additional=$(ls -A /run/additional); fi
if [[ -n ${additional:-} ]]; then
  mkdir -p /docker-ros/additional-files
  cp -R --preserve=mode,links /run/additional/. /docker-ros/additional-files
fi
if [[ -s $requests/before.sh || -s $requests/after.sh ]]; then update_once; fi # what these scripts expect
script before.sh before
if [[ -s $requests/before.sh ]]; then updated=; fi # it may have added a source
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
export PIP_BREAK_SYSTEM_PACKAGES=1 PIP_NO_CACHE_DIR=1 PIP_ROOT_USER_ACTION=ignore PIP_DISABLE_PIP_VERSION_CHECK=1
if [[ ${#requirements[@]} -gt 0 || -s $requests/pip ]]; then
  PYTHONHASHSEED=0 "$here/pip_install.py" "$pip_lock" "$lock/pip" --requirement "$requests/pip" "${requirements[@]}"
fi
script after.sh after
require_locked "$scratch/packages"

# What clean.sh takes away, and a package or a script made: folders for logs and caches, and what programs downloaded for root.
folders=$(find /var/log /var/cache -mindepth 1 -type d ! -regex '/var/cache/\(apt\|debconf\|ldconfig\|man\)\(/.*\)?' \
  -printf '%m %U:%G %p\n')
for folder in /root/.cache/pip /root/.cache/uv; do # without what the base image has: an app that removes it cannot be joined to it
  if [[ -d $folder ]]; then find "$folder" -depth -newerct "${STEP_STARTED:?}" \( ! -type d -o -empty \) -delete; fi
done
rmdir --ignore-fail-on-non-empty /root/.cache 2>/dev/null || true # there may be none
if [[ -d /root/.cache ]]; then mv /root/.cache /root/.cache-kept; fi
"$here/../build/clean.sh"
while read -r mode owner folder; do
  if [[ -n $folder ]]; then
    mkdir -p "$folder"
    chown "$owner" "$folder"
    chmod "$mode" "$folder"
    touch --date="@$SOURCE_DATE_EPOCH" "$folder"
  fi
done <<<"$folders"
if [[ -e /root/.cache-kept ]]; then mv /root/.cache-kept /root/.cache; fi
touch --date="@$SOURCE_DATE_EPOCH" /var/log /var/cache /root
