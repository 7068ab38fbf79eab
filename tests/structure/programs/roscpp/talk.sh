#!/usr/bin/env bash
# A roscore, a talker and a listener in each language, and one line for each pair that exchanged a message, but for two in Python.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
# shellcheck source=tests/structure/programs/roscore.sh
source "$here/../roscore.sh"

# shellcheck disable=SC2046  # pkg-config prints words
g++ -O0 -o "$work/node" "$here/node.cpp" $(pkg-config --cflags --libs roscpp std_msgs)

until_it_answers rostopic list

python3 "$here/node.py" talk /from_rospy "hello from rospy" &
"$work/node" talk /from_roscpp "hello from roscpp" &
timeout 120 python3 "$here/node.py" listen /from_roscpp | sed 's/^/roscpp -> rospy: /'
timeout 120 "$work/node" listen /from_rospy | sed 's/^/rospy -> roscpp: /'
