"""What changes until a rig is warm: principal points, focal lengths, the projector's image, the robot."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import exp

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.rig import RigDescription
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.simulate.effects.sharpness import FULL_WIDTH_PX
from measureapp.simulate.options import WorldOptions

FULL_PROJECTOR_PX = 1024


@dataclass(frozen=True, slots=True, eq=False)
class Warmth:
    """Changes from cold to warm, of which a share has happened at any time.

    The true calibration is that of the state in which the world begins; what follows is drift.
    """

    cameras: Mapping[str, FloatArray]  # (3,): principal point x, y in px, relative focal length
    projector_px: FloatArray  # (2,)
    robot_mm: FloatArray  # (3,), of the flange in its own frame
    seconds: float  # time constant
    begun: float  # share of the way at the beginning

    def since_beginning(self, elapsed_s: float) -> float:
        """Return the share of the whole way that was covered since the world began, 0…1."""
        return (1.0 - self.begun) * (1.0 - exp(-elapsed_s / self.seconds))

    def camera(self, name: str, pinhole: PinholeCamera, elapsed_s: float) -> PinholeCamera:
        """Return a camera as it is after some time."""
        x, y, focal = self.since_beginning(elapsed_s) * self.cameras[name]
        return shifted(pinhole, x, y, focal)

    def projector(self, pinhole: PinholeCamera, elapsed_s: float) -> PinholeCamera:
        """Return the projector as it is after some time."""
        x, y = self.since_beginning(elapsed_s) * self.projector_px
        return shifted(pinhole, x, y, 0.0)

    def flange_mm(self, elapsed_s: float) -> FloatArray:
        """Return the displacement of the flange after some time, (3,)."""
        return np.asarray(self.since_beginning(elapsed_s) * self.robot_mm)


def shifted(pinhole: PinholeCamera, x_px: float, y_px: float, focal: float) -> PinholeCamera:
    """Return a pinhole camera with its principal point displaced and its focal length changed by a share."""
    matrix = pinhole.matrix.copy()
    matrix[:2, 2] += (x_px, y_px)
    matrix[[0, 1], [0, 1]] *= 1.0 + focal
    return replace(pinhole, matrix=matrix)


def draw_warmth(options: WorldOptions, rig: RigDescription, rng: np.random.Generator) -> Warmth | None:
    """Draw the changes until a rig is warm; None if there are none. Cameras have half of their change in common."""
    effects = options.warmth
    common = rng.standard_normal(3)
    own = {camera.name: (common + rng.standard_normal(3)) / np.sqrt(2.0) for camera in rig.cameras}
    projector, robot = rng.standard_normal(2), rng.standard_normal(3)
    if not (effects.camera_drift_px or effects.focal_drift or options.projector.drift_px or options.motions.robot_growth_mm):
        return None
    cameras = {
        camera.name: own[camera.name] * [*[effects.camera_drift_px * camera.width_px / FULL_WIDTH_PX] * 2, effects.focal_drift]
        for camera in rig.cameras
    }
    return Warmth(
        cameras,
        projector * options.projector.drift_px * rig.projector.width_px / FULL_PROJECTOR_PX,
        robot / np.linalg.norm(robot) * options.motions.robot_growth_mm,
        60.0 * effects.minutes,
        effects.warm_share,
    )
