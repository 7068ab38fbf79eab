#!/usr/bin/env bash
# A pip that reads a wheel's metadata, and not the whole wheel, to see whether it fits: from 23.2 on pip asks the index for it by
# the name that PyPI gives it (https://peps.python.org/pep-0714/). Older ones download each release that they look at. Those up to
# 20.2 also install what contradicts constraints, and only warn
# (https://pip.pypa.io/en/stable/user_guide/#changes-to-the-pip-dependency-resolver-in-20-3-2020). Environments get this pip as well.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

if dpkg --compare-versions "$(dpkg-query --show --showformat '${Version}' python3-pip)" ge 23.2; then exit; fi

folder=$(mktemp -d)
python3 -m pip download --no-deps --require-hashes --only-binary :all: --no-cache-dir --disable-pip-version-check --dest "$folder" \
  --requirement "$here/pip.txt"
wheel=$(echo "$folder"/pip-*.whl)
# By its name: of a wheel that is named by its path, pip would keep the path, which is another one in each build.
# pip.conf, which lets pip install into /usr/local, is not there yet.
PIP_BREAK_SYSTEM_PACKAGES=1 python3 -m pip install --no-deps --no-index --find-links "$folder" --require-hashes --no-compile --no-cache-dir \
  --requirement "$here/pip.txt"

# As the distribution's own pip, it leaves what apt installed where it is: by itself it would remove its files.
file=$(python3 -c 'import pip._internal.utils.misc as found; print(found.__file__)')
[[ $file == /usr/local/* ]]
sed -i '/^def is_local/,/^def /s|^        return True$|        return not path.startswith("/usr/lib/python3/")|' "$file"
grep -q 'return not path.startswith("/usr/lib/python3/")' "$file"
# On record it has no digest then, as files have that change.
sed -i 's|^\(pip/_internal/utils/misc.py\),.*|\1,,|' "${file%/pip/_internal/*}"/pip-*.dist-info/RECORD
# Forced: python3 compiled what it imported above by the time of its installation, which differs from build to build. The seed is
# the order of sets, which Pythons up to 3.10 write as it comes.
PYTHONHASHSEED=0 python3 -m compileall -q -f --invalidation-mode checked-hash "${file%/_internal/*}"

# venv takes the only wheel of this name there is.
for own in /usr/share/python-wheels/pip-*.whl; do
  dpkg-divert --local --rename --divert "$own.distrib" --add "$own"
done
install --mode=644 "$wheel" /usr/share/python-wheels/
rm -r "$folder"
