#!/usr/bin/env bash
# Essentials that every image has, whatever its ROS distribution.
#   NUMPY    range of numpy versions that ROS's packages work with, such as <2
#   RUNTIME  not empty: only what programs need that are built already, without compilers and headers
#   ADOPTED  not empty: the image is somebody else's, and what it has stays as it is
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

if [[ -n ${RUNTIME:-} ]]; then
  # dpkg leaves these out, also of what is installed later: packages with programs depend on some with headers, and on cmake.
  excluded=(
    '/usr/include/*' '/opt/ros/*/include/*' '/usr/lib/*.a' '/usr/lib/gcc/*' '/usr/libexec/gcc/*' /usr/bin/{cmake,ctest,cpack} '/usr/share/cmake-*'
    '/usr/share/doc/*' '/usr/share/man/*' '/usr/share/info/*'
  )
  {
    printf 'path-exclude=%s\n' "${excluded[@]}"
    echo 'path-include=/usr/share/doc/*/copyright'
  } >/etc/dpkg/dpkg.cfg.d/rosml-runtime
  packages=(
    # users, processes, locale and time zone
    sudo gosu tini locales tzdata lsb-release procps
    # how more packages get in
    curl ca-certificates gnupg
    # Python, with what PyTorch and TensorFlow need of setuptools, packaging, six and wheel, and rospy of cffi
    python3 python-is-python3 python3-setuptools python3-packaging python3-six python3-wheel python3-yaml python3-cffi
    # what compilers link programs to, and no package depends on
    libgomp1 libatomic1
  )
else
  packages=(
    # shell and editing
    bash-completion less nano vim wget curl ca-certificates openssl gnupg
    # archives, and whether another machine answers
    xz-utils zip unzip iputils-ping libcap2-bin
    # users, processes, locale and time zone
    sudo gosu tini locales tzdata lsb-release procps
    # build tools
    build-essential cmake gdb git git-lfs pkg-config ninja-build
    # Python; what PyTorch and TensorFlow need of setuptools, packaging, six and wheel is the distribution's own,
    # so that ROS's tools keep the versions they were tested with (matrix.yaml: provides)
    python3 python3-dev python3-pip python3-venv python-is-python3
    python3-setuptools python3-packaging python3-six python3-wheel python3-yaml
    # python3-nacl (of rospy's dependencies) declares it for pip, Debian does not install it: `pip check` would complain
    python3-cffi
    # a window for first experiments with X forwarding
    x11-apps
  )
fi
own_sources=()
if [[ -n ${ADOPTED:-} ]]; then
  # PATH begins with this folder: steps and nodes find the Python that ROS is for, whichever others the image has.
  mkdir -p /usr/local/lib/rosml/bin
  ln -s /usr/bin/python3 /usr/local/lib/rosml/bin/python3
  own_pip=$(compgen -G '/usr/local/bin/pip*' || true)
  own_ping=$(command -v ping || true)
  own_sources=(-o Acquire::Retries=2) # a vendor's archive may be gone for good
fi
# apt of Ubuntu 20.04 does not know this mode, and goes on with what it gets.
apt-get update -o APT::Update::Error-Mode=any "${own_sources[@]}" || {
  echo "error: apt cannot read all of its sources, which the lines above name; mend or remove them in an image of your own" >&2
  exit 1
}
# What was mended since the base image was made, whose digest moves with a pull request alone.
if [[ -z ${ADOPTED:-} ]]; then apt-get upgrade --yes; fi
apt-get install --yes "${packages[@]}" || {
  echo "error: apt cannot install what every image has, and the lines above say why; if the image holds or pins some of it, let that go" >&2
  exit 1
}
if [[ -z ${RUNTIME:-}${own_pip:-} ]]; then "$here/pip.sh"; fi
if [[ -z ${RUNTIME:-}${own_ping:-} ]]; then
  # Debian 12 gives ping NET_RAW as an effective capability, and the kernel refuses to start such a program in a container without NET_RAW, as
  # podman's are (https://github.com/louislam/uptime-kuma/issues/373). Debian 13 gives it nothing. With the permitted capability,
  # ping starts everywhere. It takes NET_RAW if it gets it, and otherwise one of the kernel's sockets for ICMP.
  setcap cap_net_raw+p "$(readlink -f "$(command -v ping)")"
fi

# git-lfs writes its settings in an order of its own every time.
if [[ -e /etc/gitconfig ]]; then
  settings=$(git config --system --list | sort)
  rm /etc/gitconfig
  while IFS='=' read -r name value; do git config --system "$name" "$value"; done <<<"$settings"
fi

constraints=/usr/local/share/rosml/constraints.txt
mkdir -p "$(dirname $constraints)"
SETUPTOOLS=$(dpkg-query --show --showformat '${Version}' python3-setuptools) "$here/constraints.sh" >$constraints

# What pip.conf and UV_CONSTRAINT name: these, and a slot for every part that there may be. A part fills its own; empty
# ones are there from the start, because pip and uv fail where a file is missing.
slots=$(dirname $constraints)/constraints.d
mkdir "$slots"
echo '-c ../constraints.txt' >"$slots/all.txt"
for slot in {01..16}; do # SLOTS in src/rosml/images/matrix/model.py
  : >"$slots/$slot.txt"
  echo "-c $slot.txt" >>"$slots/all.txt"
done

"$here/../build/clean.sh"
