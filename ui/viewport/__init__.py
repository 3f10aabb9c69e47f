"""The 3-D view; the only package that imports VTK."""
