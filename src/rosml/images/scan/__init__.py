"""Scans images: trivy, SBOMs, the policy and its outcome. Uses records, registry and below."""
