#!/usr/bin/env bash
# Puts the sources into the workspace, and leaves nothing else there: the repository into src/target, upstream sources into src/upstream. Runs the repository's
# script that may change them, and takes packages out that are to be left out.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

workspace=/docker-ros/ws
mkdir -p $workspace/src/target $workspace/src/upstream
cd $workspace
for name in target upstream; do
  # Without git's folders, and without files of secrets.
  tar --create --directory "/run/sources/$name" --exclude=.git --exclude=.env . | tar --extract --directory "src/$name" --no-same-owner
done
script=$(cd /run/requests/identification && find . -type f -printf %P)
if [[ -n $script ]]; then
  # It runs at its place, which it may ask for. .dockerignore may have left it out.
  mkdir -p "$(dirname "src/target/$script")"
  cat "/run/requests/identification/$script" >"src/target/$script"
  chmod a+x "src/target/$script"
  # shellcheck source=components/containerize/image_variables.sh
  if (source "$here/image_variables.sh" && exec "src/target/$script"); then :; else
    echo "error: the script before the identification of dependencies ended with $?; the lines above say why" >&2
    exit 1
  fi
fi
if [[ -s /run/requests/blacklist ]]; then "$here/manifests.py" src /run/requests/blacklist; fi
# The rest is the base image's, and stays there.
find /docker-ros -mindepth 1 -maxdepth 1 ! -name ws -exec rm -rf {} +
find $workspace -mindepth 1 -maxdepth 1 ! -name src -exec rm -rf {} +
# What packages are built from: the same files, without what is about the repository.
cp --archive --link $workspace/src /rosml-packages
"$here/packages.sh" /rosml-packages
find /rosml-packages -type d -exec touch --date=@1767225600 {} +
# Of no moment: the same sources make the same layer of the dev image. The time is that of all parts.
find $workspace -exec touch --no-dereference --date=@1767225600 {} +
