"""Cameras and the projector: bundle adjustment, how sure it is, and whether it is still valid."""
