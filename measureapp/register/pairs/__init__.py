"""Two views: made ready, registered to each other, and what their common surface does not hold."""
