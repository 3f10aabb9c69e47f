"""Cleaning of depth maps on the pixel grid, and the points they leave."""
