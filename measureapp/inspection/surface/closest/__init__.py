"""Closest points of a triangle mesh, in double precision."""
