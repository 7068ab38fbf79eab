"""Environments: Python packages beside ROS, at a prefix of their own."""
