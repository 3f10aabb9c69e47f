"""How a part stands on the table."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.data.model import Model
from measureapp.geometry.transform import RigidTransform

Vector = tuple[float, float, float]
DIGITS = 6


class PartPose(Model):
    """The nominal on the table: turned about x, then y, then z of the table, then put down.

    Frame `part`: origin in the middle of the table's top, z up, x and y as those of the guide frame at table angle 0.
    """

    rotation_deg: Vector = (0.0, 0.0, 0.0)
    position_mm: Vector | None = None  # of the nominal's origin; none: the part stands on the table, its middle above the middle

    @classmethod
    def upside_down(cls) -> PartPose:
        """Return the pose of a part on its head, in the middle of the table."""
        return cls(rotation_deg=(180.0, 0.0, 0.0))

    @classmethod
    def of(cls, part_from_nominal: RigidTransform) -> PartPose:
        """Build from a transform."""
        turn = Rotation.from_matrix(part_from_nominal.rotation).as_euler("xyz", degrees=True)
        return cls(rotation_deg=_vector(turn), position_mm=_vector(part_from_nominal.translation_mm))

    def transform(self, vertices_mm: FloatArray, nominal_frame: str = "nominal") -> RigidTransform:
        """Return part_from_nominal of a nominal with these corners (N, 3)."""
        rotation = Rotation.from_euler("xyz", self.rotation_deg, degrees=True).as_matrix()
        if self.position_mm is not None:
            return RigidTransform.from_parts(rotation, self.position_mm, "part", nominal_frame)
        turned = np.asarray(vertices_mm, float) @ rotation.T
        low, high = turned.min(axis=0), turned.max(axis=0)
        shift = [-(low[0] + high[0]) / 2.0, -(low[1] + high[1]) / 2.0, -low[2]]
        return RigidTransform.from_parts(rotation, shift, "part", nominal_frame)

    @property
    def words(self) -> str:
        """How the part stands, in words."""
        turn = "/".join(f"{angle:g}" for angle in self.rotation_deg)
        upright = "as its nominal is oriented" if not any(self.rotation_deg) else f"turned by {turn}° about x, y and z"
        if self.position_mm is None:
            return f"in the middle of the table, {upright}"
        place = ", ".join(f"{value:g}" for value in self.position_mm)
        return f"with the origin of its nominal at ({place}) mm, {upright}"


def _vector(values: FloatArray) -> Vector:
    x, y, z = (round(float(value), DIGITS) for value in values)
    return x, y, z
