"""Sections named in one word on the command line."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.inspection.surface.cutting_surface import CuttingSurface

WORDS = re.compile(r"\s*([xyzr])\s*=\s*([-+]?\d+(?:\.\d*)?)\s*")


def cutting_surface(words: str) -> CuttingSurface:
    """Return the plane at a coordinate (`z=20`), or the cylinder about the z axis of the nominal (`r=100`). Raises InputError."""
    from measureapp.inspection.surface.cutting_surface import CuttingCylinder, CuttingPlane

    match = WORDS.fullmatch(words)
    if match is None or (match[1] == "r" and float(match[2]) <= 0):
        raise InputError(f"{words!r} is not a section.", "Give a plane like x=0, y=-5 or z=20, or a cylinder about the z axis like r=100.")
    value, up = float(match[2]), np.array([0.0, 0.0, 1.0])
    if match[1] == "r":
        return CuttingCylinder.about(np.zeros(3), up, value)
    normal = np.eye(3)["xyz".index(match[1])]
    return CuttingPlane.through(value * normal, normal)
