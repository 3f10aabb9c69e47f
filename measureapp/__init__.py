"""MeasureApp: measurement of large curved parts with fringe projection; the core, without any window."""

__version__ = "0.1.0"
