"""The base image of an app: its reference, add-ons, and rosdep's lists."""
