#!/usr/bin/env bash
# Stands in for tf2_ros' own, until it is killed. Options have names since humble, and foxy knows positions alone.
set -euo pipefail
x=0 frame='' child=''
case $ROS_DISTRO in
  foxy) [[ $# == 8 || $# == 9 ]] && x=$1 frame=${*: -2:1} child=${*: -1} ;;
  *)
    while [[ $# -gt 0 ]]; do
      case $1 in
        --x) x=$2 ;;
        --frame-id) frame=$2 ;;
        --child-frame-id) child=$2 ;;
        *) echo "error: unknown argument $1" >&2; exit 1 ;;
      esac
      shift 2
    done
    ;;
esac
printf '%.3f\n' "$x" >"/tmp/$frame-$child"
exec tail -f /dev/null
