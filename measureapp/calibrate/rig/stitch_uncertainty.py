"""How far a stitched point may be off because of the rig's calibration: anywhere in the volume, view by view, and between views."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import block_diag
from scipy.spatial.transform import Rotation

from measureapp.arrays import BoolArray, FloatArray
from measureapp.calibrate.motions.axis_noise import SAME_POSE, number_runs
from measureapp.calibrate.motions.chain import Chain, groups_of
from measureapp.calibrate.motions.chain_state import POSE, ChainState
from measureapp.calibrate.motions.error_motions import MovedAxes
from measureapp.calibrate.poses import apply_changes, change_between, invert_poses
from measureapp.calibrate.projection import cross_matrices
from measureapp.calibrate.rig.joint import SAME_ANGLE_RAD
from measureapp.calibrate.rig.joint_solution import RigSolution, repeatable_errors
from measureapp.data.calibration import LabelledCovariance, RigCalibration, RotationAxis
from measureapp.data.fringe import AxisReadback
from measureapp.geometry.transform import RigidTransform

TURN_STEP, LENGTH_STEP, SCALE_STEP = 1e-6, 1e-4, 1e-6  # of the differences
POSE_STEPS = (TURN_STEP,) * 3 + (LENGTH_STEP,) * 3
OWN = 7  # independent errors of each view: the robot's (6) and the table's (1)
MOVED = 2 * POSE  # motions of table top and base at one view


@dataclass(frozen=True, slots=True, eq=False)
class RigUncertainty:
    """Joint covariance of a rig calibration: sufficient to propagate it to the pose of any view, without the images."""

    calibration: RigCalibration
    chain: Chain
    state: ChainState
    covariance: FloatArray  # (P, P) of the chain's parameters, for cameras without error
    cameras: LabelledCovariance | None = None  # covariance of the camera parameters; None where not known
    camera_jacobian: FloatArray | None = None  # (P, C), how the chain's parameters follow those of the cameras


def uncertainty_of(solution: RigSolution) -> RigUncertainty:
    """Return the joint covariance of a solution."""
    return RigUncertainty(
        solution.calibration, solution.chain, solution.state, solution.joint_given_cameras, solution.cameras, solution.camera_jacobian
    )


@dataclass(frozen=True, slots=True, eq=False)
class ViewUncertainty:
    """The errors of ``part_from_camera`` of several views, all together.

    `covariance` is (V, 6, V, 6) of the changes (ω rad, τ mm) that take the true pose to the calibrated one, in the frame `part`:
    R' = exp(ω) R, t' = t + τ, so that a point p of the part moves by ω × (p - t) + τ. Ordering: rotation x, y, z, then x, y, z.
    """

    part_from_camera: tuple[RigidTransform, ...]
    covariance: FloatArray

    def view(self, index: int) -> FloatArray:
        """Return the covariance (6, 6) of one view, usable as a prior of its pose."""
        return np.asarray(self.covariance[index, :, index, :])

    def point_covariance(self, index: int, points_in_part_mm: FloatArray) -> FloatArray:
        """Return the covariance (N, 3, 3), mm², of points (N, 3) of the part as this view places them."""
        lever = self._lever(index, points_in_part_mm)
        return np.asarray(lever @ self.view(index) @ np.swapaxes(lever, 1, 2))

    def between(self, first: int, second: int, points_in_part_mm: FloatArray) -> FloatArray:
        """Return the covariance (N, 3, 3), mm², of the gap between two views at points (N, 3) in both of them."""
        levers = [(first, 1.0, self._lever(first, points_in_part_mm)), (second, -1.0, self._lever(second, points_in_part_mm))]
        total = np.zeros((len(levers[0][2]), 3, 3))
        for a, sign_a, lever_a in levers:
            for b, sign_b, lever_b in levers:
                total += sign_a * sign_b * lever_a @ self.covariance[a, :, b, :] @ np.swapaxes(lever_b, 1, 2)
        return total

    @property
    def pose_covariance(self) -> FloatArray:
        """The same (6 V, 6 V) as motions of each camera in its own frame: shifts x, y, z (mm), then turns about x, y, z (rad), view by view."""
        turned = _in_cameras(self.part_from_camera)
        full = np.einsum("aij,ajbk,blk->aibl", turned, self.covariance, turned)
        return np.asarray(full.reshape(POSE * len(turned), -1))

    def relative(self, first: int, second: int) -> FloatArray:
        """Return the covariance (6, 6) of the second view against the first: turn, and shift of the part's origin, in frame `part`."""
        carry = [self._to_origin(index) for index in (first, second)]
        signs, chosen = (-1.0, 1.0), (first, second)
        total = np.zeros((POSE, POSE))
        for i, a in enumerate(chosen):
            for j, b in enumerate(chosen):
                total += signs[i] * signs[j] * carry[i] @ self.covariance[a, :, b, :] @ carry[j].T
        return total

    def _to_origin(self, index: int) -> FloatArray:
        carry = np.eye(POSE)
        carry[3:, :3] = cross_matrices(self.part_from_camera[index].translation_mm[None])[0]
        return carry

    def _lever(self, index: int, points_in_part_mm: FloatArray) -> FloatArray:
        points = np.asarray(points_in_part_mm, float).reshape(-1, 3)
        away = points - self.part_from_camera[index].translation_mm
        return np.concatenate([-cross_matrices(away), np.tile(np.eye(3), (len(points), 1, 1))], axis=2)


def _in_cameras(part_from_camera: Sequence[RigidTransform]) -> FloatArray:
    """Return the matrices (V, 6, 6) that take (ω, τ) in the frame `part` to shift and turn of each camera in its own frame."""
    turned = np.zeros((len(part_from_camera), POSE, POSE))
    for index, pose in enumerate(part_from_camera):
        turned[index, :3, 3:] = turned[index, 3:, :3] = pose.rotation.T
    return turned


def pose_camera_jacobians(rig: RigUncertainty, readbacks: Sequence[AxisReadback]) -> FloatArray | None:
    """Return how ``part_from_camera`` of all views follows the parameters of `RigUncertainty.cameras`, (6 V, C); None where not known.

    As motions of each camera in its own frame, like `ViewUncertainty.pose_covariance`: the chain was calibrated with the same cameras,
    so that it compensates most of the effect of their errors on the clouds.
    """
    if rig.camera_jacobian is None:
        return None
    followed = _joint_sources(rig, readbacks) @ rig.camera_jacobian
    changes = (_gain(rig, readbacks) @ followed).reshape(len(readbacks), POSE, -1)
    turned = _in_cameras([rig.calibration.part_from_camera(readback) for readback in readbacks])
    return np.asarray((turned @ changes).reshape(POSE * len(readbacks), -1))


def motions_in_cameras(rig: RigUncertainty, readbacks: Sequence[AxisReadback]) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return how the cameras of V views move, (V, 6, 6) each, by turn and shift of the table top about the axis' point, of the base, of the camera.

    The motions of the cameras are shifts (mm), then turns (rad) in their own frames, as in `ViewUncertainty.pose_covariance`; their own are
    the identity.
    """
    by_table: list[FloatArray] = []
    by_guide: list[FloatArray] = []
    for readback in readbacks:
        guide_from_camera = rig.calibration.guide_from_camera(readback).matrix
        to_camera = guide_from_camera[:3, :3].T
        for found, point, sign in (
            (by_table, rig.calibration.axis.point_mm, -1.0),
            (by_guide, rig.calibration.guide.guide_from_base(readback.guide_mm).translation_mm, 1.0),
        ):
            lever = cross_matrices((guide_from_camera[:3, 3] - point)[None])[0]
            found.append(sign * np.block([[-to_camera @ lever, to_camera], [to_camera, np.zeros((3, 3))]]))
    return np.array(by_table), np.array(by_guide), np.tile(np.eye(POSE), (len(by_table), 1, 1))


def point_sigma_mm(rig: RigUncertainty, readback: AxisReadback, points_in_part_mm: FloatArray) -> FloatArray:
    """Return the predicted standard deviation (N,) mm, the largest over all directions, of points (N, 3) seen from ``readback``.

    It contains the contributions of the rig's calibration and axes; not the noise of the cloud, nor the effect of the cameras' own errors
    on shape: they move board and part together, so that their rigid part cancels; the rest deforms the cloud and belongs to it.
    """
    covariance = view_uncertainty(rig, [readback]).point_covariance(0, points_in_part_mm)
    return np.sqrt(np.linalg.eigvalsh(covariance)[:, -1])


def view_uncertainty(
    rig: RigUncertainty, readbacks: Sequence[AxisReadback], approaches: Sequence[Hashable] | None = None
) -> ViewUncertainty:
    """Return the covariance of ``part_from_camera`` of all views together, by linear propagation of the joint covariance.

    Parameters common to the views (hand-eye, guide, axis) correlate their errors; the robot's repeatable error enters as
    the calibration's sightings tell it (`repeatable_errors`), the scatter of its approach and the table's error of its own.

    Parameters
    ----------
    approaches : one label per view, equal for views between which robot and guide did not move: these have its scatter in common.
        None: neighbouring views with equal robot poses are one approach.
    """
    placed = tuple(rig.calibration.part_from_camera(readback) for readback in readbacks)
    gain = _gain(rig, readbacks)
    total = gain @ _sources(rig, readbacks, approaches) @ gain.T
    return ViewUncertainty(placed, total.reshape(len(placed), POSE, len(placed), POSE))


def _gain(rig: RigUncertainty, readbacks: Sequence[AxisReadback]) -> FloatArray:
    """Return how the poses (6 V) follow the rows of `_sources`."""
    by_named, by_own, by_motions = _derivatives(rig, readbacks)
    rows = POSE * len(readbacks)
    return np.hstack([by_named.reshape(rows, -1), block_diag(*by_own), by_motions.reshape(rows, -1)])


def _sources(rig: RigUncertainty, readbacks: Sequence[AxisReadback], approaches: Sequence[Hashable] | None) -> FloatArray:
    """Covariance of the named parameters (without the board), of robot and table errors of every view, and of error motions.

    Errors are estimated minus true.
    """
    chain = rig.chain
    named = len(chain.labels) - POSE
    poses = np.array([readback.base_from_flange.matrix for readback in readbacks])
    gain = _joint_sources(rig, readbacks)
    rest = np.zeros((len(gain), len(gain)))
    mean = np.zeros(len(gain))
    turn, shift = repeatable_errors(chain, poses)
    approach = number_runs(groups_of(poses[:, :3].reshape(-1, 12), SAME_POSE)) if approaches is None else approaches
    together = np.array([[a == b for b in approach] for a in approach])
    at_station = np.array([rig.calibration.station(readback) is not None for readback in readbacks])
    for part in range(POSE):
        rows = named + part + OWN * np.arange(len(poses))
        follows = turn if part < 3 else shift
        rest[np.ix_(rows, rows)] = _conditional_covariance(chain, poses, follows, together, rotation=part < 3)
        mean[rows] = -np.where(at_station, 0.0, follows @ rig.state.robot_changes[:, part])  # known, but not undone
        if part >= 3:
            rest[np.ix_(rows, rows)] += chain.noise.drift_mm**2 / 3 * chain.noise.correlation(poses, poses)
            rest[rows, rows] += chain.noise.stop_mm**2
    _table_sources(rig, readbacks, rest, mean)
    return np.asarray(gain @ rig.covariance @ gain.T + rest + np.outer(mean, mean))


def _joint_sources(rig: RigUncertainty, readbacks: Sequence[AxisReadback]) -> FloatArray:
    """Return how the rows of `_sources` follow the joint solution."""
    chain = rig.chain
    named = len(chain.labels) - POSE
    robot = np.arange(POSE * chain.robot_poses) + named + POSE
    poses = np.array([readback.base_from_flange.matrix for readback in readbacks])
    motions = named + OWN * len(poses)
    gain = np.zeros((motions + len(chain.motion_rows), len(rig.covariance)))
    gain[motions + np.arange(len(chain.motion_rows)), chain.motion_rows] = 1.0
    gain[:named, :named] = np.eye(named)
    turn, shift = repeatable_errors(chain, poses)
    for part in range(POSE):
        rows, columns = named + part + OWN * np.arange(len(poses)), robot[part::POSE]
        gain[np.ix_(rows, columns)] = turn if part < 3 else shift
    first = len(chain.labels) + POSE * chain.robot_poses
    for row, number in zip(named + OWN * np.arange(len(poses)) + POSE, _angles_seen(chain, readbacks), strict=True):
        if number is not None:
            gain[row, first + number] = 1.0
    return gain


def _angles_seen(chain: Chain, readbacks: Sequence[AxisReadback]) -> list[int | None]:
    """Return for every view which of the table's angles in the calibration it stands at."""
    seen = np.array([chain.table_rad[chain.table_group == number][0] for number in range(chain.table_angles)])
    matches = [np.flatnonzero(np.abs(seen - readback.table_rad) <= SAME_ANGLE_RAD) for readback in readbacks]
    return [int(found[0]) if len(found) else None for found in matches]


def _conditional_covariance(chain: Chain, poses: FloatArray, follows: FloatArray, together: BoolArray, rotation: bool) -> FloatArray:
    """What the approaches of the calibration do not tell of the robot's errors at ``poses``, and the scatter of approaches ``together``, (V, V)."""
    noise = chain.noise
    large, small = (noise.robot_rad, noise.robot_repeat_rad) if rotation else (noise.robot_mm, noise.robot_repeat_mm)
    known = noise.correlation(poses, chain.approach_poses)
    left = noise.correlation(poses, poses) - follows @ known.T
    return np.asarray(large**2 * (left + left.T) / 2 + small**2 * together)


def _table_sources(rig: RigUncertainty, readbacks: Sequence[AxisReadback], rest: FloatArray, mean: FloatArray) -> None:
    """Fill in the table's errors at angles that the calibration did not use, equal angles share theirs; of the others their mean."""
    chain = rig.chain
    named = len(chain.labels) - POSE
    angles = np.array([readback.table_rad for readback in readbacks])
    rows = named + OWN * np.arange(len(angles)) + POSE
    for row, angle, number in zip(rows, angles, _angles_seen(chain, readbacks), strict=True):
        if number is not None:
            mean[row] = -rig.state.table_changes[number]
        else:
            rest[np.ix_([row], rows[np.abs(angles - angle) <= SAME_ANGLE_RAD])] = chain.noise.table_rad**2


def _derivatives(rig: RigUncertainty, readbacks: Sequence[AxisReadback]) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return how ``part_from_camera`` of V views changes with the named parameters, the errors of robot and table, and the error motions.

    Returns
    -------
    by_named, by_own, by_motions : (V, 6, P), (V, 6, 7) and (V, 6, M), by central differences
    """
    chain, state = rig.chain, rig.state
    moved = _moved(chain, state, readbacks)
    still = np.zeros((len(readbacks), MOVED)) if moved is None else np.hstack([moved.table, moved.guide])
    pivot = np.zeros(3) if moved is None else moved.model.point_mm
    placed = _Placed.at(rig, readbacks, pivot)

    def poses(of: ChainState, error: FloatArray) -> FloatArray:
        return placed.poses(of, np.tile(error[:OWN], (len(readbacks), 1)), still + error[OWN:])

    nothing = np.zeros(OWN + MOVED)
    at = poses(state, nothing)

    def change(there: FloatArray, back: FloatArray, step: float) -> FloatArray:
        return (change_between(at, there) - change_between(at, back)) / (2 * step)

    by_named = np.zeros((len(readbacks), POSE, len(chain.labels) - POSE))
    for index, step in enumerate(_named_steps(chain)):
        shift = step * np.eye(1, chain.size, index)[0]
        there, back = chain.apply_step(state, shift), chain.apply_step(state, -shift)
        by_named[:, :, index] = change(poses(there, nothing), poses(back, nothing), step)
    steps = (*POSE_STEPS, TURN_STEP, *(POSE_STEPS * 2 if moved is not None else ()))
    shifts = [step * np.eye(1, len(nothing), index)[0] for index, step in enumerate(steps)]
    by_error = np.stack([change(poses(state, by), poses(state, -by), step) for by, step in zip(shifts, steps, strict=True)], axis=2)
    if moved is None:
        return by_named, by_error, np.zeros((len(readbacks), POSE, 0))
    return by_named, by_error[:, :, :OWN], by_error[:, :, OWN:] @ np.concatenate([moved.by_table, moved.by_guide], axis=1)


def _named_steps(chain: Chain) -> list[float]:
    """Return the step of each named parameter, the board excepted, by which its derivative is found."""
    steps = [*POSE_STEPS] if chain.free.hand_eye else []
    steps += [TURN_STEP, TURN_STEP, SCALE_STEP] if chain.free.guide else []
    return steps + ([TURN_STEP, TURN_STEP, LENGTH_STEP, LENGTH_STEP] if chain.free.axis else [])


def _moved(chain: Chain, state: ChainState, readbacks: Sequence[AxisReadback]) -> MovedAxes | None:
    """Return the error motions at the read-backs."""
    if chain.motions is None:
        return None
    angles, positions = (np.array([getattr(one, name) for one in readbacks]) for name in ("table_rad", "guide_mm"))
    return MovedAxes.at(chain.motions, state.motions, angles, positions)


@dataclass(frozen=True, slots=True, eq=False)
class _Placed:
    """Where the axes of V views stand."""

    flanges: FloatArray  # (V, 4, 4), base ← flange
    guide_mm: FloatArray  # (V,)
    table_rad: FloatArray  # (V,)
    pivot_mm: FloatArray  # (3,), of the motion of the table top

    @classmethod
    def at(cls, rig: RigUncertainty, readbacks: Sequence[AxisReadback], pivot_mm: FloatArray) -> _Placed:
        """Return the axes as read back, the robot where the calibration knows it better."""
        stations = [rig.calibration.station(readback) for readback in readbacks]
        flanges = [(one.base_from_flange if at is None else at.true).matrix for one, at in zip(readbacks, stations, strict=True)]
        return cls(
            np.array(flanges), np.array([one.guide_mm for one in readbacks]), np.array([one.table_rad for one in readbacks]), pivot_mm
        )

    def poses(self, state: ChainState, own: FloatArray, motions: FloatArray) -> FloatArray:
        """Return part_from_camera (V, 4, 4) of a state, with errors (V, 7) of robot and table, and motions (V, 12) of table top and base."""
        axis = RotationAxis(state.axis_point_mm, state.axis_direction, "guide")
        still = np.tile(np.eye(4), (len(own), 1, 1))
        shift = apply_changes(still, motions[:, POSE:])
        shift[:, :3, 3] += self.guide_mm[:, None] * (state.guide_direction * state.guide_scale)
        robot = self.flanges @ apply_changes(still, own[:, :POSE])
        back = still.copy()
        back[:, :3, :3] = Rotation.from_rotvec(-(self.table_rad + own[:, POSE])[:, None] * [0.0, 0.0, 1.0]).as_matrix()
        lift = apply_changes(still, motions[:, :POSE])
        lift[:, :3, 3] += self.pivot_mm - lift[:, :3, :3] @ self.pivot_mm
        return np.asarray(back @ invert_poses(lift @ _guide_from_table(axis)) @ shift @ robot @ state.flange_from_camera)


def _guide_from_table(axis: RotationAxis) -> FloatArray:
    """The table frame as `RigCalibration.table_from_guide` defines it."""
    z = axis.direction
    x = np.array([1.0, 0.0, 0.0]) - z[0] * z
    x /= np.linalg.norm(x)
    result = np.eye(4)
    result[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    result[:3, 3] = axis.point_mm - z * float(z @ axis.point_mm)
    return result
