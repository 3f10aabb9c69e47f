"""Result of the reconstruction for every pixel of a camera: a point, or the reason why there is none."""

from __future__ import annotations

from enum import IntEnum


class PointState(IntEnum):
    """Whether a pixel has a point, or the reason why not; the first reason that applies."""

    VALID = 0
    NO_PHASE = 1  # for the reason see `PixelState`
    UNMATCHED = 2  # no other camera has this phase on the epipolar line
    AMBIGUOUS = 3  # the phase occurs several times on an epipolar line, or hardly changes along it
    CONTRADICTED = 4  # another camera has a different phase there
    UNCERTAIN = 5  # predicted standard deviation too large
    FLYING = 6  # too few neighbours on the same surface
    OUTLIER = 7  # too far from the plane through its neighbours
    GRAZING = 8  # angle of incidence too large
    PARTNER_GRAZING = 9  # the same for another camera of the point
    ISLAND = 10  # isolated patch: a small connected component
    SEEN_BY_ANOTHER = 11  # already measured by an earlier camera
    RIM = 12  # at an occlusion edge, where light of two surfaces mixes
