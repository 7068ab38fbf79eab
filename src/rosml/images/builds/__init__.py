"""Builds parts and ROS images with the builder, runs structure tests, and lists files. Uses join, machine and below."""
