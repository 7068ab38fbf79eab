"""What is measured of this project, apart from it: the generator, an image beside one with `RUN pip install`, many tags, and a
run that finds nothing to do. `make bench` calls it; nothing of the product imports it."""
