"""Builds parts and ROS images with the builder, runs their structure tests, and lists their files. Uses join, machine
and below."""
