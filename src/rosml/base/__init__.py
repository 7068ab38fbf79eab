"""What every other package uses: errors with a remedy, files, locks, dates, units and terminal output."""
