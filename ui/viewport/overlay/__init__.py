"""What is painted over the 3-D picture: legend, flags, scale bar, triad and cube; by QPainter, so that printed pictures have it too."""
