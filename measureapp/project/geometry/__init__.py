"""Clouds, meshes and deviations in the formats of other programs; a damaged file is refused in words."""
