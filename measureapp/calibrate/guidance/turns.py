"""Advice for hand-eye: about which axes the camera was turned between the poses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.calibrate.draft.advice import Gauge, Ghost, Notes, outlines_px
from measureapp.calibrate.draft.draft import Draft
from measureapp.calibrate.draft.locate import locate
from measureapp.calibrate.motions.hand_eye import ADVISED_POSES, HandEyeSolution
from measureapp.calibrate.motions.next_pose import propose
from measureapp.calibrate.poses import mean_pose, stack_matrices
from measureapp.data.board import BoardDescription
from measureapp.geometry.transform import RigidTransform, rotation_about

TURN_TARGET_DEG = 40.0  # from one end to the other, about each axis of the camera
TURNS = (  # about x, y and z of the camera, y pointing down
    ("Turns up and down", "View the board from higher up and from lower down: the camera was tilted up and down by only"),
    ("Turns left and right", "View the board more from the left and from the right: the camera was swung sideways by only"),
    ("Turns about the line of sight", "Roll the camera about its line of sight: it was rolled by only"),
)
CANDIDATE_TURNS_RAD = tuple(np.deg2rad([-40.0, -25.0, -12.0, 12.0, 25.0, 40.0]))


def advise_turns(draft: Draft, notes: Notes) -> None:
    """Note about which axes the camera has to be turned more."""
    places = board_poses(draft)
    notes.gauges.append(Gauge("Robot poses", len(places), ADVISED_POSES, ""))
    spans = turns_deg(places)
    notes.gauges += [Gauge(name, span, TURN_TARGET_DEG, "°") for (name, _), span in zip(TURNS, spans, strict=True)]
    if not places:
        notes.wish("Show the fixed board from the first robot pose")
        return
    for index in np.argsort(spans):
        if spans[index] < TURN_TARGET_DEG:
            notes.wish(f"{TURNS[index][1]} {spans[index]:.0f}°, {TURN_TARGET_DEG:.0f}° are wanted")
    few = ADVISED_POSES - len(places)
    if few > 0:
        notes.wish(f"Take {few} more robot {'pose' if few == 1 else 'poses'}: more average the robot's own errors")


def board_poses(draft: Draft) -> list[RigidTransform]:
    """Return camera_from_board of the observations, those with the most frequent table angle: at which the board did not move."""
    cameras, usable = draft.cameras, draft.counted
    if cameras is None or not usable:
        return []
    angles = [one.readback.table_rad for one in usable]
    still = max(angles, key=angles.count)
    found = locate(usable, cameras, draft.setup.board).observations
    return [one.pose.camera_from_board for one in found if one.readback.table_rad == still]


def turns_deg(places: Sequence[RigidTransform]) -> FloatArray:
    """Return how far the camera was turned about its own x, y and z against the board, from one end to the other (3,)."""
    if not places:
        return np.zeros(3)
    turns = Rotation.from_matrix([place.rotation for place in places])
    vectors = (turns * turns.mean().inv()).as_rotvec()
    return np.asarray(np.rad2deg(np.ptp(vectors, axis=0)))


def ghost_for_turns(draft: Draft) -> Ghost | None:
    """Return where the board should appear next: by the information a pose adds once hand-eye is solved, before that by the turn that is missing."""
    places = board_poses(draft)
    cameras = draft.cameras
    if not places or cameras is None:
        return None
    board, middle = draft.setup.board, _middle(places, draft.setup.board)
    visible = [(place, seen) for place in middle if (seen := outlines_px(cameras, place, board))]
    solution = None if draft.solved is None else draft.solved.solution
    if not visible:
        return None
    if isinstance(solution, HandEyeSolution):
        x = solution.refined.flange_from_camera
        flanges = [solution.base_from_board @ place.inverse() @ x.inverse() for place, _ in visible]
        best = propose(solution, flanges)[0]
        return Ghost(visible[best.candidate][1], base_from_flange=best.base_from_flange)
    gains = [float(np.sum(np.minimum(turns_deg([*places, place]), TURN_TARGET_DEG))) for place, _ in visible]
    return Ghost(visible[int(np.argmax(gains))][1])


def _middle(places: Sequence[RigidTransform], board: BoardDescription) -> list[RigidTransform]:
    """The mean place of the board, turned about its middle by steps about each axis of the camera."""
    mean = mean_pose(stack_matrices(places))
    centre = mean[:3, :3] @ board.middle_mm + mean[:3, 3]
    turned = []
    for axis in np.eye(3):
        for angle in CANDIDATE_TURNS_RAD:
            turn = rotation_about(axis, angle) @ mean[:3, :3]
            turned.append(RigidTransform.from_parts(turn, centre - turn @ board.middle_mm, "camera", "board"))
    return turned
