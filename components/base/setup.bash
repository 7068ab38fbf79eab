# shellcheck shell=bash
# Sources ROS, and the workspaces on top of it. The entrypoint does it before every command, shell.bash in interactive
# shells (docker exec does not go through the entrypoint); ROS itself only where the environment does not have it yet.
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
