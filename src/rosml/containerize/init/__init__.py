"""`rosml init`: what a folder with ROS packages needs, which image fits it, and the files to begin with."""
