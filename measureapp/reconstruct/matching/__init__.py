"""Matching of a camera with all others by phase, and checks of its points by the others."""
