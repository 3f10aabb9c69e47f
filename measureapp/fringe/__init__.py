"""From fringe images to absolute phase."""
