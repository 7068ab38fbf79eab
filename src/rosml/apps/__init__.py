"""Apps: a user's ROS packages, with the repositories that they need, as a part."""
