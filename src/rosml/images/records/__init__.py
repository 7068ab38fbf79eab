"""Records, kept in the registry: what was built, tested, scanned and indexed, and which tags moved. Uses registry and
below."""
