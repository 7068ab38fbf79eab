#!/bin/sh
# unpinned COMMAND...: runs a command, of pip or uv for example, that may replace what parts hold. What ROS
# needs (numpy, setuptools, empy) stays as it is.
if [ $# -eq 0 ]; then
  echo "usage: unpinned COMMAND..., where the command is pip or uv and what it is to do" >&2
  exit 64
fi
constraints=/usr/local/share/rosml/constraints.txt
export PIP_CONSTRAINT=$constraints UV_CONSTRAINT=$constraints
exec "$@"
