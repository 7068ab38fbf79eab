"""What people call: commands, tables and reports. Only this package prints."""
