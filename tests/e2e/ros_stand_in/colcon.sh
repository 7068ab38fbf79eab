#!/usr/bin/env bash
# Stands in for colcon in a workspace of ROS 2: what it would install, with messages that Python has, Python nodes that run,
# and C++ nodes that only say what they would: there is no rclcpp to compile them with.
set -euo pipefail
[[ $1 == build && " $* " == *' --symlink-install '* ]]
base=$PWD/install
mkdir -p "$base/python"
for description in src/*/package.xml; do
  folder=$PWD/${description%/*}
  name=$(python3 -c 'import sys, xml.etree.ElementTree as e; print(e.parse(sys.argv[1]).findtext("name"))' "$description")
  mkdir -p "$base/share/$name" "$base/lib/$name"
  for message in "$folder"/msg/*.msg; do
    [[ -e $message ]] || continue
    mkdir -p "$base/python/$name"
    message=${message##*/}
    printf 'from rclpy import Message\nclass %s(Message):\n    pass\n' "${message%.msg}" >"$base/python/$name/msg.py"
  done
  if [[ -e $folder/setup.py ]]; then
    ln -s "$folder/$name" "$base/python/$name"
    sed -n -E 's/.*console_scripts.*"(\w+) = ([a-z_.]+):(\w+)".*/\1 \2 \3/p' "$folder/setup.py" | while read -r node module main; do
      printf '#!/usr/bin/env python3\nfrom %s import %s\n%s()\n' "$module" "$main" "$main" >"$base/lib/$name/$node"
    done
  else
    sed -n -E 's/^add_executable\((\w+) .*/\1/p' "$folder/CMakeLists.txt" | while read -r node; do
      printf '#!/bin/sh\necho "%s: c++"\n' "$node" >"$base/lib/$name/$node"
    done
  fi
  find "$base/lib" -type f -exec chmod +x {} +
done
cat >"$base/setup.bash" <<END
export AMENT_PREFIX_PATH=$base\${AMENT_PREFIX_PATH:+:\$AMENT_PREFIX_PATH}
export PYTHONPATH=$base/python\${PYTHONPATH:+:\$PYTHONPATH}
END
