"""Laying measured points onto their nominal: best fits, features, and parts that repeat about an axis."""
