"""Calibration wizards: set up, show the board, evaluate the result."""
