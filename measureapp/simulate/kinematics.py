"""Error models of the axes: repeatable error fields plus random scatter at every move."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.data.rig import GuideDescription, RobotDescription, TableDescription
from measureapp.geometry.transform import RigidTransform, rotation_about

WAVES = 10
POSITION_WAVELENGTH_MM = 1800.0  # of the robot's error field, which varies little around one viewpoint
TURN_WAVELENGTH = 4.0  # in units of the tool's unit axes, which change by 2 in half a turn
FIELD_SAMPLES = 4000
GUIDE_TILT_RAD = np.deg2rad(0.15)
GUIDE_SCALE_ERROR = 2e-4
STRAIGHTNESS_MM = 0.004
ARCSEC = np.deg2rad(1.0 / 3600.0)


@dataclass(frozen=True, slots=True, eq=False)
class RobotErrors:
    """Robot errors: a smooth, repeatable error of the flange as a function of the commanded pose, and scatter at every move.

    Each of the six components is a sum of plane waves over position and tool axes (random Fourier features),
    scaled so that its rms over the reach is the robot's absolute accuracy.
    """

    wave_vectors: FloatArray  # (6, K, 9)
    phases: FloatArray  # (6, K)
    amplitudes: FloatArray  # (6,), mm and rad
    repeatability_mm: float
    repeatability_rad: float

    def field(self, base_from_flange: RigidTransform) -> FloatArray:
        """Return the repeatable error (6,): translation in mm, rotation vector in rad, in the flange's frame."""
        return self.amplitudes * _waves(_pose_vector(base_from_flange)[None], self.wave_vectors, self.phases)[0]

    def true_pose(self, commanded: RigidTransform, rng: np.random.Generator) -> RigidTransform:
        """Return the true pose of the flange after a move."""
        scale = np.repeat([self.repeatability_mm, self.repeatability_rad], 3) / np.sqrt(3.0)
        error = self.field(commanded) + scale * rng.standard_normal(6)
        return commanded @ RigidTransform.from_vector(error[3:], error[:3], "flange", "flange")


def draw_robot_errors(robot: RobotDescription, rng: np.random.Generator) -> RobotErrors:
    """Draw the errors of a robot of this type; its absolute accuracy is the rms length of the error over the reach."""
    tau = 2.0 * np.pi
    wave_vectors = rng.normal(size=(6, WAVES, 9)) * np.repeat([tau / POSITION_WAVELENGTH_MM, tau / TURN_WAVELENGTH], [3, 6])
    phases = rng.uniform(0.0, tau, (6, WAVES))
    wanted = np.repeat([robot.absolute_accuracy_mm, np.deg2rad(robot.absolute_accuracy_deg)], 3) / np.sqrt(3.0)
    samples = _waves(_poses_in_reach(robot, rng), wave_vectors, phases)
    amplitudes = wanted / np.sqrt(np.mean(samples**2, axis=0))
    share = robot.repeatability_mm / robot.absolute_accuracy_mm if robot.absolute_accuracy_mm > 0 else 0.0
    return RobotErrors(
        read_only(wave_vectors),
        read_only(phases),
        read_only(amplitudes),
        robot.repeatability_mm,
        float(np.deg2rad(robot.absolute_accuracy_deg) * share),
    )


def _pose_vector(pose: RigidTransform) -> FloatArray:
    return np.concatenate([pose.translation_mm, pose.rotation[:, 2], pose.rotation[:, 0]])


def _poses_in_reach(robot: RobotDescription, rng: np.random.Generator) -> FloatArray:
    """Random pose vectors (N, 9) in front of the robot, the tool pointing away from it and down."""
    distance = rng.uniform(robot.min_reach_mm, robot.max_reach_mm, FIELD_SAMPLES)
    direction = rng.normal(size=(FIELD_SAMPLES, 3)) + np.array([1.0, 0.0, 0.3])
    position = robot.shoulder_mm + distance[:, None] * direction / np.linalg.norm(direction, axis=1, keepdims=True)
    axis = rng.normal(size=(FIELD_SAMPLES, 3)) * 0.4 + np.array([0.7, 0.0, -0.7])
    axis /= np.linalg.norm(axis, axis=1, keepdims=True)
    side = np.cross(axis, rng.normal(size=(FIELD_SAMPLES, 3)) * 0.3 + np.array([0.0, 0.0, 1.0]))
    return np.column_stack([position, axis, side / np.linalg.norm(side, axis=1, keepdims=True)])


def _waves(poses: FloatArray, wave_vectors: FloatArray, phases: FloatArray) -> FloatArray:
    """Sums of plane waves (N, 6) at pose vectors (N, 9)."""
    return np.cos(np.einsum("nj,ckj->nck", poses, wave_vectors) + phases).sum(axis=2)


@dataclass(frozen=True, slots=True, eq=False)
class GuideErrors:
    """Guide errors: true direction and scale, straightness, and scatter at every move."""

    direction: FloatArray  # (3,), unit, in the base frame
    scale: float
    wave_mm: FloatArray  # (2, 3): transverse amplitude per harmonic of the stroke
    wave_phase: FloatArray  # (2, 3)
    stroke_mm: float
    repeatability_mm: float

    def straightness_mm(self, position_mm: float) -> FloatArray:
        """Return the straightness error of the rail, (3,)."""
        turns = 2.0 * np.pi * np.arange(1, self.wave_mm.shape[1] + 1) * position_mm / self.stroke_mm
        across = (self.wave_mm * (np.sin(turns + self.wave_phase) - np.sin(self.wave_phase))).sum(axis=1)
        return np.array([across[0], 0.0, across[1]])

    def guide_from_base(self, commanded_mm: float, rng: np.random.Generator) -> RigidTransform:
        """Return the true pose of the robot base after a move."""
        reached = commanded_mm * self.scale + 0.5 * self.repeatability_mm * rng.standard_normal()
        return RigidTransform.from_parts(np.eye(3), self.direction * reached + self.straightness_mm(commanded_mm), "guide", "base")


def draw_guide_errors(guide: GuideDescription, rng: np.random.Generator) -> GuideErrors:
    """Draw the errors of a guide: direction 0.1…0.2°, scale up to 2e-4, straightness of some micrometres."""
    azimuth = rng.uniform(0.0, 2.0 * np.pi)
    off = GUIDE_TILT_RAD * rng.uniform(0.7, 1.3)
    direction = np.array([np.cos(azimuth) * np.sin(off), np.cos(off), np.sin(azimuth) * np.sin(off)])
    low, high = guide.limits_mm
    wave_mm = STRAIGHTNESS_MM * rng.normal(size=(2, 3)) / np.array([1.0, 2.0, 3.0]) / 2.0
    scale = 1.0 + GUIDE_SCALE_ERROR * rng.uniform(-1.0, 1.0)
    return GuideErrors(direction, scale, wave_mm, rng.uniform(0.0, 2.0 * np.pi, (2, 3)), high - low, guide.repeatability_mm)


@dataclass(frozen=True, slots=True, eq=False)
class TableErrors:
    """Table errors: indexing error as harmonics of the angle, zero at 0°, and scatter at every move."""

    harmonics: tuple[int, ...]
    sine_rad: FloatArray
    cosine_rad: FloatArray
    repeatability_rad: float

    def indexing_rad(self, angle_rad: float) -> float:
        """Return the repeatable error at a displayed angle."""
        turns = np.array(self.harmonics) * angle_rad
        return float(self.sine_rad @ np.sin(turns) + self.cosine_rad @ (np.cos(turns) - 1.0))

    def true_angle_rad(self, commanded_rad: float, rng: np.random.Generator) -> float:
        """Return the true angle after a move; the repeatability of the data sheet is taken as two standard deviations."""
        return commanded_rad + self.indexing_rad(commanded_rad) + 0.5 * self.repeatability_rad * float(rng.standard_normal())


def draw_table_errors(table: TableDescription, rng: np.random.Generator, harmonics: Sequence[int] = (1, 2, 5)) -> TableErrors:
    """Draw the errors of a table whose indexing error has the stated accuracy as its range (maximum minus minimum)."""
    sine, cosine = rng.normal(size=(2, len(harmonics))) / np.array(harmonics)
    drawn = TableErrors(tuple(harmonics), sine, cosine, table.repeatability_arcsec * ARCSEC)
    turn = [drawn.indexing_rad(angle) for angle in np.linspace(0.0, 2.0 * np.pi, 721)]
    scale = table.accuracy_arcsec * ARCSEC / (max(turn) - min(turn))
    return TableErrors(drawn.harmonics, read_only(sine * scale), read_only(cosine * scale), drawn.repeatability_rad)


def perturb(transform: RigidTransform, rng: np.random.Generator, *, shift_mm: float, turn_deg: float) -> RigidTransform:
    """Perturb ``transform`` by normally distributed translation and rotation of its from-frame with these rms magnitudes."""
    shift = rng.normal(size=3) * shift_mm / np.sqrt(3.0)
    turn = rng.normal(size=3) * np.deg2rad(turn_deg) / np.sqrt(3.0)
    return transform @ RigidTransform.from_vector(turn, shift, transform.from_frame, transform.from_frame)


def draw_axis(tilt_deg: float, rng: np.random.Generator) -> FloatArray:
    """Draw a unit vector at about ``tilt_deg`` from +z."""
    azimuth = rng.uniform(0.0, 2.0 * np.pi)
    tilt = np.deg2rad(tilt_deg) * rng.uniform(0.7, 1.3)
    return rotation_about([np.cos(azimuth), np.sin(azimuth), 0.0], tilt) @ np.array([0.0, 0.0, 1.0])
