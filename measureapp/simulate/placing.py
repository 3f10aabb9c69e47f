"""A part put on the table in another orientation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.errors import InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.simulate.part import Part

UPRIGHT_DEG = (0.0, 0.0, 0.0)


def placed_from_nominal(part: Part, turn_deg: tuple[float, float, float]) -> RigidTransform:
    """Return the motion of a part rotated about x, then y, then z and put down: again standing at z = 0, its middle above the origin."""
    rotation = Rotation.from_euler("xyz", turn_deg, degrees=True).as_matrix()
    turned = part.mesh.vertices_mm @ rotation.T
    low, high = turned.min(axis=0), turned.max(axis=0)
    shift = -np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    return RigidTransform.from_parts(rotation, shift, "nominal", "nominal")


def place_part(part: Part, turn_deg: tuple[float, float, float]) -> Part:
    """Return the part in the orientation of `placed_from_nominal`; unchanged if it is upright. Raises InputError for what is no angle."""
    if turn_deg == UPRIGHT_DEG:
        return part
    if not np.isfinite(turn_deg).all():
        raise InputError("The part cannot be turned by what is no number.", "Give three angles in degrees.")
    return replace(part, mesh=part.mesh.seen_from(placed_from_nominal(part, turn_deg)))
