"""What to observe next, for lenses, robot turns and the travel of axes."""
