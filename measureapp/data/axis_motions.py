"""Error motions of rotary table and linear guide: how table top and slide move beside turning and sliding, as functions of the axis."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.geometry.transform import RigidTransform, rotation_about

ORDERS = 6  # of the Fourier terms of a table
WAVES = 10  # half waves of a guide over its stroke
TABLE, GUIDE = 5, 6  # components
ARCSEC = float(np.deg2rad(1 / 3600))
STEPS = 360  # of the angle and of the slide, over which amplitudes are taken


def fourier(angles_rad: FloatArray) -> FloatArray:
    """Return the terms (N, 2 ORDERS) of a table at angles (N,): cos θ, sin θ, cos 2θ, …"""
    turns = np.atleast_1d(angles_rad)[:, None] * np.arange(1, ORDERS + 1)
    return np.stack([np.cos(turns), np.sin(turns)], axis=2).reshape(len(turns), -1)


def half_waves(positions_mm: FloatArray, limits_mm: FloatArray) -> FloatArray:
    """Return the terms (N, WAVES) of a guide at positions (N,): cos π u, cos 2π u, …, where u runs from 0 to 1 between its ``limits_mm``."""
    low, high = limits_mm
    share = (np.atleast_1d(positions_mm) - low) / max(float(high - low), 1e-9)
    return np.cos(np.pi * share[:, None] * np.arange(1, WAVES + 1))


@dataclass(frozen=True, slots=True, eq=False)
class AxisMotions:
    """Error motions as estimated by the rig calibration; constants and trends belong to axis, direction and scale.

    The table's (tilt about x and y in rad, radial along x and y and axial in mm; ISO 230-7) are Fourier terms of its angle, in axes of their own
    about a point of the axis. The slide's (pitch, roll and yaw as turns about x, y and z in rad, shifts in mm) are half waves over the stroke, in
    the axes of the guide frame about the robot's base.
    """

    point_mm: FloatArray  # (3,), in the guide frame, about which the table tilts
    axes: FloatArray  # (3, 3), rows: x, y and the table's axis, in the guide frame
    limits_mm: FloatArray  # (2,), of the guide
    table: FloatArray  # (TABLE, 2 ORDERS), rad and mm
    guide: FloatArray  # (GUIDE, WAVES), rad and mm
    table_sigma: FloatArray  # (TABLE,), standard deviation that was expected of each motion after the calibration, where no pose shows it
    guide_sigma: FloatArray  # (GUIDE,)
    explained_mm: float = 0.0  # rms displacement by which they move the board between the sightings of the calibration

    def __post_init__(self) -> None:
        shapes = {"point_mm": (3,), "axes": (3, 3), "limits_mm": (2,), "table": (TABLE, 2 * ORDERS), "guide": (GUIDE, WAVES)}
        for name, shape in (shapes | {"table_sigma": (TABLE,), "guide_sigma": (GUIDE,)}).items():
            object.__setattr__(self, name, read_only(getattr(self, name), np.float64, shape))

    def table_motion(self, angle_rad: float) -> RigidTransform:
        """Return the motion of the table top at an angle, in the guide frame: guide ← guide."""
        motion = self.table @ fourier(np.array([angle_rad]))[0]
        turn = self.axes[:2].T @ motion[:2]
        rotation = rotation_about(turn, float(np.linalg.norm(turn))) if turn.any() else np.eye(3)
        return RigidTransform.from_parts(rotation, self.point_mm - rotation @ self.point_mm + self.axes.T @ motion[2:], "guide", "guide")

    def guide_motion(self, position_mm: float) -> RigidTransform:
        """Return the motion of the robot's base at a position of the guide: base ← base."""
        motion = self.guide @ half_waves(np.array([position_mm]), self.limits_mm)[0]
        return RigidTransform.from_vector(motion[:3], motion[3:], "base", "base")

    @property
    def amplitudes(self) -> dict[str, float]:
        """Half the range of each kind over a turn or the stroke, in the direction in which it is largest; mm and rad.

        Radial motion and tilt that turn with the table are no error motions: they are how eccentric and how level the part stands (ISO 230-7).
        """
        return _amplitudes(self)

    @property
    def table_words(self) -> str:
        """The table's error motions in words."""
        found = self.amplitudes
        return f"radial ± {_um(found['radial'])}, axial ± {_um(found['axial'])}, tilt ± {found['tilt'] / ARCSEC:.1f}″"

    @property
    def guide_words(self) -> str:
        """The guide's error motions in words; empty where it was not moved."""
        if not self.guide.any():
            return ""
        found = self.amplitudes
        return f"straightness ± {_um(found['straightness'])}, pitch, yaw and roll ± {found['angles'] / ARCSEC:.1f}″"

    @property
    def sentences(self) -> list[str]:
        """Motions and their share in sentences."""
        guide = f"error motions of the guide: {self.guide_words}"
        share = (
            f"they move the board by {_um(self.explained_mm)} rms between the views of the calibration; positions are corrected for them"
        )
        return [f"error motions of the table: {self.table_words}", *([guide] if self.guide_words else []), share]


@lru_cache(maxsize=4)
def _amplitudes(motions: AxisMotions) -> dict[str, float]:
    """Return `AxisMotions.amplitudes`; the window asks for those of one calibration again and again."""
    turned = np.vstack([_without_setting(motions.table[:2]), _without_setting(motions.table[2:4]), motions.table[4:]])
    turned = turned @ fourier(np.linspace(0, 2 * np.pi, STEPS, endpoint=False)).T
    slid = motions.guide @ half_waves(np.linspace(motions.limits_mm[0], motions.limits_mm[1], STEPS), motions.limits_mm).T
    parts = {"radial": turned[2:4], "axial": turned[4:], "tilt": turned[:2], "straightness": slid[[3, 5]], "angles": slid[:3]}
    return {name: _half_range(course) for name, course in parts.items()}


def _without_setting(motion: FloatArray) -> FloatArray:
    """Return two components (2, 2 ORDERS) across the axis without the part of order 1 that turns with the table."""
    (x_cosine, x_sine), (y_cosine, y_sine) = motion[:, :2]
    along, across = (x_cosine + y_sine) / 2, (y_cosine - x_sine) / 2
    left = motion.copy()
    left[:, :2] -= [[along, -across], [across, along]]
    return left


def _half_range(course: FloatArray) -> float:
    """Return half the range of a course (C, N) in the direction in which it is largest, by the greatest distance of two of its points."""
    squared = sum((component[:, None] - component) ** 2 for component in course)
    return float(np.sqrt(np.max(squared)) / 2)


def _um(value_mm: float) -> str:
    return f"{1000 * value_mm:.1f} µm"
