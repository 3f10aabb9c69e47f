"""Analytic derivatives of the board poses predicted by the kinematic chain with respect to its quantities."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.calibrate.motions.axis_motion import perpendicular_basis
from measureapp.calibrate.motions.chain_state import POSE, ChainState
from measureapp.calibrate.motions.error_motions import MovedAxes
from measureapp.calibrate.poses import change_between, invert_poses, left_jacobians
from measureapp.calibrate.projection import cross_matrices


@dataclass(frozen=True, slots=True, eq=False)
class ChainDerivatives:
    """Derivatives (N, 6, …) of the change from the observed to the predicted poses, one row of six per sighting."""

    hand_eye: FloatArray  # (N, 6, 6)
    guide: FloatArray  # (N, 6, 3), two tilts of the direction, scale
    axis: FloatArray  # (N, 6, 4), two tilts of the direction, two shifts of the point
    board: FloatArray  # (N, 6, 6)
    robot: FloatArray  # (N, 6, 6), by the error of the sighting's own robot pose
    table: FloatArray  # (N, 6, 1), by the error of its own table angle
    motions: FloatArray  # (N, 6, M), by the coefficients of the error motions


def derivatives(
    state: ChainState,
    flange: FloatArray,
    guide_mm: FloatArray,
    table_rad: FloatArray,
    errors: FloatArray,
    observed: FloatArray | None = None,
    moved: MovedAxes | None = None,
) -> ChainDerivatives:
    """Differentiate camera_from_board = C⁻¹ G, with C = shift · slip · flange · error · X and G = lift · turn · board.

    A pose changes as in `poses.apply_changes`: rotated by exp(ω) on the left and shifted by τ. For C and G that gives ω = Rcᵀ (ω_G - ω_C) and
    τ = Rcᵀ (τ_G - τ_C + [t_G - t_C]× ω_C); each quantity of the chain moves C or G in turn.

    Parameters
    ----------
    flange : base_from_flange (N, 4, 4) as read back
    errors : (N, 6), those of the robot poses
    observed : camera_from_board (N, 4, 4) against which the change is taken; default: the predicted ones
    moved : error motions, slip of the slide and lift of the table; default: none
    """
    flange = flange if moved is None else moved.base_poses @ flange
    error_turn, error_left = Rotation.from_rotvec(errors[:, :3]).as_matrix(), left_jacobians(errors[:, :3])
    x, board = state.flange_from_camera, state.guide_from_board
    to_error, to_x = flange[:, :3, :3], flange[:, :3, :3] @ error_turn
    sensor = np.tile(np.eye(4), (len(flange), 1, 1))
    sensor[:, :3, :3] = to_x @ x[:3, :3]
    lever = error_turn @ x[:3, 3]
    sensor[:, :3, 3] = (to_error @ (lever + errors[:, 3:])[..., None])[..., 0] + flange[:, :3, 3]
    slid = guide_mm[:, None] * (state.guide_direction * state.guide_scale)
    sensor[:, :3, 3] += slid
    spin = table_rad[:, None] * state.axis_direction
    turn = Rotation.from_rotvec(spin).as_matrix()
    arm = (turn @ (board[:3, 3] - state.axis_point_mm)[:, None])[..., 0]
    seen = np.tile(np.eye(4), (len(flange), 1, 1))
    seen[:, :3, :3], seen[:, :3, 3] = turn @ board[:3, :3], arm + state.axis_point_mm
    lift = np.tile(np.eye(4), (len(flange), 1, 1)) if moved is None else moved.table_poses
    place = _Place(sensor, lift @ seen, observed, lift[:, :3, :3])
    tilts, zero = perpendicular_basis(state.axis_direction).T, np.zeros((len(flange), 3, 3))
    axis_turn = left_jacobians(spin) @ (table_rad[:, None, None] * tilts)
    shift = guide_mm[:, None, None] * np.column_stack(
        [state.guide_scale * perpendicular_basis(state.guide_direction).T, state.guide_direction]
    )
    return ChainDerivatives(
        hand_eye=place.by_sensor(np.concatenate([to_x, zero], 2), np.concatenate([zero, to_x], 2)),
        guide=place.by_sensor(zero, shift),
        axis=place.by_board(
            np.concatenate([axis_turn, zero[..., :2]], 2), np.concatenate([-cross_matrices(arm) @ axis_turn, (np.eye(3) - turn) @ tilts], 2)
        ),
        board=place.by_board(np.concatenate([turn, zero], 2), np.concatenate([zero, turn], 2)),
        robot=place.by_sensor(
            np.concatenate([to_error @ error_left, zero], 2),
            np.concatenate([-to_error @ cross_matrices(lever) @ error_left, to_error], 2),
        ),
        table=place.by_board(np.tile(state.axis_direction[:, None], (len(flange), 1, 1)), np.cross(state.axis_direction, arm)[..., None]),
        motions=np.zeros((len(flange), POSE, 0)) if moved is None else place.by_motions(moved, sensor[:, :3, 3] - slid),
    )


class _Place:
    """Transforms changes of the poses of sensor and board (both in guide) into changes of camera_from_board against the observed one."""

    def __init__(self, sensor: FloatArray, board: FloatArray, observed: FloatArray | None, lifted: FloatArray) -> None:
        self._lifted, self._board = lifted, board[:, :3, 3]
        self._to_camera = np.swapaxes(sensor[:, :3, :3], 1, 2)
        self._away = cross_matrices(board[:, :3, 3] - sensor[:, :3, 3])
        seen = invert_poses(sensor) @ board
        off = np.zeros((len(seen), POSE)) if observed is None else change_between(observed, seen)
        self._of_change = np.linalg.inv(left_jacobians(off[:, :3]))  # log(exp(ω) exp(φ)) = φ + J(φ)⁻¹ ω

    def by_board(self, turn: FloatArray, shift: FloatArray) -> FloatArray:
        """Return the change (N, 6, P) for turns and shifts (N, 3, P) of the board on the table without its error motion."""
        return self._change(self._lifted @ turn, self._lifted @ shift)

    def by_motions(self, moved: MovedAxes, levers_mm: FloatArray) -> FloatArray:
        """Return the change (N, 6, M) for the coefficients of the error motions; ``levers_mm`` (N, 3): cameras from the robot's base."""
        return self._change(*moved.board_changes(self._board)) + self.by_sensor(*moved.sensor_changes(levers_mm))

    def _change(self, turn: FloatArray, shift: FloatArray) -> FloatArray:
        return np.concatenate([self._of_change @ self._to_camera @ turn, self._to_camera @ shift], axis=1)

    def by_sensor(self, turn: FloatArray, shift: FloatArray) -> FloatArray:
        """Return the change (N, 6, P) for turns and shifts (N, 3, P) of the reference camera."""
        return -self._change(turn, shift - self._away @ turn)
