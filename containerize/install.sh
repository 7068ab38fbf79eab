#!/bin/sh
# Installs rosml of this checkout into a folder, with packages by hash: install.sh FOLDER
set -eu
unset PYTHONPATH PYTHONHOME # a ROS workspace sets them, and they change what Python imports
project=$(dirname "$(readlink -f "$0")")/..
if [ ! -x "$1/bin/rosml" ]; then
  if ! python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))'; then
    printf 'error: there is no python3 of version 3.11 or newer\nremedy: install Python 3.11 or newer on this runner\n' >&2
    exit 1
  fi
  python3 -m venv "$1"
  "$1/bin/pip" install --quiet --disable-pip-version-check --require-hashes --requirement "$project/tools/requirements-app.txt"
  "$1/bin/pip" install --quiet --disable-pip-version-check --no-deps "$project"
fi
