"""Apps: the ROS packages of a repository as a part, and the images with it."""
