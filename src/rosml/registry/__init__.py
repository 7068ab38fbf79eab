"""A registry: its protocol, a client that reads and writes in bulk, credentials and certificates. Uses base."""
