"""Registration of the clouds of all viewpoints, merging, and surface reconstruction."""
