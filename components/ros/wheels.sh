#!/usr/bin/env bash
# Installs ROS 2 from Python wheels below /opt/ros, for a distribution without Debian packages, and the setup files that
# stand in for what the wheels' own bootstrapper does: it executes a program anew with a library path.
#   ROS_TOOLS    Debian packages of the developers' tools, and what the wheels need of the system's Python
#   ROS_DISTRO, ROS_VERSION  the distribution, and 2
#   LOCK         the wheels with their hashes
#   UV           the program that installs them
#   PYTHON       version of the system's Python, such as 3.11
#   BYTECODE     as in components/part/bytecode.sh
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

ROS_PACKAGES=${ROS_TOOLS:?} "$here/install.sh" # there are no packages but these

prefix=/opt/ros/${ROS_DISTRO:?}
site=$prefix/lib/python${PYTHON:?}/site-packages
# Without the image's constraints: uv refuses those that name no exact version where hashes are required.
env --unset=UV_CONSTRAINT "${UV:?}" pip install --no-deps --require-hashes --only-binary :all: --link-mode copy --cache-dir /tmp/uv \
  --python "/usr/bin/python$PYTHON" --prefix "$prefix" --requirement "${LOCK:?}"
rm -f "$prefix/.lock"
OUT=/ SITE=$site PYTHON=$PYTHON "$here/../part/bytecode.sh"
printf 'ros-source %s\n' 'Python wheels' >>/usr/local/share/rosml/versions.d/ros

folders=("$prefix/lib" "$site"/ros_*.libs)
libraries=$(IFS=: && echo "${folders[*]}")
# A workspace's own setup files source those of what it was built on by these names.
cat >"$prefix/setup.sh" <<END
# ROS $ROS_VERSION $ROS_DISTRO from Python wheels: packages, libraries and programs below $prefix.
case ":\${AMENT_PREFIX_PATH:-}:" in *:$prefix:*) ;; *)
  export AMENT_PREFIX_PATH="$prefix\${AMENT_PREFIX_PATH:+:\$AMENT_PREFIX_PATH}"
  export PYTHONPATH="$site\${PYTHONPATH:+:\$PYTHONPATH}"
  export LD_LIBRARY_PATH="$libraries\${LD_LIBRARY_PATH:+:\$LD_LIBRARY_PATH}"
  export PATH="$prefix/bin:\$PATH"
  export _ROS_WHEELS_BOOTSTRAP_COMPLETE=1 # the import of ros_wheels_bootstrapper has nothing left to do
esac
END
for name in setup.bash local_setup.sh local_setup.bash; do ln -s setup.sh "$prefix/$name"; done

"$here/../build/clean.sh"
