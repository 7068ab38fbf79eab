"""Images to machines that have parts of them already: what is left out of a file, and how it is completed there."""
