#!/usr/bin/env bash
# A pip that refuses what contradicts constraints, for a distribution whose own only warns of it and installs: up to 20.2
# (https://pip.pypa.io/en/stable/user_guide/#changes-to-the-pip-dependency-resolver-in-20-3-2020). 22.0.2 is the oldest one that
# structure tests ran with. Environments get it as well.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

if dpkg --compare-versions "$(dpkg-query --show --showformat '${Version}' python3-pip)" ge 22; then exit; fi

folder=$(mktemp -d)
python3 -m pip download --no-deps --require-hashes --only-binary :all: --no-cache-dir --disable-pip-version-check --dest "$folder" \
  --requirement "$here/pip.txt"
wheel=$(echo "$folder"/pip-*.whl)
python3 -m pip install --no-deps --no-index --no-compile --no-cache-dir "$wheel"

# As the distribution's own pip, it leaves what apt installed where it is: by itself it would remove its files.
file=$(python3 -c 'import pip._internal.utils.misc as found; print(found.__file__)')
[[ $file == /usr/local/* ]]
sed -i '/^def is_local/,/^def /s|^        return True$|        return not path.startswith("/usr/lib/python3/")|' "$file"
grep -q 'return not path.startswith("/usr/lib/python3/")' "$file"
python3 -m compileall -q --invalidation-mode checked-hash "${file%/_internal/*}"

# venv takes the only wheel of this name there is.
for own in /usr/share/python-wheels/pip-*.whl; do
  dpkg-divert --local --rename --divert "$own.distrib" --add "$own"
done
install --mode=644 "$wheel" /usr/share/python-wheels/
rm -r "$folder"
