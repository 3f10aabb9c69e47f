"""The nominal as a surface: distances from it, and the curves in which it is cut."""
