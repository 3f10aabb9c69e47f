"""Voxel grids: points sorted by cell, sums per voxel, and their compiled kernels."""
