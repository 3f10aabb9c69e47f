"""Least-squares adjustment of the kinematic chain of the whole rig to observed board poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray, IntArray
from measureapp.calibrate.boards.pose import BoardPose
from measureapp.calibrate.least_squares import Minimum, NormalEquations, minimise
from measureapp.calibrate.motions.axis_motion import perpendicular_basis
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.motions.chain_derivatives import derivatives
from measureapp.calibrate.motions.chain_state import POSE, ChainState
from measureapp.calibrate.motions.error_motions import MotionModel, MovedAxes
from measureapp.calibrate.motions.slide_noise import add_place_covariance, stop_covariance
from measureapp.calibrate.poses import apply_changes, change_between, invert_poses, stack_matrices
from measureapp.progress import Progress

POSE_LABELS = ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad", "x_mm", "y_mm", "z_mm")


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
    roots: FloatArray  # (N, 6, 6), upper triangular roots of the poses' information, the own errors of slide and stops counted
    robot_group: IntArray  # (N,), which approach of the robot; sightings of one approach have its error in common
    table_group: IntArray  # (N,), which table angle
    noise: AxisNoise
    free: Free
    camera_jacobian: FloatArray | None = None  # (N, 6, C), change of the observed poses with the parameters of the cameras
    camera_covariance: FloatArray | None = None  # (C, C), where the cameras are estimated: their covariance before
    slide: FloatArray | None = None  # (N, 3, 3), the part of slide and stops in the covariance of the poses' places
    motions: MotionModel | None = None  # error motions to estimate; None: none

    def with_stops(self, stop_mm: float) -> Chain:
        """Return this chain, which allows for none yet, with a scatter of every stop."""
        added = stop_covariance(stop_mm, self.robot_group)
        slide = added if self.slide is None else self.slide + added
        return replace(self, roots=add_place_covariance(self.roots, added), slide=slide, noise=replace(self.noise, stop_mm=stop_mm))

    @property
    def labels(self) -> tuple[str, ...]:
        """Names of the parameters that matter to the user; those of robot, table and error motions follow without names."""
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
        """How many approaches of the robot there are."""
        return int(self.robot_group.max()) + 1

    @property
    def table_angles(self) -> int:
        """How many different table angles there are, or 0 where their errors are not estimated."""
        return int(self.table_group.max()) + 1 if self.free.axis else 0

    def predict(self, state: ChainState) -> FloatArray:
        """Predict camera_from_board (N, 4, 4) by the chain."""
        shift = np.tile(np.eye(4), (len(self.guide_mm), 1, 1))
        shift[:, :3, 3] = self.guide_mm[:, None] * (state.guide_direction * state.guide_scale)
        errors = apply_changes(np.tile(np.eye(4), (len(state.robot_changes), 1, 1)), state.robot_changes)[self.robot_group]
        flange, turned, moved = self.base_from_flange, self._table_rotations(state), self._moved(state)
        if moved is not None:
            flange, turned = moved.base_poses @ flange, moved.table_poses @ turned
        guide_from_camera = shift @ flange @ errors @ state.flange_from_camera
        return np.asarray(invert_poses(guide_from_camera) @ turned @ state.guide_from_board)

    def _moved(self, state: ChainState) -> MovedAxes | None:
        return None if self.motions is None else MovedAxes.at(self.motions, state.motions, self.table_rad, self.guide_mm)

    def _table_rotations(self, state: ChainState) -> FloatArray:
        angles = self._angles(state)
        turned = np.tile(np.eye(4), (len(angles), 1, 1))
        turned[:, :3, :3] = Rotation.from_rotvec(angles[:, None] * state.axis_direction).as_matrix()
        turned[:, :3, 3] = state.axis_point_mm - turned[:, :3, :3] @ state.axis_point_mm
        return turned

    def _angles(self, state: ChainState) -> FloatArray:
        return self.table_rad + (state.table_changes[self.table_group] if self.table_angles else 0.0)

    @property
    def approach_poses(self) -> FloatArray:
        """The poses base_from_flange (G, 4, 4) as read back, one per approach."""
        return self.base_from_flange[np.unique(self.robot_group, return_index=True)[1]]

    @property
    def motion_rows(self) -> IntArray:
        """The coefficients of the error motions among the parameters, (M,)."""
        first = len(self.labels) + POSE * self.robot_poses + self.table_angles
        return np.arange(first, first + (0 if self.motions is None else self.motions.size))

    @property
    def own_residuals(self) -> int:
        """How many residuals follow those of the poses: of table errors and error motions."""
        return self.table_angles + len(self.motion_rows)

    @property
    def cameras_freed(self) -> int:
        """How many parameters of the cameras are estimated."""
        return 0 if self.camera_covariance is None else len(self.camera_covariance)

    @property
    def size(self) -> int:
        """How many parameters there are."""
        return sum(self._lengths())

    def residuals(self, state: ChainState) -> FloatArray:
        """Return the whitened residuals of the poses (6 N), the table errors (K) and the error motions (M)."""
        away = change_between(self.camera_from_board, self.predict(state))
        if self.cameras_freed and self.camera_jacobian is not None:
            away = away - self.camera_jacobian @ state.camera_changes
        motions = np.zeros(0) if self.motions is None else state.motions / self.motions.prior_sigma
        return np.concatenate([(self.roots @ away[..., None]).ravel(), state.table_changes / self.noise.table_rad, motions])

    def apply_step(self, state: ChainState, step: FloatArray) -> ChainState:
        """Return the state after a step in the order of `labels`, then robot and table errors, error motions and camera errors."""
        taken = iter(np.split(step, np.cumsum(self._lengths())[:-1]))
        changed = state
        if self.free.hand_eye:
            changed = replace(changed, flange_from_camera=apply_changes(state.flange_from_camera, next(taken)))
        if self.free.guide:
            part = next(taken)
            direction = _tilt(state.guide_direction, part[:2])
            changed = replace(changed, guide_direction=direction, guide_scale=state.guide_scale + float(part[2]))
        if self.free.axis:
            part = next(taken)
            point = state.axis_point_mm + part[2:] @ perpendicular_basis(state.axis_direction)
            changed = replace(changed, axis_direction=_tilt(state.axis_direction, part[:2]), axis_point_mm=point)
        return replace(
            changed,
            guide_from_board=apply_changes(state.guide_from_board, next(taken)),
            robot_changes=state.robot_changes + next(taken).reshape(-1, POSE),
            table_changes=state.table_changes + next(taken),
            motions=state.motions + next(taken),
            camera_changes=state.camera_changes + next(taken) if self.cameras_freed else state.camera_changes,
        )

    def _lengths(self) -> list[int]:
        parts = [(self.free.hand_eye, POSE), (self.free.guide, 3), (self.free.axis, 4), (True, POSE)]
        return [length for used, length in parts if used] + [
            POSE * self.robot_poses,
            self.table_angles,
            len(self.motion_rows),
            self.cameras_freed,
        ]

    def adjust(self, start: ChainState, progress: Progress | None = None) -> Minimum[ChainState]:
        """Minimise the sum of squares of residuals and of axis errors weighted by their priors, from ``start``."""
        priors = self._priors()
        return minimise(
            start, lambda state: self._normal(state, priors), lambda state: self._cost(state, priors), self.apply_step, progress=progress
        )

    def curvature(self, state: ChainState) -> Minimum[ChainState]:
        """Return ``state`` as if it were the minimum, for the covariance there."""
        normal = self._normal(state, self._priors())
        return Minimum(state, normal.hessian, normal.cost, 0)

    def _priors(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Inverse covariances of the robot's rotations (G, G) and translations (G, G), and of the cameras (C, C)."""
        turn, shift = self.noise.robot_covariances(self.approach_poses)
        cameras = np.zeros((0, 0)) if self.camera_covariance is None else np.linalg.inv(self.camera_covariance)
        return np.linalg.inv(turn), np.linalg.inv(shift), cameras

    def _cost(self, state: ChainState, priors: tuple[FloatArray, FloatArray, FloatArray]) -> float:
        turn, shift, cameras = priors
        rotations, translations = state.robot_changes[:, :3], state.robot_changes[:, 3:]
        robot = np.sum(rotations * (turn @ rotations)) + np.sum(translations * (shift @ translations))
        own = state.camera_changes @ cameras @ state.camera_changes if self.cameras_freed else 0.0
        return float(np.sum(self.residuals(state) ** 2) + robot + own)

    def _normal(self, state: ChainState, priors: tuple[FloatArray, FloatArray, FloatArray]) -> NormalEquations:
        jacobian = self.jacobian(state)
        hessian, gradient = jacobian.T @ jacobian, jacobian.T @ self.residuals(state)
        first = len(self.labels)
        for part in range(POSE):
            index = first + part + POSE * np.arange(self.robot_poses)
            inverse = priors[0] if part < 3 else priors[1]
            hessian[np.ix_(index, index)] += inverse
            gradient[index] += inverse @ state.robot_changes[:, part]
        if self.cameras_freed:
            index = np.arange(self.size - self.cameras_freed, self.size)
            hessian[np.ix_(index, index)] += priors[2]
            gradient[index] += priors[2] @ state.camera_changes
        return NormalEquations(hessian, gradient, self._cost(state, priors))

    def jacobian(self, state: ChainState) -> FloatArray:
        """Return the derivatives (6 N + K + M, P) of `residuals`."""
        count, result = len(self.guide_mm), np.zeros((POSE * len(self.guide_mm) + self.own_residuals, self.size))
        errors, moved = state.robot_changes[self.robot_group], self._moved(state)
        by = derivatives(state, self.base_from_flange, self.guide_mm, self._angles(state), errors, self.camera_from_board, moved)
        chosen = [(self.free.hand_eye, by.hand_eye), (self.free.guide, by.guide), (self.free.axis, by.axis), (True, by.board)]
        named = np.concatenate([part for used, part in chosen if used], axis=2)
        poses = result[: POSE * count].reshape(count, POSE, self.size)  # a view: filled in place
        poses[:, :, : named.shape[2]] = self.roots @ named
        place, first, robot = np.arange(count), len(self.labels), self.roots @ by.robot
        for part in range(POSE):
            poses[place, :, first + POSE * self.robot_group + part] = robot[:, :, part]
        first += POSE * self.robot_poses
        if self.table_angles:
            poses[place, :, first + self.table_group] = (self.roots @ by.table)[:, :, 0]
            result[POSE * count + np.arange(self.table_angles), first + np.arange(self.table_angles)] = 1 / self.noise.table_rad
        if self.motions is not None:
            poses[:, :, self.motion_rows] = self.roots @ by.motions
            result[POSE * count + self.table_angles + np.arange(self.motions.size), self.motion_rows] = 1 / self.motions.prior_sigma
        if self.cameras_freed and self.camera_jacobian is not None:
            poses[:, :, -self.cameras_freed :] = -(self.roots @ self.camera_jacobian)
        return result

    def freedom(self) -> int:
        """Return the degrees of freedom: robot and table errors count as observed by their priors."""
        return POSE * len(self.guide_mm) - len(self.labels)


def _tilt(direction: FloatArray, change: FloatArray) -> FloatArray:
    tilted = direction + change @ perpendicular_basis(direction)
    return np.asarray(tilted / np.linalg.norm(tilted))


def roots_of(poses: Sequence[BoardPose]) -> FloatArray:
    """Return the upper triangular roots (N, 6, 6) of the information of poses."""
    return np.array([np.linalg.cholesky(pose.information).T for pose in poses])


def poses_of(poses: Sequence[BoardPose]) -> FloatArray:
    """Return camera_from_board (N, 4, 4)."""
    return stack_matrices(pose.camera_from_board for pose in poses)


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
