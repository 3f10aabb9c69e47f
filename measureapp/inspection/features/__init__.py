"""Features: points cut around nominals or grown from seeds, fits, and constructions."""
