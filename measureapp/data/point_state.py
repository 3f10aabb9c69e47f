"""State of a pixel after reconstruction."""

from __future__ import annotations

from enum import IntEnum


class PointState(IntEnum):
    """Whether a pixel has a point, or the reason why not; the first reason that applies."""

    VALID = 0
    NO_PHASE = 1  # the phase map has the reason
    UNMATCHED = 2  # no other camera has its phase on the epipolar line
    AMBIGUOUS = 3  # its phase occurs at several places of an epipolar line, or hardly changes along it
    CONTRADICTED = 4  # another camera measures another phase there
    UNCERTAIN = 5  # its predicted standard deviation is too large
    FLYING = 6  # too few neighbours on the same surface
    OUTLIER = 7  # too far from the plane through its neighbours
    GRAZING = 8  # at too oblique an incidence
    PARTNER_GRAZING = 9  # the same for another camera that takes part
    ISLAND = 10  # in an isolated patch: a small connected component
    SEEN_BY_ANOTHER = 11  # an earlier camera has measured the surface
    RIM = 12  # at a depth discontinuity, where blur mixes in light from beyond
