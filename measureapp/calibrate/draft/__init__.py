"""Drafts of calibrations: setup, observations, solution and verdict, and the interface of every kind of calibration."""
