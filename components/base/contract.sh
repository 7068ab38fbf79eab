#!/usr/bin/env bash
# What every image promises at run time besides packages: entrypoint, workspace, users, shells, banner.
#   ADOPTED  not empty: the image is somebody else's, and what it has stays as it is
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

share=/usr/local/share/rosml
install -D --mode=644 --target-directory="$share" "$here"/{setup,shell}.bash
install --mode=755 "$here"/{banner,job}.sh "$here/stop.py" "$share/"
pip_conf=/etc/pip.conf
if [[ -n ${ADOPTED:-} ]]; then
  if [[ -e /entrypoint.sh ]]; then mv /entrypoint.sh /usr/local/lib/rosml/entrypoint.sh; fi
  # pip reads both, and takes from its own what both say.
  if [[ -e $pip_conf ]]; then pip_conf=/etc/xdg/pip/pip.conf; fi
fi
install --mode=755 "$here/entrypoint.sh" /entrypoint.sh
install -D --mode=644 "$here/pip.conf" $pip_conf
if [[ ! -e /etc/uv/uv.toml ]]; then install -D --mode=644 --target-directory=/etc/uv "$here/uv.toml"; fi
install --mode=755 "$here/unpinned.sh" /usr/local/bin/unpinned

# An image that only runs programs says so where somebody builds.
if [[ -e /etc/dpkg/dpkg.cfg.d/rosml-runtime ]]; then
  install --mode=755 "$here/only-runs.sh" "$share/"
  cat >/etc/apt/apt.conf.d/rosml-runtime <<EOF
DPkg::Pre-Install-Pkgs {"$share/only-runs.sh";};
DPkg::Tools::Options::$share/only-runs.sh::Version "2";
EOF
fi

# /tini is where users of the predecessor expect it.
if [[ ! -e /tini ]]; then ln -s /usr/bin/tini /tini; fi

# uid 1000 belongs to the user that the entrypoint creates; Ubuntu 24.04 and later ship a user `ubuntu` there.
if [[ -z ${ADOPTED:-} ]] && owner=$(getent passwd 1000); then userdel --remove "${owner%%:*}"; fi

# For the group 0 too, to which arbitrary users belong (--user 12345:0, OpenShift).
install --directory --mode=775 /docker-ros/ws

# The user that the entrypoint makes is in the group sudo and has no password. Users of somebody else's image need theirs as before.
own=
if [[ -n ${ADOPTED:-} ]]; then
  gid=$(getent group sudo | cut -d: -f3)
  own=$({
    getent group sudo | cut -d: -f4 | tr , '\n'
    awk -F: -v gid="$gid" '$4 == gid {print $1}' /etc/passwd
  } | sed -nE 's/^[a-z_][a-z0-9_-]*$/, !&/p' | tr -d '\n')
fi
echo "%sudo$own ALL=(ALL:ALL) NOPASSWD: ALL" >/etc/sudoers.d/rosml
chmod 440 /etc/sudoers.d/rosml

# /etc/bash.bashrc is for every user, also one without a home (--user 12345:0).
for file in /etc/bash.bashrc /root/.bashrc; do
  printf '\n# %s\n%s\n' 'ROS, the workspaces, and the banner (ROSML_BANNER=off: none)' "source $share/shell.bash" >>$file
done

# A login shell that is not interactive reads neither, such as bash -lc of docker exec. Other shells than bash cannot source it.
{
  # /etc/profile has set PATH: without the folder in front, another Python of the image would come first.
  if [[ -n ${ADOPTED:-} ]]; then echo "PATH=/usr/local/lib/rosml/bin:\$PATH"; fi
  echo "if [ -n \"\${BASH_VERSION-}\" ]; then . $share/shell.bash; fi"
} >/etc/profile.d/rosml.sh

# What the banner says; a part adds its own versions.
mkdir -p "$share/versions.d"
{
  sed -n 's/^PRETTY_NAME="\(.*\)"/image-os \1/p' /etc/os-release
  echo "image-architecture $(dpkg --print-architecture)"
  python3 -c 'import platform; print("image-python", platform.python_version())'
  if command -v cmake >/dev/null; then cmake --version; fi | sed -n 's/^cmake version /image-cmake /p'
} >"$share/versions.d/image"

"$here/../build/clean.sh"
