"""Images of people's own ROS packages: the packages as a part, joined with a base image."""
