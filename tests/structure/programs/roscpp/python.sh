#!/usr/bin/env bash
# A roscore, and a talker and a listener in Python.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
# shellcheck source=tests/structure/programs/roscore.sh
source "$here/../roscore.sh"
until_it_answers rostopic list
python3 "$here/node.py" talk /from_rospy "hello from rospy" &
timeout 120 python3 "$here/node.py" listen /from_rospy | sed 's/^/rospy -> rospy: /'
