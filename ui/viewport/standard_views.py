"""Directions from which a part is usually seen."""

from __future__ import annotations

Direction = tuple[float, float, float]
OPENING_DIRECTION: Direction = (-1.0, -1.1, 0.85)
STANDARD_VIEWS: dict[str, tuple[Direction, Direction]] = {  # from where, and what is up
    "front": ((0, -1, 0), (0, 0, 1)),
    "back": ((0, 1, 0), (0, 0, 1)),
    "left": ((-1, 0, 0), (0, 0, 1)),
    "right": ((1, 0, 0), (0, 0, 1)),
    "top": ((0, 0, 1), (0, 1, 0)),
    "bottom": ((0, 0, -1), (0, -1, 0)),
    "isometric": ((1, -1, 1), (0, 0, 1)),
}
