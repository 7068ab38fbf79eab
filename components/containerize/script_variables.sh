#!/usr/bin/env bash
# Called in the shell of the repository's scripts: runs a command of the step with the step's variables and those that scripts have set,
# without the image's
# and without the password for git.
#   script_variables.sh OF_IMAGE COMMAND…   OF_IMAGE: the file with variables of the image
set -euo pipefail
env -u GIT_HTTPS_SERVER -u GIT_HTTPS_USER -u GIT_HTTPS_PASSWORD -0 | LC_ALL=C sort -z | LC_ALL=C comm -z -23 - "$1" >"$1.kept"
mapfile -d '' -t kept <"$1.kept"
exec env -i HOME=/root LANG=C.UTF-8 "${kept[@]}" "${@:2}"
