"""The 3-D view; the only room that imports VTK."""
