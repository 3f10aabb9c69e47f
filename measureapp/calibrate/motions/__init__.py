"""Calibration of axes from board poses: rotation axis, hand-eye, linear guide, and the kinematic chain of all."""
