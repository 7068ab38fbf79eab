#!/usr/bin/env bash
# The environment's Python is the image's own, beside which it has its packages; it imports ROS with a message, and the image's PyTorch.
# ROS's own Python does not see it.
set -euo pipefail
folder=${CHECK_ROOT:-}/opt/env/${EXPECT_ENVIRONMENT:?}
fail() { echo "$1" >&2 && exit 1; }

for variable in PATH PYTHONPATH; do
  [[ ${!variable:-} != */opt/env/* ]] || fail "$variable has the environment for everybody: ${!variable}"
done
if python3 -m site | grep /opt/env; then fail "ROS's own Python has the environment in its path"; fi

# shellcheck disable=SC1091 # it is in the image
activated=$(source "$folder/bin/activate" && command -v python) || activated=nowhere
[[ $activated == "$folder/bin/python" ]] || fail "bin/activate leads to $activated"

ros=rclpy
if [[ ${EXPECT_ROS:?} == 1 ]]; then ros=rospy; fi
modules=("$ros")
if [[ -n ${EXPECT_TORCH:-} ]]; then modules+=(torch); fi
"$folder/bin/python" - "$folder" "${modules[@]}" <<'PYTHON'
import importlib
import os
import sys

folder, *modules = sys.argv[1:]
version = "{}.{}".format(*sys.version_info[:2])
if sys.prefix != folder or version != os.environ["EXPECT_PYTHON"]:
    sys.exit(f"its Python is {version} of {sys.prefix}")
for name in (*modules, "std_msgs.msg"):
    importlib.import_module(name)
print(f"environment {folder.rpartition('/')[2]}: Python {version}, {', '.join(modules)}")
PYTHON
