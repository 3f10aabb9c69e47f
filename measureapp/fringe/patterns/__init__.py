"""Projected patterns, the response of the projector to them, and the predicted performance of pattern sets."""
