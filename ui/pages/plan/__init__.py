"""Page Plan: viewpoints in a table and in the cell, edited together."""
