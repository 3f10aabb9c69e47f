"""Bringing the clouds of all views together, and the surface over them."""
