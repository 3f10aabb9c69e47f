"""Regions of the measured surface that belong to one shape, grown from a seed."""
