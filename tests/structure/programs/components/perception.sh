# shellcheck shell=bash
# perception: a picture is sent through image_transport's republisher, and arrives; a laser scan becomes points.
: "${here:?}" "${work:?}" # of run.sh
rosrun image_transport list_transports | grep image_transport/raw
rosrun image_transport republish raw in:=/sent raw out:=/received >"$work/republish.log" 2>&1 &
timeout 120 python3 "$here/picture.py"
# Debian's perception has messages of PCL alone (docs/limits.md).
if [[ $ROS_DISTRO != Debian ]]; then rospack find pcl_conversions; fi
