"""From phase maps to points."""
