"""`rosml containerize` in CI: its inputs, the files of the forges, and the job."""
