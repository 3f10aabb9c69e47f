"""Relative poses of cameras from board poses that both observed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.poses import change_between, invert_poses, median_pose, stack_matrices
from measureapp.calibrate.sightings import Rejection
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform

LARGEST_TURN_RAD = np.deg2rad(3.0)  # a view that turns one camera against the other by more shows another board position
Poses = Mapping[str, Mapping[str, RigidTransform]]  # camera -> view -> camera_from_board


@dataclass(frozen=True, slots=True, eq=False)
class LoopCheck:
    """Loop closure error of the chain first ← second ← third ← first."""

    cameras: tuple[str, str, str]
    angle_deg: float
    distance_mm: float


def pair_transform(left: Mapping[str, RigidTransform], right: Mapping[str, RigidTransform]) -> tuple[FloatArray, list[str]]:
    """Return left_from_right (4, 4) from the poses of one board in both, and the views that contradict it.

    Per view R = R_l R_rᵀ and t = t_l - R t_r; the median over the views stands against single wrong ones.
    """
    shared = [view for view in left if view in right]
    each = stack_matrices(left[view] for view in shared) @ invert_poses(stack_matrices(right[view] for view in shared))
    middle = median_pose(each)
    turn = np.linalg.norm(change_between(np.broadcast_to(middle, each.shape), each)[:, :3], axis=1)
    return middle, [view for view, angle in zip(shared, turn, strict=True) if angle > LARGEST_TURN_RAD]


def find_contradictions(poses: Poses) -> list[Rejection]:
    """Find views in which two cameras show different board poses.

    Raises
    ------
    CalibrationError
        Most views of a pair contradict each other: the images do not belong together.
    """
    odd: dict[str, dict[tuple[str, str], bool]] = {}  # view -> pairs that contradict, and whether exchanged images explain it
    for left, right in combinations(poses, 2):
        shared = [view for view in poses[left] if view in poses[right]]
        if not shared:
            continue
        middle, wrong = pair_transform(poses[left], poses[right])
        if len(wrong) * 2 >= len(shared) and len(shared) > 1:
            raise CalibrationError(
                f"The images of cameras {left!r} and {right!r} do not belong together: in {len(wrong)} of {len(shared)} views "
                "they show different board positions.",
                "Give the images of all cameras in the same order, one of each camera per board position.",
            )
        for view in wrong:
            odd.setdefault(view, {})[left, right] = _are_exchanged(poses[left][view], poses[right][view], middle)
    return [rejection for view, pairs in odd.items() for rejection in _rejections(view, pairs)]


def _are_exchanged(left: RigidTransform, right: RigidTransform, middle: FloatArray) -> bool:
    """Whether the images of both cameras fit when exchanged (with similar lenses)."""
    turned = stack_matrices([right]) @ invert_poses(stack_matrices([left]))
    return bool(np.linalg.norm(change_between(middle[None], turned)[0, :3]) < LARGEST_TURN_RAD)


def _rejections(view: str, pairs: Mapping[tuple[str, str], bool]) -> list[Rejection]:
    """The cameras whose images of a view are rejected: the one common to all contradictions, or else all of them."""
    swapped = next((pair for pair, exchanged in pairs.items() if exchanged), None)
    if swapped is not None:
        reason = f"the images of cameras {swapped[0]} and {swapped[1]} were exchanged"
        return [Rejection(camera, view, reason) for camera in swapped]
    cameras = list(dict.fromkeys(camera for pair in pairs for camera in pair))
    common = [camera for camera in cameras if len(pairs) > 1 and all(camera in pair for pair in pairs)]
    blamed = common or cameras
    others = [camera for camera in cameras if camera not in blamed]
    if others:
        reason = f"it does not show the board position detected by cameras {' and '.join(others)} saw"
    else:
        reason = f"cameras {' and '.join(cameras)} show different board positions: the board moved, or images were exchanged"
    return [Rejection(camera, view, reason) for camera in blamed]


def placed_from_reference(poses: Poses, reference: str, given: Mapping[str, FloatArray]) -> dict[str, FloatArray]:
    """Return reference_from_camera (4, 4) of every camera: as ``given``, or chained over the pairs with most common views.

    Raises
    ------
    CalibrationError
        A camera shares no board position with the others.
    """
    placed: dict[str, FloatArray] = {reference: np.eye(4)} | dict(given)
    while len(placed) < len(poses):
        shared = {(known, new): sum(view in poses[new] for view in poses[known]) for known in placed for new in poses if new not in placed}
        known, new = max(shared, key=lambda pair: shared[pair])
        if shared[known, new] == 0:
            raise CalibrationError(
                f"Camera {new!r} has no view of the board in common with the other cameras.",
                "Add views in which both it and another camera see the whole board.",
            )
        placed[new] = placed[known] @ pair_transform(poses[known], poses[new])[0]
    return placed


def loops(poses: Poses) -> tuple[LoopCheck, ...]:
    """Close the loop over every three cameras that pairwise have common views."""
    checks = []
    for first, second, third in combinations(poses, 3):
        chain = ((first, second), (second, third), (third, first))
        if any(not any(view in poses[b] for view in poses[a]) for a, b in chain):
            continue
        closed = np.linalg.multi_dot([pair_transform(poses[a], poses[b])[0] for a, b in chain])
        change = change_between(np.eye(4)[None], closed[None])[0]
        angle, distance = float(np.rad2deg(np.linalg.norm(change[:3]))), float(np.linalg.norm(change[3:]))
        checks.append(LoopCheck((first, second, third), angle, distance))
    return tuple(checks)
