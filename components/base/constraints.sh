#!/usr/bin/env bash
# What pip and uv keep to in every image (pip.conf): newer packages break what the distribution's own and ROS's tools were
# built with.
#   NUMPY       range of numpy versions that ROS's packages work with, such as <2: cv_bridge's ABI, vision_opencv#535
#   SETUPTOOLS  the distribution's own
set -euo pipefail

echo "numpy${NUMPY:?}"
# colcon --symlink-install, colcon-core#696, where the distribution's own is older
if ((${SETUPTOOLS%%.*} < 80)); then echo 'setuptools<80'; fi
# message generation, rosidl#779
echo 'empy<4'
# From 4.12 on these want numpy 2, but on Python 3.8: a pip that sees that in wheels alone would download a handful of 70 MB each.
if [[ $NUMPY == '<2' ]]; then printf '%s<4.12; python_version >= "3.9"\n' opencv{,-contrib}-python{,-headless}; fi
# Sources of older ones take any PyTorch, and would be compiled for hours; newer ones say which one they need.
echo 'vllm>=0.2.6'
