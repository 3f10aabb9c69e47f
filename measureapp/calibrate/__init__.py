"""Calibration of cameras, rotation axis, hand-eye and linear guide: each Draft, Problem, solve, Solution."""
