"""Two rays to a point, for single points outside the pixel grid."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform


def intersect_two_rays(pixels_here: FloatArray, pixels_there: FloatArray, here_from_there: RigidTransform) -> tuple[FloatArray, FloatArray]:
    """Triangulate point pairs in closed form: the middle of the shortest segment between both rays.

    Parameters
    ----------
    pixels_here, pixels_there : (N, 2) normalised (undistorted) image coordinates
    here_from_there : pose of the second camera in the first one's frame

    Returns
    -------
    points_mm : (N, 3) in the first camera's frame
    gap_mm : (N,) length of that segment: how far the rays miss each other

    References
    ----------
    .. [1] R. Hartley, P. Sturm, Computer Vision and Image Understanding 68(2), 146-157, 1997 (mid-point method).
    """
    ones = np.ones((len(pixels_here), 1))
    a = np.hstack([pixels_here, ones])
    b = here_from_there.rotate(np.hstack([pixels_there, ones]))
    origin = here_from_there.translation_mm
    aa, bb, ab = (a * a).sum(1), (b * b).sum(1), (a * b).sum(1)
    ao, bo = a @ origin, b @ origin
    determinant = aa * bb - ab**2
    s = (ao * bb - bo * ab) / determinant
    t = (ao * ab - bo * aa) / determinant
    on_a = a * s[:, None]
    on_b = origin + b * t[:, None]
    return (on_a + on_b) / 2, np.linalg.norm(on_a - on_b, axis=1)
