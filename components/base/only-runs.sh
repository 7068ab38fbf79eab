#!/bin/bash
# In an image without compilers and headers: says so to whoever builds there, and which image has them.
#   only-runs.sh COMMAND  where a command is not found
#   only-runs.sh          as apt's hook, which hands in how apt was called; ends the installation of a compiler, which would be
#                         installed and could compile nothing, as dpkg leaves headers out here (/etc/dpkg/dpkg.cfg.d/rosml-runtime)
say() { echo "$1: this image only runs programs. To build, take the image of the same name without -run${2:-}" >&2; }

if [[ $# -gt 0 ]]; then
  case ${1##*/} in
    pip | pip3) say "$1" "; for wheels: apt-get install python3-pip" ;;
    catkin_* | colcon | cmake | ctest | make | ninja | gcc | g++ | cc | c++ | clang | clang++ | gdb | git | rosdep | vcs) say "$1" ;;
  esac
  exit
fi
called=
while read -r line && [[ -n $line ]]; do
  if [[ $line == CommandLine::AsString=* ]]; then
    called=${line#*=}
    called=" ${called//%20/ } "
  fi
done
cat >/dev/null
compiler=' (build-essential|(gcc|g\+\+|gfortran|clang)(-[0-9.]+)?) '
# The image's own build knows what it leaves out.
if [[ -z ${RUNTIME-} && $called == *' install '* && $called =~ $compiler ]]; then
  say "${BASH_REMATCH[1]}"
  exit 1
fi
