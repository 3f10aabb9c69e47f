"""Cleaning of depth maps on the pixel grid, and clouds of the points that are left."""
