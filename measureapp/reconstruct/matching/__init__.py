"""Matching a camera with all others by phase, and what the others say of its points."""
