#!/usr/bin/env bash
# Installs what the lists in /run/needed say, of the kinds that are named: build, exec, test. With build, also the tools that
# build a workspace, if the base image lacks them. Besides, what the repository asks for itself, in /run/requests: packages of
# apt and pip, and scripts before and after. If it has a lock file, apt and pip install what that has. The kind downstream is for
# packages that are in no image, on top of all that: neither counts.
#   install.sh KIND…
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
export TMPDIR=/dev/shm # in no layer; scripts of the repository may empty /tmp
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"
# shellcheck source=components/ros/apt.sh
source "$here/../ros/apt.sh"
unset TMPDIR

if [[ " $* " == *" build "* && -e /etc/dpkg/dpkg.cfg.d/rosml-runtime ]]; then
  fail "the base image is only for programs that are built" "name the one without -run"
fi

requests=/run/requests
lock=$requests/lock/$(dpkg --print-architecture)

# follow_lock: apt takes the versions of the lock file, older ones as well.
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

# copy_additional: as ADD of a Dockerfile does, folders by what is in them, and archives unpacked.
copy_additional() {
  local place=/docker-ros/additional-files folder file
  for folder in /run/additional/folders/*/; do
    mkdir -p $place
    cp -R --preserve=mode,links "$folder." $place
  done
  for file in /run/additional/files/*/*; do
    mkdir -p $place
    if tar --list --file="$file" >/dev/null 2>&1; then
      tar --extract --directory=$place --file="$file"
    else
      cp --preserve=mode "$file" $place
    fi
  done
}

# run_scripts KIND…: the repository's scripts, and the packages between them, in one shell, as in docker-ros: what a script sets or
# exports, and its folder, reach what follows. If a script ends the shell by `exit 0`, what follows has another one.
run_scripts() {
  local parts=("${before[@]}" packages "${after[@]}") reached=$scratch/reached shell=${WORKSPACE:?}/.install-dependencies.sh
  local next=0 ended place
  mkdir -p "$WORKSPACE"
  while ((next < ${#parts[@]})); do
    for ((place = next; place < ${#parts[@]}; place++)); do
      echo "echo $place >|$reached"
      if [[ ${parts[place]} == packages ]]; then
        echo "$here/script_variables.sh $scratch/of_image $here/install_packages.sh $* || exit"
      else
        cat "${parts[place]}"
      fi
      echo
    done >"$shell"
    echo "echo ${#parts[@]} >|$reached" >>"$shell"
    ended=0
    scripts_shell "$shell" || ended=$?
    next=$(<"$reached")
    if ((ended && next == ${#before[@]})); then exit "$ended"; fi # it has said why
    place=before
    if ((next > ${#before[@]})); then place=after; fi
    if ((ended)); then fail "the script $place the installation of dependencies ended with $ended" "the lines above say why"; fi
    if ((++next < ${#parts[@]})); then
      echo "the script $place the installation of dependencies called exit: what it has set does not reach what follows" >&2
    fi
  done
  rm -f "$shell"
}

# scripts_shell FILE: a shell with the variables of the image. $scratch/of_image gets those that the step does not have.
scripts_shell() (
  cd "$WORKSPACE"
  env -0 | LC_ALL=C sort -z >"$scratch/of_step"
  # shellcheck source=components/containerize/image_variables.sh
  source "$here/image_variables.sh"
  env -0 | LC_ALL=C sort -z | LC_ALL=C comm -z -23 - "$scratch/of_step" >"$scratch/of_image"
  for secret in /run/secrets/git-https-*; do # if a person allows it
    name=${secret##*/}
    name=${name//-/_}
    export "${name^^}=$(<"$secret")"
  done
  exec bash -e "$1"
)

use_mirror "$(sed -n 's/^ros-source //p' /usr/local/share/rosml/versions.d/ros 2>/dev/null)"
packages >"$scratch/packages"
follow_lock
rm -f /usr/local/share/rosml/pip.lock
# As the files of all parts: nothing here depends on the commit.
export SOURCE_DATE_EPOCH=1767225600 PIP_BREAK_SYSTEM_PACKAGES=1 PIP_NO_CACHE_DIR=1 PIP_ROOT_USER_ACTION=ignore PIP_DISABLE_PIP_VERSION_CHECK=1
shopt -s nullglob
copy_additional
before=("$requests"/before/*) after=("$requests"/after/*)
if [[ ${#before[@]} -gt 0 || ${#after[@]} -gt 0 ]]; then
  apt_update # what these scripts expect
  if [[ ${#before[@]} == 0 ]]; then export APT_UPDATED=true; fi # one before may add a source
  run_scripts "$@"
else
  "$here/install_packages.sh" "$@"
fi
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
