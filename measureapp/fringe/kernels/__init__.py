"""Compiled loops over the pixels of fringe images."""
