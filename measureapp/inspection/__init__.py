"""Features, dimensions, alignment and deviation."""
