"""Error motions of the table and of the guide."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.data.rig import RigDescription
from measureapp.geometry.transform import RigidTransform
from measureapp.simulate.kinematics import ARCSEC
from measureapp.simulate.options import AxisEffects

HARMONICS = (1, 2, 3, 7)  # the last one stands for the rolling elements of a bearing
SHARES = (1.0, 0.5, 0.3, 0.15)
GUIDE_WAVES = (0.5, 1.0, 2.0, 5.0)  # periods over the stroke
STEP_MM = 5e-4  # of creep


@dataclass(frozen=True, slots=True, eq=False)
class TableMotion:
    """Motion of the table's top beside its rotation: Fourier terms of the angle, zero at 0°.

    Components: rotation vector (rad), then translation (mm), in frame `table`; the rotation about the axis is the indexing error, which
    `TableErrors` has.
    """

    sine: FloatArray  # (6, H)
    cosine: FloatArray  # (6, H)

    def at(self, angle_rad: float) -> RigidTransform:
        """Return the motion at an angle, from `table` to `table`."""
        turns = np.array(HARMONICS) * angle_rad
        vector = self.sine @ np.sin(turns) + self.cosine @ (np.cos(turns) - 1.0)
        return RigidTransform.from_vector(vector[:3], vector[3:], "table", "table")


@dataclass(frozen=True, slots=True, eq=False)
class GuideMotion:
    """Pitch, yaw and roll of the slide and further straightness errors: waves over the stroke, zero at position 0."""

    amplitudes: FloatArray  # (6, W): rad, mm
    phases: FloatArray  # (6, W)
    stroke_mm: float

    def at(self, position_mm: float) -> RigidTransform:
        """Return the motion of the base at a position, from `base` to `base`."""
        turns = 2.0 * np.pi * np.array(GUIDE_WAVES) * position_mm / self.stroke_mm
        vector = (self.amplitudes * (np.sin(turns + self.phases) - np.sin(self.phases))).sum(axis=1)
        return RigidTransform.from_vector(vector[:3], vector[3:], "base", "base")


def play(before: float, goal: float, backlash: float) -> float:
    """Return how far an axis stays behind a goal: half its backlash, on the side from which it comes."""
    return float(np.copysign(0.5 * backlash, before - goal))


@dataclass(frozen=True, slots=True, eq=False)
class Settling:
    """Creep of the flange after a move: the way that is left decays exponentially."""

    way_mm: FloatArray  # (3,), in the flange's frame
    begun_s: float
    time_s: float

    def step(self, now_s: float) -> int:
        """Return the way that is left in steps of STEP_MM, so that images of one state are rendered once."""
        left = float(np.linalg.norm(self.way_mm)) * exp(-(now_s - self.begun_s) / self.time_s)
        return round(left / STEP_MM)

    def left_mm(self, now_s: float) -> FloatArray:
        """Return where the flange is relative to where it comes to rest, (3,)."""
        return self.step(now_s) * STEP_MM * self.way_mm / np.linalg.norm(self.way_mm)


def begin_settling(effects: AxisEffects, now_s: float, rng: np.random.Generator) -> Settling | None:
    """Draw the creep after a move that has just ended; None if there is none."""
    if not effects.settling_mm:
        return None
    direction = rng.standard_normal(3)
    return Settling(read_only(effects.settling_mm * direction / np.linalg.norm(direction), np.float64), now_s, effects.settling_s)


def flange_play(before_mm: FloatArray, goal_mm: FloatArray, backlash_mm: float) -> FloatArray:
    """Return how far a flange (3,) stays behind a goal, in the base's frame: half its play along each axis that moved."""
    return -0.5 * backlash_mm * np.sign(goal_mm - before_mm)


def draw_table_motion(effects: AxisEffects, rng: np.random.Generator) -> TableMotion | None:
    """Draw the error motion of a table; every kind has the range that the effects state. None if there is none."""
    coefficients = rng.normal(size=(2, 6, len(HARMONICS))) * SHARES
    wanted = [effects.table_tilt_arcsec * ARCSEC] * 2 + [0.0] + [effects.table_radial_mm] * 2 + [effects.table_axial_mm]
    if not any(wanted):
        return None
    angles = np.linspace(0.0, 2.0 * np.pi, 361)[:, None] * np.array(HARMONICS)
    course = np.einsum("ch,ah->ca", coefficients[0], np.sin(angles)) + np.einsum("ch,ah->ca", coefficients[1], np.cos(angles))
    scale = (np.array(wanted) / (0.5 * np.ptp(course, axis=1)))[:, None]
    return TableMotion(read_only(coefficients[0] * scale), read_only(coefficients[1] * scale))


def draw_guide_motion(effects: AxisEffects, rig: RigDescription, rng: np.random.Generator) -> GuideMotion | None:
    """Draw the error motion of a guide; every component has the range that the effects state. None if there is none."""
    amplitudes = rng.normal(size=(6, len(GUIDE_WAVES))) / np.array([1.0, 1.0, 2.0, 6.0])
    phases = rng.uniform(0.0, 2.0 * np.pi, amplitudes.shape)
    wanted = [effects.guide_angle_arcsec * ARCSEC] * 3 + [effects.guide_straightness_mm, 0.0, effects.guide_straightness_mm]
    if not any(wanted):
        return None
    low, high = rig.guide.limits_mm
    places = 2.0 * np.pi * np.linspace(0.0, 1.0, 201)[:, None] * np.array(GUIDE_WAVES)
    course = (amplitudes[:, None] * np.sin(places + phases[:, None])).sum(axis=2)
    scale = (np.array(wanted) / (0.5 * np.ptp(course, axis=1)))[:, None]
    return GuideMotion(read_only(amplitudes * scale), read_only(phases), high - low)
