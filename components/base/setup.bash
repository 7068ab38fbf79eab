# shellcheck shell=bash
# Sources ROS, and the workspaces on top of it. The entrypoint does it before every command, shell.bash in interactive
# shells (docker exec does not go through the entrypoint); ROS itself only where the environment does not have it yet.

# Each node of roscpp takes 8 bytes for every file that it may open, and the daemon of ros2 in humble closes each of them. Some
# systems let a container open a thousand million, which is 8 GB a node. The kernel's own default is 2^20.
while read -r _rosml_first _rosml_second _ _rosml_soft _rosml_hard _; do
  if [[ "$_rosml_first $_rosml_second" != "Max open" ]]; then continue; fi
  if [[ $_rosml_soft == unlimited || $_rosml_soft -gt 1048576 ]]; then ulimit -Sn 1048576; fi
  if [[ $_rosml_hard == unlimited || $_rosml_hard -gt 1048576 ]]; then ulimit -Hn 1048576; fi
done </proc/self/limits
unset _rosml_first _rosml_second _rosml_soft _rosml_hard

_rosml_distro=
if [[ -r /usr/local/share/rosml/versions.d/ros ]]; then
  read -r _ _rosml_distro </usr/local/share/rosml/versions.d/ros # ros-distro NAME
fi
for _rosml_setup in \
  "/opt/ros/$_rosml_distro/setup.bash" \
  /opt/ws_base_image/install/setup.bash \
  "${WORKSPACE:-/docker-ros/ws}/devel/setup.bash" \
  "${WORKSPACE:-/docker-ros/ws}/install/setup.bash"; do
  if [[ ! -r $_rosml_setup ]]; then continue; fi
  if [[ $_rosml_setup == "/opt/ros/$_rosml_distro/"* &&
    (":${AMENT_PREFIX_PATH-}:" == *":/opt/ros/$_rosml_distro:"* ||
      ":${ROS_PACKAGE_PATH-}:" == *":/opt/ros/$_rosml_distro/share:"*) ]]; then continue; fi
  # Not from our standard input, which is the command's.
  # shellcheck disable=SC1090  # the paths are only known at run time
  source "$_rosml_setup" "" </dev/null
done
unset _rosml_setup _rosml_distro
