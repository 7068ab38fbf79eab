"""What every other package uses: errors with a remedy, files, file locks, dates, units and terminal output. It imports no
other package."""
