"""Where to look from."""
