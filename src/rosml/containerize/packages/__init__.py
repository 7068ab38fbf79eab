"""The ROS packages of a folder, and what of the folder the builder gets."""
