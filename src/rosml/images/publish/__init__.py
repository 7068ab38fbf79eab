"""A publishing run: its state, plan and steps; tags that move, go back and are pruned. Uses builds, scan and below."""
