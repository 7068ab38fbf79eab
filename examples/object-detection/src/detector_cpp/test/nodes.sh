#!/usr/bin/env bash
# nodes.sh PROGRAM: the node finds the camera's squares, with each model that the image can run.
set -euo pipefail
models=$(mktemp -d)
trap 'rm -rf "$models"' EXIT
python3 -m detector.make_model "$models"
if ! python3 -c 'import onnxruntime'; then rm "$models/boxes.onnx"; fi
for model in "$models"/*; do python3 -m detector.check "$model" "$1"; done

# Without a master, a node of ROS 1 waits for one before it reads its parameters.
if [[ $ROS_VERSION == 2 ]]; then
  code=0
  "$1" --ros-args -p model:=missing.onnx || code=$?
  [[ $code == 1 ]]
fi
