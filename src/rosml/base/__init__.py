"""What every other package uses: errors with their remedy, files, locks of files, moments, units, and what a terminal
shows. Imports no other package."""
