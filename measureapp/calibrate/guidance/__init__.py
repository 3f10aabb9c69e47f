"""Guidance: what to observe next, for lenses, robot rotations and the travel of axes."""
