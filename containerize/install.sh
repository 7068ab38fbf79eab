#!/bin/sh
# Installs rosml of this checkout into a folder: install.sh FOLDER
#
# All packages come by hash and as wheels, also the one that makes rosml's own wheel. What runs here gets no secret of the job.
set -eu
unset PYTHONPATH PYTHONHOME # a ROS workspace sets them, and they change what Python imports
project=$(dirname "$(readlink -f "$0")")/..
folder=$1
[ ! -x "$folder/bin/rosml" ] || exit 0
if ! python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))'; then
  printf 'error: there is no python3 of version 3.11 or newer\nremedy: install Python 3.11 or newer on this runner\n' >&2
  exit 1
fi
python3 -m venv "$folder"

set -- # the variables that pip gets: where programs and its index are
for name in PATH HOME TMPDIR http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY SSL_CERT_FILE \
  REQUESTS_CA_BUNDLE $(env | sed -n 's/^\(PIP_[A-Z_]*\)=.*/\1/p'); do
  eval "[ -z \"\${$name+set}\" ] || set -- \"\$@\" \"$name=\$$name\""
done
env -i "$@" "$folder/bin/pip" install --quiet --disable-pip-version-check --require-hashes --only-binary :all: \
  --requirement "$project/tools/requirements-build.txt"
env -i "$@" "$folder/bin/pip" install --quiet --disable-pip-version-check --no-index --no-deps --no-build-isolation "$project"
