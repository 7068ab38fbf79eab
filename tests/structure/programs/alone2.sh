# shellcheck shell=bash
# Sourced: what runs hereafter is in a ROS domain of its own, on this machine alone. Tests run beside one another, and images beside
# other images, in the network of one machine.
export ROS_DOMAIN_ID=$((RANDOM % 100 + 1))
# Distributions from iron on know the second variable, and newer ones warn of the first.
case ${ROS_DISTRO:?} in
  foxy | humble) export ROS_LOCALHOST_ONLY=1 ;;
  *) export ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST ;;
esac
