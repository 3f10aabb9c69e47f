"""Pairs of views: preparation, pairwise registration, its uncertainty, and unconstrained motions."""
