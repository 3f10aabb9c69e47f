"""Inspection: features, dimensions, alignment, deviation from the nominal."""
