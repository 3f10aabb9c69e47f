"""Alignment of measured points to their nominal: best fit, by features, and cyclic parts."""
