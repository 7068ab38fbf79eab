"""A publishing run: what is due, the steps that do it, tags and how they move, go back and are pruned. Uses builds,
scan and below."""
