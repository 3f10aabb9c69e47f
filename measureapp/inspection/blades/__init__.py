"""Blades: section curves, their mean line, chord, thickness, edges, twist and pitch."""
