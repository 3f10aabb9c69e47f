"""Files of clouds, meshes and deviations; damaged files are refused with a reason."""
