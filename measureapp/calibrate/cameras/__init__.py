"""Cameras and the projector: bundle adjustment, its uncertainty, and the validity of a calibration."""
