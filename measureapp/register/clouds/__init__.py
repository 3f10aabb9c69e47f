"""Single clouds: quality, unit check, normals, and point filters."""
