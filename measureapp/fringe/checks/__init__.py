"""Whether images can be what their pattern set says."""
