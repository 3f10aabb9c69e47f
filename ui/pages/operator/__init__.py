"""Operator mode: a workspace of its own, which fills the window."""
