# shellcheck shell=bash
# Sourced by steps that work in the workspace: sources ROS and what the base image has built on it.
set +u # setup files of ROS read variables that nobody set
for _setup in "/opt/ros/${ROS_DISTRO:-}/setup.bash" "/opt/ros/${ROS_DISTRO:-}/install/setup.bash" /opt/ws_base_image/install/setup.bash \
  "${WORKSPACE:-/docker-ros/ws}/install/setup.bash"; do
  # shellcheck disable=SC1090  # only known here
  if [[ -r $_setup ]]; then source "$_setup"; fi
done
unset _setup
set -u
# An image with a ROS of its own making may not say which it is.
if [[ -z ${ROS_VERSION:-} ]]; then
  case ${ROS_DISTRO:-} in Debian | melodic | noetic | one) export ROS_VERSION=1 ;; *) export ROS_VERSION=2 ;; esac
fi
cd "${WORKSPACE:-/docker-ros/ws}" || exit

# metas_of FOLDER: what people say of packages in colcon.meta of their folder, as if they called colcon there: in $metas.
# shellcheck disable=SC2034  # whoever calls it reads it
metas_of() {
  metas=()
  if [[ -e $1/colcon.meta ]]; then metas=(--metas "$1/colcon.meta"); fi
}

# What somebody said of the number of jobs; empty if nobody did.
asked_jobs() { cat /run/secrets/parallel-jobs 2>/dev/null || true; }

# The memory that this step may have, in MiB.
memory() {
  local memory limit file
  memory=$(awk '$1 == "MemTotal:" {print int($2 / 1024)}' /proc/meminfo)
  for file in /sys/fs/cgroup/memory.max /sys/fs/cgroup/memory/memory.limit_in_bytes; do
    limit=$(cat "$file" 2>/dev/null || true)
    if [[ $limit =~ ^[0-9]{1,18}$ ]] && ((limit >> 20 < memory)); then memory=$((limit >> 20)); fi
  done
  echo "$memory"
}

# limit_jobs PACKAGES: lets colcon build some packages at the same time, by the options in $workers, and each start some
# compilers: all together as many as somebody said, or as memory has room for, with 2 GB for each. If it has room for one on each
# core, colcon does as it does: it builds as many packages as there are cores, and make looks at the load.
# shellcheck disable=SC2034  # whoever calls it reads $workers
limit_jobs() {
  local jobs memory at_once=1
  workers=()
  jobs=$(asked_jobs)
  if [[ -z $jobs ]]; then
    memory=$(memory)
    jobs=$((memory < 2000 ? 1 : memory / 2000))
    if ((jobs >= $(nproc))); then return; fi
  fi
  while (((at_once + 1) * (at_once + 1) <= jobs && at_once < $1)); do at_once=$((at_once + 1)); done
  workers=(--parallel-workers "$at_once")
  export MAKEFLAGS=-j$((jobs / at_once)) CMAKE_BUILD_PARALLEL_LEVEL=$((jobs / at_once))
}

# printed PATTERN [OPTION…]: what packages printed in the last build, if it matches.
printed() { grep -r -h --include=stdout_stderr.log -E "${@:2}" -e "$1" "$COLCON_LOG_PATH/latest_build/" || true; } # it may have no log

# unnamed: what the last build asked for and did not find, and no package.xml names. On a machine with a whole desktop it is there.
unnamed() {
  local found header name
  found=$(
    printed 'CMake Error' -A 8 | sed -n -E 's/.*package configuration file provided by "([A-Za-z0-9_.+-]+)".*/\1/p'
    printed 'fatal error: .*: No such file or directory' | sed -n -E 's|.*fatal error: ([a-z0-9_]+/[^ ]+): No such.*|\1|p'
  )
  while IFS= read -r header; do
    name=${header%%/*}
    if [[ -n $name ]] && ! grep -r -q --include=package.xml -F -e ">$name<" src && ! lost_header "$header"; then
      echo "$name"
      break
    fi
  done <<<"$found"
}

# lost_header NAME/HEADER: whether the image has NAME in a release without this header.
lost_header() {
  local prefixes prefix folder place lost=1
  IFS=: read -r -a prefixes <<<"/usr:${CMAKE_PREFIX_PATH:-}"
  for prefix in "${prefixes[@]}"; do
    folder=$prefix/include/${1%%/*}
    if [[ ! -d $folder ]]; then continue; fi
    place=$(find "$folder" -path "*/$1" -print -quit)
    if [[ -n $place ]]; then return 1; fi
    lost=0
  done
  return "$lost"
}

# first_errors: the first of a compiler in each package of the last build. More warnings may follow than people see of a step.
first_errors() { printed '^[^ ]+:[0-9]+:([0-9]+:)? (fatal )?error: ' -m 1 | head -n 5; }

# asks_git: whether a package of the last build wanted the folder .git. What a setup.py prints when colcon reads it is in no log.
asks_git() {
  printed 'fatal: not a git repository|setuptools[-_]scm was unable to detect version' | grep -q . ||
    { printed 'CalledProcessError: .*run_setup' | grep -q . &&
      grep -r -q --include=setup.py --include=setup.cfg --include=pyproject.toml -E 'use_scm_version|setuptools[-_]scm' src; }
}

# killed: the first line that says so of a program that the last build started, if there is one. Compilers, linkers, make and
# ninja say it.
killed() {
  local found
  found=$(printed '^Killed$' -m 1 -e '\*\*\* .* Error 137$' \
    -e 'Killed signal|: Killed \(program|command: Killed' -e 'terminated with signal 9|signal: 9, SIGKILL' \
    -e 'virtual memory exhausted|: out of memory allocating')
  head -n 1 <<<"$found"
}
