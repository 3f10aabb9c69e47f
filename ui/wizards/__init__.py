"""Wizards that calibrate: set up, show the board, judge the result."""
