"""Planning of the viewpoints of an automatic rig calibration."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import get_args

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import FlangePose, Motion, ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell
from measureapp.planning.reach import limit_violations
from measureapp.planning.viewpoints import LookAt, viewpoint_looking_at
from measureapp.progress import NoProgress, Progress

ALL_MOTIONS: tuple[Motion, ...] = get_args(Motion)
BOARD_ABOVE_TABLE_MM = 90.0  # centre of a board on its stand, tilted 45° towards the robot
BOARD_ELEVATION_DEG = 45.0
LIGHT_DEG, STRONG_DEG = 24.0, 42.0  # tilts of the board; at 42° at least 20° remain for a camera that is itself inclined by about 20°
LEANS_DEG = (0.0, 90.0, 180.0, 270.0)  # side of the image towards which the board is tilted: right, down, left, up
TURNS_DEG = (0.0, 90.0, 180.0, -90.0)  # rotation of the board in the image
CORNERS = ((-1, -1), (1, 1), (1, -1), (-1, 1))
DISTANCES_MM = (20.0, 55.0, 95.0)  # beyond the standoff
# offset of the board's centre towards a corner, relative to the field of view, so that the outer marks come near the image border
OFFSET = (0.155, 0.145)
OFFSET_ON_EDGE = (0.215, 0.07)  # the same with the board on its short side
STRONG_OFFSET_FACTOR = 0.9  # for a strong tilt, which enlarges the nearer side of the board
SLIDE_SHARE = 0.7  # of the lateral motion that the guide performs; the robot performs the rest
STATION_ANGLES_DEG = (-50.0, -25.0, 0.0, 25.0, 50.0)
# passes along the guide: tilt, its direction, vertical offset in the image (up: -1), distance beyond the standoff
PASSES = {"guide": (5.0, 90.0, 0, 80.0), "below": (25.0, 0.0, 1, 60.0), "above": (25.0, 180.0, -1, 60.0)}
SLIDES_MM = tuple(28.0 * step for step in range(-5, 6))
TILT_SHARES = (1.0, 0.75, 0.5, 0.25, 0.0)  # of a pose, for its neighbours
NEIGHBOUR_SLIDES_MM = (0.0, -60.0, 60.0, -120.0, 120.0, -180.0, 180.0)
CHECK_ANGLES_DEG = (-12.0, 0.0, 12.0, 0.0)
CHECK_SLIDES_MM = (-30.0, -10.0, 10.0, 30.0)  # offset of the guide, compensated by the robot


def calibration_viewpoints(
    rig: RigDescription,
    plan: ScanPlan | None = None,
    motions: Sequence[Motion] = ALL_MOTIONS,
    *,
    guide_at_zero: bool = False,
    arm: ArmModel | None = None,
    progress: Progress | None = None,
) -> tuple[Viewpoint, ...]:
    """Return the viewpoints of a calibration: `pose…` for cameras and hand-eye, `axis…`, `guide…` and further passes along it, `station…`.

    The poses bring the board into the corners of the images, for distortion is known only where there were marks, and let it lean to
    all four sides. Turning it in the image meanwhile also gives hand-eye what Tsai and Lenz ask for (IEEE Trans. Robotics and
    Automation 5(3), 1989): large rotations about axes that are not parallel. From the stations of ``plan`` the board is viewed at several
    table angles: a part appears enlarged by twice the robot's error towards the table unless that error is known where the scan is made.
    Viewpoints that the rig cannot reach are omitted. With ``arm``, a pose that its joints do not reach, or in which head, arm, board or table
    would touch, is replaced by the first of its neighbours that is free: the same view from another place of the guide, then a lesser tilt of
    the board, then the head turned over.

    Parameters
    ----------
    motions : which of these groups
    guide_at_zero : reach the same views with the guide at 0, as far as possible: the robot's base then stays where it is
    arm : of the rig's robot, whose joint limits and clearances are then kept; None: its reach only
    progress : raises Cancelled between two viewpoints
    """
    told = NoProgress() if progress is None else progress
    centre = board_middle_mm(rig)
    cell = None if arm is None else Cell.of(rig, arm, PartSolid.board_on_stand())
    slides_mm = (0.0,) if guide_at_zero else NEIGHBOUR_SLIDES_MM  # whatever the slide, with the guide at 0 the robot is at one pose
    groups: dict[Motion, Callable[[], list[Viewpoint]]] = {
        "robot": lambda: [_reachable(_until_cancelled(near, told), rig, cell, guide_at_zero) for near in _poses(rig, centre, slides_mm)],
        "table": lambda: _axis(rig, centre),
        "guide": lambda: _passes(rig, centre, ("guide",)),
        "passes": lambda: _passes(rig, centre, ("below", "above")),
        "stations": lambda: _stations(plan),
    }
    candidates = (viewpoint for motion in groups if motion in motions for viewpoint in groups[motion]())
    return tuple(seen for one in _until_cancelled(candidates, told) if (seen := _seen(one, rig, cell, guide_at_zero)) is not None)


def _until_cancelled(viewpoints: Iterable[Viewpoint], progress: Progress) -> Iterator[Viewpoint]:
    for viewpoint in viewpoints:
        progress.check()
        yield viewpoint


def _seen(viewpoint: Viewpoint, rig: RigDescription, cell: Cell | None, guide_at_zero: bool) -> Viewpoint | None:
    """Return the viewpoint, with the guide at 0 if that is wanted; None if it, or the one it is made of, is out of reach."""
    if limit_violations(viewpoint, rig):
        return None
    wanted = _with_guide_at_zero(viewpoint) if guide_at_zero else viewpoint
    problem = limit_violations(wanted, rig) or (cell is not None and cell.problem_at(wanted))
    return None if problem else wanted


def _reachable(neighbours: Iterator[Viewpoint], rig: RigDescription, cell: Cell | None, guide_at_zero: bool) -> Viewpoint:
    """Return the first viewpoint of ``neighbours`` within reach, or the very first; without an arm it is always the latter."""
    first = next(neighbours)
    if cell is None:
        return first
    return next((one for one in chain([first], neighbours) if _seen(one, rig, cell, guide_at_zero) is not None), first)


def _with_guide_at_zero(viewpoint: Viewpoint) -> Viewpoint:
    slid = RigidTransform.from_parts(np.eye(3), np.array([0.0, viewpoint.guide_mm, 0.0]), "base", "base")
    flange = FlangePose.of(slid @ viewpoint.flange.transform())
    return viewpoint.model_copy(update={"flange": flange, "guide_mm": 0.0})


def check_viewpoints(rig: RigDescription) -> tuple[Viewpoint, ...]:
    """Plan a few viewpoints with the board in the image centre, which differ in every axis and so test each link of the chain."""
    centre = board_middle_mm(rig)
    poses = [
        _BoardPose(LIGHT_DEG, lean, turn, rig.standoff_mm + DISTANCES_MM[1], (0, 0))
        for lean, turn in zip(LEANS_DEG, TURNS_DEG, strict=True)
    ]
    views = [
        _viewpoint(rig, f"check{number:02d}", centre, pose, slide_mm)
        for number, (pose, slide_mm) in enumerate(zip(poses, CHECK_SLIDES_MM, strict=True), start=1)
    ]
    turned = [view.model_copy(update={"table_deg": angle}) for view, angle in zip(views, CHECK_ANGLES_DEG, strict=True)]
    return tuple(view for view in turned if not limit_violations(view, rig))


def board_on_stand(centre_mm: FloatArray) -> RigidTransform:
    """Return guide_from_board of a board on its stand at table angle 0, the frame `board` moved to the board's centre ``centre_mm`` (3,)."""
    slope = np.deg2rad(BOARD_ELEVATION_DEG)
    across, down = np.array([0.0, -1.0, 0.0]), np.array([-np.sin(slope), 0.0, -np.cos(slope)])
    return RigidTransform.from_parts(np.column_stack([across, down, np.cross(across, down)]), centre_mm, "guide", "board")


def board_middle_mm(rig: RigDescription) -> FloatArray:
    """Return the centre (3,) of a board on its stand, in the guide frame."""
    return np.array(rig.table.centre_in_guide_mm) + np.array([0.0, 0.0, BOARD_ABOVE_TABLE_MM])


@dataclass(frozen=True, slots=True)
class _BoardPose:
    """Wanted pose of the board in front of the head."""

    tilt_deg: float  # between the board's normal and the optical axis
    lean_deg: float  # direction of the tilt in the image; 0: right, 90: down
    turn_deg: float  # rotation in the image, before the tilt
    distance_mm: float
    corner: tuple[int, int]  # of the image, towards which the board is offset; (0, 0): centred

    def head_from_board(self, rig: RigDescription) -> RigidTransform:
        """Return the pose as head_from_board, with the board's origin in its centre."""
        lean = np.deg2rad(self.lean_deg)
        tilt = rotation_about([-np.sin(lean), np.cos(lean), 0.0], np.deg2rad(self.tilt_deg))
        turn = rotation_about([0.0, 0.0, 1.0], np.deg2rad(self.turn_deg))
        camera = rig.camera(rig.reference)
        field_mm = np.array([camera.width_px, camera.height_px]) * self.distance_mm / camera.focal_px
        factor = STRONG_OFFSET_FACTOR if self.tilt_deg > LIGHT_DEG else 1.0
        offset = np.array(OFFSET_ON_EDGE if self.turn_deg % 180.0 else OFFSET) * factor
        return RigidTransform.from_parts(tilt @ turn, [*(offset * self.corner * field_mm), self.distance_mm], "head", "board")


def _poses(rig: RigDescription, centre: FloatArray, slides_mm: Sequence[float]) -> list[Iterator[Viewpoint]]:
    """Viewpoints, each followed by its neighbours, with the board tilted in four directions, lightly once per corner of the image and strongly twice, rotated in the image.

    Strong tilts are about the vertical axis, where the robot can reach; for tilts up or down in the image the head is rolled.
    """
    poses = []
    for way, lean_deg in enumerate(LEANS_DEG):
        for corner, side in enumerate(CORNERS):
            distance_mm = rig.standoff_mm + DISTANCES_MM[(way + 2 * corner) % 3]
            poses.append(_BoardPose(LIGHT_DEG, lean_deg, TURNS_DEG[(way + corner) % 4], distance_mm, side))
    for way, lean_deg in enumerate(LEANS_DEG):
        for again, distance_mm in enumerate((DISTANCES_MM[0], DISTANCES_MM[-1])):
            turn_deg = TURNS_DEG[2 * again + way % 2]
            poses.append(_BoardPose(STRONG_DEG, lean_deg, turn_deg, rig.standoff_mm + distance_mm, CORNERS[(way + 2 * again) % 4]))
    return [_neighbours(rig, f"pose{number:02d}", centre, pose, slides_mm) for number, pose in enumerate(poses, start=1)]


def _neighbours(rig: RigDescription, name: str, centre: FloatArray, pose: _BoardPose, slides_mm: Sequence[float]) -> Iterator[Viewpoint]:
    """Yield the viewpoint of ``pose``, then the same view from other places of the guide, with lesser tilts of the board, upside down."""
    for turn_deg in (0.0, 180.0):
        for tilt_share in TILT_SHARES:
            tilted = replace(pose, tilt_deg=pose.tilt_deg * tilt_share, turn_deg=pose.turn_deg + turn_deg)
            for slide_mm in slides_mm:
                yield _viewpoint(rig, name, centre, tilted, slide_mm)


def _viewpoint(rig: RigDescription, name: str, centre: FloatArray, pose: _BoardPose, slide_mm: float = 0.0) -> Viewpoint:
    """Return the viewpoint that gives this pose of the board on its stand; ``slide_mm`` offsets the guide."""
    guide_from_board = board_on_stand(centre)
    guide_from_head = guide_from_board @ pose.head_from_board(rig).inverse()
    guide_mm = round(SLIDE_SHARE * float(guide_from_head.translation_mm[1]) + slide_mm, 1)
    base_from_guide = RigidTransform.from_parts(np.eye(3), [0.0, -guide_mm, 0.0], "base", "guide")
    base_from_flange = base_from_guide @ guide_from_head @ rig.flange_from_head.transform("flange", "head").inverse()
    return Viewpoint(id=name, flange=FlangePose.of(base_from_flange), guide_mm=guide_mm, table_deg=0.0)


def _axis(rig: RigDescription, centre: FloatArray) -> list[Viewpoint]:
    """One pose of the robot, with the table turned to both sides as far as the board is visible."""
    look_at = LookAt(0.0, BOARD_ELEVATION_DEG + 10.0, rig.standoff_mm + 60.0)
    angles = np.arange(-60.0, 60.1, 10.0)
    return [
        viewpoint_looking_at(rig, f"axis{index + 1:02d}", centre, look_at, table_deg=round(float(angle), 3))
        for index, angle in enumerate(angles)
    ]


def _passes(rig: RigDescription, centre: FloatArray, names: Sequence[str]) -> list[Viewpoint]:
    """A few poses of the robot, each slid along the guide as far as one camera at least still sees the board.

    With the robot stationary its error does not affect the guide's direction and scale. Longer travel determines them better, but is
    limited by the field of view; so the board passes several times, high and low in the image and tilted to either side, which also
    helps the camera calibration.
    """
    views = []
    for name in names:
        tilt_deg, lean_deg, side, beyond_mm = PASSES[name]
        still = _viewpoint(rig, name, centre, _BoardPose(tilt_deg, lean_deg, 0.0, rig.standoff_mm + beyond_mm, (0, side)))
        places = [round(still.guide_mm + slide_mm, 1) for slide_mm in SLIDES_MM]
        views += [still.model_copy(update={"id": f"{name}{number:02d}", "guide_mm": at}) for number, at in enumerate(places, start=1)]
    return views


def _stations(plan: ScanPlan | None) -> list[Viewpoint]:
    """The board from every station of the robot in the plan, with the table turned to both sides."""
    places = {} if plan is None else {(viewpoint.flange, viewpoint.guide_mm): None for viewpoint in plan}
    return [
        Viewpoint(id=f"station{number + 1:02d}-{turn + 1}", flange=flange, guide_mm=guide_mm, table_deg=angle)
        for turn, angle in enumerate(STATION_ANGLES_DEG)  # outer loop: the robot approaches every station several times
        for number, (flange, guide_mm) in enumerate(places)
    ]
