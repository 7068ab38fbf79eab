#!/bin/bash
# Says what the image holds, from what was recorded when its parts were built: imports nothing, starts nothing.
shopt -s nullglob
declare -A version
for file in /usr/local/share/rosml/versions.d/*; do
  while read -r name value; do
    if [[ $name =~ ^[A-Za-z0-9._-]+$ ]]; then version[$name]=$value; fi
  done <"$file"
done

row() { if [[ -n $2 ]]; then printf '  %-11s%s\n' "$1" "$2"; fi; }

# any NAME…: the version of the first that is here. Wheels are named after their CUDA or their processor.
any() {
  local name
  for name in "$@"; do
    if [[ -v version[$name] ]]; then echo "${version[$name]}"; return; fi
  done
}

# The middleware of ROS 2: what RMW_IMPLEMENTATION asks for, or else what ROS takes: Fast DDS, or the first that is there if an
# archive has none.
rmw() {
  local path used names=()
  for path in "/opt/ros/${ROS_DISTRO}"/share/ament_index/resource_index/rmw_typesupport/*; do
    # not one of its own: it leads to one of the others
    if [[ ${path##*/} != rmw_implementation ]]; then names+=("${path##*/}"); fi
  done
  [[ ${#names[@]} -gt 0 ]] || return
  used=rmw_fastrtps_cpp
  if [[ " ${names[*]} " != *" $used "* ]]; then used=${names[0]}; fi
  used=${RMW_IMPLEMENTATION:-$used}
  if [[ " ${names[*]} " != *" $used "* ]]; then used+=", which is NOT INSTALLED"; fi
  echo "$used (installed: ${names[*]})"
}

# What the driver says of the GPUs that the container was given; nvidia-smi would take half a second.
gpus() {
  local devices=(/dev/nvidia[0-9]*) file key value models=()
  if [[ ${#devices[@]} -eq 0 ]]; then echo none; return; fi
  for file in /proc/driver/nvidia/gpus/*/information; do
    while IFS=: read -r key value; do
      if [[ $key == Model ]]; then models+=("${value#"${value%%[![:space:]]*}"}"); fi
    done <"$file"
  done
  echo "${#devices[@]}${models[0]:+ of ${#models[@]} × ${models[0]}}"
}

echo
row ROS "${version[ros-distro]} (ROS ${version[ros-version]})"
row RMW "$(rmw)"
row OS "${version[image-os]}, ${version[image-architecture]}"
row Python "${version[image-python]}"
row CMake "${version[image-cmake]}"
row CUDA "$(any nvidia-cuda-runtime-cu12 nvidia-cuda-runtime-cu13 nvidia-cuda-runtime)"
row cuDNN "$(any nvidia-cudnn-cu12 nvidia-cudnn-cu13)"
row PyTorch "$(any torch)"
row TensorFlow "$(any tensorflow tensorflow-cpu)"
row GPUs "$(gpus)"
if [[ -e /usr/local/share/rosml/only-runs.sh ]]; then
  row Builds "nothing: this image only runs programs; the one without -run has compilers and headers"
fi
echo
