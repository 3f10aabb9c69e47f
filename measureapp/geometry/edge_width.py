"""Blur of an image from the width of edges in it."""

from __future__ import annotations

import numpy as np

GAUSSIAN_RISE = 2.563  # from 10 to 90 % of an edge, over the standard deviation of its blur
# Standard deviations in px as edges show them, read between pixels by Lanczos' kernel, and of pixel and lens together. A pixel alone has 0.29 px.
SHOWN_PX = (0.385, 0.41, 0.455, 0.51, 0.587, 0.757)
TRUE_PX = (0.29, 0.351, 0.416, 0.493, 0.577, 0.757)


def blur_of_edge(width_px: float) -> float:
    """Return the standard deviation of the blur in px by the width of edges from 10 to 90 %, as for ISO 12233.

    Sharp edges are sampled too coarsely to be read between pixels, which widens them. The table is of straight edges at angles of 1 to 43°
    to the pixels, blurred by a Gaussian and a square pixel (decision 15).
    """
    shown = width_px / GAUSSIAN_RISE
    return shown if shown >= SHOWN_PX[-1] else min(shown, float(np.interp(shown, SHOWN_PX, TRUE_PX)))
