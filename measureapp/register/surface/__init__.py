"""Surface reconstruction from the merged points, limited to the measured area."""
