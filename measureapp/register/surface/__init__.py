"""The surface over the merged points, never where nothing was measured."""
