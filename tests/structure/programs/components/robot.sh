# shellcheck shell=bash
# robot: the states of a robot's joints are published from its description; transforms are looked up.
: "${here:?}" "${work:?}" # of run.sh
rosparam set robot_description '<robot name="arm"><link name="base"/><link name="hand"/><joint name="elbow"
  type="revolute"><parent link="base"/><child link="hand"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint></robot>'
rosrun joint_state_publisher joint_state_publisher >"$work/joints.log" 2>&1 &
rosrun tf2_ros static_transform_publisher 1 2 3 0 0 0 1 base camera >"$work/tf.log" 2>&1 &
timeout 120 rostopic echo -n 1 /joint_states | grep elbow
timeout 120 python3 "$here/transform.py"
