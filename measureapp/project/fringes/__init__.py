"""Fringe images that come from outside, the patterns they show, and what is known of cameras and projector."""
