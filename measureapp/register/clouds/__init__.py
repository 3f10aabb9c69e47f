"""Single clouds: what they are worth, their unit, their normals, and filters of their points."""
