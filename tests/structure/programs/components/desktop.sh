# shellcheck shell=bash
# desktop: rviz finds its libraries and plugins. Its window is opened in tests/e2e/test_ros.py: that takes a virtual
# display, which no image has.
: "${work:?}" # of run.sh
QT_QPA_PLATFORM=offscreen timeout 120 rosrun rviz rviz --help >"$work/rviz.txt" 2>&1 || true # it prints its help and ends with 1
grep display-config "$work/rviz.txt"
rospack plugins --attrib=plugin rviz | grep plugin_description.xml
