"""What became of every pixel of every camera on its way to a point."""

from __future__ import annotations

from enum import IntEnum


class PointState(IntEnum):
    """Why a pixel has a point, or has none; the first reason that applies."""

    VALID = 0
    NO_PHASE = 1  # look in the phase map why
    UNMATCHED = 2  # no other camera has its phase on the epipolar line
    AMBIGUOUS = 3  # its phase occurs at several places of an epipolar line, or hardly changes along it
    CONTRADICTED = 4  # another camera sees another phase there
    UNCERTAIN = 5  # its predicted standard deviation is too large
    FLYING = 6  # too few neighbours on the same surface
    OUTLIER = 7  # too far from the plane through its neighbours
    GRAZING = 8  # seen at too flat an angle
    PARTNER_GRAZING = 9  # the same for another camera that takes part
    ISLAND = 10  # in a small group without neighbours
    SEEN_BY_ANOTHER = 11  # a camera before it already has the surface
    RIM = 12  # at the border of its surface, beyond which other light is mixed in
