"""The kinematic chain of the whole rig as one adjustable model of observed board poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.calibrate.axis_motion import across
from measureapp.calibrate.board_pose import BoardPose
from measureapp.calibrate.least_squares import Minimum, minimise_residuals
from measureapp.calibrate.poses import change_between, inverted, moved, stacked
from measureapp.progress import Progress

POSE = 6
TURN_STEP, LENGTH_STEP, SCALE_STEP = 1e-6, 1e-4, 1e-6
POSE_STEPS = (TURN_STEP,) * 3 + (LENGTH_STEP,) * 3
POSE_LABELS = ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad", "x_mm", "y_mm", "z_mm")


@dataclass(frozen=True, slots=True, eq=False)
class AxisNoise:
    """Standard deviations the chain expects of the axes."""

    robot_mm: float = 0.3  # absolute pose error of the robot, per pose and coordinate
    robot_rad: float = float(np.deg2rad(0.02))
    table_rad: float = float(np.deg2rad(10 / 3600))


@dataclass(frozen=True, slots=True, eq=False)
class ChainState:
    """All quantities of the chain."""

    flange_from_camera: FloatArray  # (4, 4)
    guide_direction: FloatArray  # (3,), unit, in base
    guide_scale: float
    axis_point_mm: FloatArray  # (3,), in guide
    axis_direction: FloatArray  # (3,), unit, in guide
    guide_from_board: FloatArray  # (4, 4), at table angle 0
    robot_changes: FloatArray  # (G, 6), error of each robot pose in its flange frame
    table_changes: FloatArray  # (K,), error of each table angle


@dataclass(frozen=True, slots=True)
class Free:
    """Which parts of the chain are estimated; the board's place always is."""

    hand_eye: bool = True
    guide: bool = True
    axis: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class Chain:
    """Observed board poses with the read-backs they were taken at."""

    base_from_flange: FloatArray  # (N, 4, 4)
    guide_mm: FloatArray  # (N,)
    table_rad: FloatArray  # (N,)
    camera_from_board: FloatArray  # (N, 4, 4)
    roots: FloatArray  # (N, 6, 6), upper triangular roots of the poses' information
    robot_group: IntArray  # (N,), which robot pose; equal poses share their error
    table_group: IntArray  # (N,), which table angle
    noise: AxisNoise
    free: Free

    @property
    def labels(self) -> tuple[str, ...]:
        """Names of the parameters that matter to the user; those of robot and table errors follow without names."""
        names: tuple[str, ...] = ()
        if self.free.hand_eye:
            names += tuple(f"hand_eye.{label}" for label in POSE_LABELS)
        if self.free.guide:
            names += ("guide.direction_1_rad", "guide.direction_2_rad", "guide.scale")
        if self.free.axis:
            names += ("axis.direction_1_rad", "axis.direction_2_rad", "axis.point_1_mm", "axis.point_2_mm")
        return names + tuple(f"board.{label}" for label in POSE_LABELS)

    @property
    def robot_poses(self) -> int:
        """How many different robot poses there are."""
        return int(self.robot_group.max()) + 1

    @property
    def table_angles(self) -> int:
        """How many different table angles there are, or 0 where their errors are not estimated."""
        return int(self.table_group.max()) + 1 if self.free.axis else 0

    def predicted(self, state: ChainState) -> FloatArray:
        """Return camera_from_board (N, 4, 4) by the chain."""
        shift = np.tile(np.eye(4), (len(self.guide_mm), 1, 1))
        shift[:, :3, 3] = self.guide_mm[:, None] * (state.guide_direction * state.guide_scale)
        errors = moved(np.tile(np.eye(4), (len(state.robot_changes), 1, 1)), state.robot_changes)[self.robot_group]
        guide_from_camera = shift @ self.base_from_flange @ errors @ state.flange_from_camera
        return np.asarray(inverted(guide_from_camera) @ self._turned(state) @ state.guide_from_board)

    def _turned(self, state: ChainState) -> FloatArray:
        angles = self.table_rad + (state.table_changes[self.table_group] if self.table_angles else 0.0)
        turned = np.tile(np.eye(4), (len(angles), 1, 1))
        turned[:, :3, :3] = Rotation.from_rotvec(angles[:, None] * state.axis_direction).as_matrix()
        turned[:, :3, 3] = state.axis_point_mm - turned[:, :3, :3] @ state.axis_point_mm
        return turned

    def residuals(self, state: ChainState) -> FloatArray:
        """Return the whitened residuals: poses (6 N), robot errors (6 G), table errors (K)."""
        poses = (self.roots @ change_between(self.camera_from_board, self.predicted(state))[..., None]).ravel()
        robot = state.robot_changes / np.array([self.noise.robot_rad] * 3 + [self.noise.robot_mm] * 3)
        table = state.table_changes / self.noise.table_rad
        return np.concatenate([poses, robot.ravel(), table])

    def moved(self, state: ChainState, step: FloatArray) -> ChainState:
        """Return the state after a step in the order of `labels`, then robot and table errors."""
        taken = iter(np.split(step, np.cumsum(self._lengths())[:-1]))
        changed = state
        if self.free.hand_eye:
            changed = replace(changed, flange_from_camera=moved(state.flange_from_camera, next(taken)))
        if self.free.guide:
            part = next(taken)
            direction = _tilted(state.guide_direction, part[:2])
            changed = replace(changed, guide_direction=direction, guide_scale=state.guide_scale + float(part[2]))
        if self.free.axis:
            part = next(taken)
            point = state.axis_point_mm + part[2:] @ across(state.axis_direction)
            changed = replace(changed, axis_direction=_tilted(state.axis_direction, part[:2]), axis_point_mm=point)
        return replace(
            changed,
            guide_from_board=moved(state.guide_from_board, next(taken)),
            robot_changes=state.robot_changes + next(taken).reshape(-1, POSE),
            table_changes=state.table_changes + next(taken),
        )

    def _lengths(self) -> list[int]:
        parts = [(self.free.hand_eye, POSE), (self.free.guide, 3), (self.free.axis, 4), (True, POSE)]
        return [length for used, length in parts if used] + [POSE * self.robot_poses, self.table_angles]

    def adjusted(self, start: ChainState, progress: Progress | None = None) -> Minimum[ChainState]:
        """Minimise all residuals from ``start``."""
        named, robot, table = len(self.labels), self.robot_poses, self.table_angles
        steps: list[float] = [*POSE_STEPS] if self.free.hand_eye else []
        steps += [TURN_STEP, TURN_STEP, SCALE_STEP] if self.free.guide else []
        steps += [TURN_STEP, TURN_STEP, LENGTH_STEP, LENGTH_STEP] if self.free.axis else []
        steps += [*POSE_STEPS, *(POSE_STEPS * robot), *((TURN_STEP,) * table)]
        together = [np.arange(robot) * POSE + named + part for part in range(POSE)]
        if table:
            together.append(np.arange(table) + named + POSE * robot)
        return minimise_residuals(
            start, self.residuals, self.moved, np.array(steps), together=together, rows_of=self._rows_of, progress=progress
        )

    def _rows_of(self, parameter: int) -> BoolArray:
        """Return the residuals that the error of one robot pose or table angle touches."""
        count, robot, table = len(self.guide_mm), self.robot_poses, self.table_angles
        rows = np.zeros(POSE * count + POSE * robot + table, bool)
        index = parameter - len(self.labels)
        group, number = (self.robot_group, index // POSE) if index < POSE * robot else (self.table_group, index - POSE * robot)
        rows[: POSE * count] = np.repeat(group == number, POSE)
        rows[POSE * count + index] = True
        return rows

    def freedom(self) -> int:
        """Return the degrees of freedom: robot and table errors count as observed by their priors."""
        return POSE * len(self.guide_mm) - len(self.labels)


def _tilted(direction: FloatArray, change: FloatArray) -> FloatArray:
    tilted = direction + change @ across(direction)
    return np.asarray(tilted / np.linalg.norm(tilted))


def roots_of(poses: Sequence[BoardPose]) -> FloatArray:
    """Return the upper triangular roots (N, 6, 6) of the information of poses."""
    return np.array([np.linalg.cholesky(pose.information).T for pose in poses])


def poses_of(poses: Sequence[BoardPose]) -> FloatArray:
    """Return camera_from_board (N, 4, 4)."""
    return stacked(pose.camera_from_board for pose in poses)


def groups_of(values: FloatArray, tolerance: FloatArray | float) -> IntArray:
    """Number equal rows of ``values`` (N, D): rows within ``tolerance`` of the first of a group belong to it."""
    firsts: list[FloatArray] = []
    numbers = []
    for row in values:
        found = next((index for index, first in enumerate(firsts) if np.all(np.abs(row - first) <= tolerance)), None)
        if found is None:
            firsts.append(row)
            found = len(firsts) - 1
        numbers.append(found)
    return np.array(numbers, np.intp)
