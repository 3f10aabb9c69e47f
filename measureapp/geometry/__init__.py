"""Rigid transforms between named frames, pinhole cameras, and fits of geometric elements."""
