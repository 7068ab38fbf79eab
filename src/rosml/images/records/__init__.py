"""Records of what was built, tested, scanned and indexed, and of tags that moved; kept in the registry. Uses registry
and below."""
