"""Where to look at the calibration board from, so that one automatic run determines the whole rig."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import get_args

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import FlangePose, Motion, ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.planning.reach import obstacles
from measureapp.planning.viewpoints import Gaze, viewpoint_looking_at

ALL_MOTIONS: tuple[Motion, ...] = get_args(Motion)
BOARD_ABOVE_TABLE_MM = 90.0  # centre of a board on its stand, tilted 45° towards the robot
BOARD_ELEVATION_DEG = 45.0
LIGHT_DEG, STRONG_DEG = 24.0, 42.0  # with 42° the board still leans by 20° before a camera that looks askance by as much
LEANS_DEG = (0.0, 90.0, 180.0, 270.0)  # to which side of the image the board's face turns: right, down, left, up
TURNS_DEG = (0.0, 90.0, 180.0, -90.0)  # of the board in the image
CORNERS = ((-1, -1), (1, 1), (1, -1), (-1, 1))
DISTANCES_MM = (20.0, 55.0, 95.0)  # beyond the standoff
ASIDE = (0.155, 0.145)  # of the field, how far the board's middle goes into a corner: its outer marks then come near the image's border
ASIDE_ON_EDGE = (0.215, 0.07)  # the same where the board stands on its short side
ASIDE_STRONG = 0.9  # of that for a strong lean, by which the board's nearer side grows
SLIDE_SHARE = 0.7  # of the way sideways that the slide goes, the arm the rest
STATION_ANGLES_DEG = (-50.0, -25.0, 0.0, 25.0, 50.0)
# past the board along the guide: tilt, lean, to which side (up: -1) of the image the board goes, distance beyond the standoff
PASSES = {"guide": (5.0, 90.0, 0, 80.0), "below": (25.0, 0.0, 1, 60.0), "above": (25.0, 180.0, -1, 60.0)}
SLIDES_MM = tuple(28.0 * step for step in range(-5, 6))
CHECK_ANGLES_DEG = (-12.0, 0.0, 12.0, 0.0)
CHECK_SLIDES_MM = (-30.0, -10.0, 10.0, 30.0)  # beside where the slide follows the head; the arm reaches back


def calibration_viewpoints(
    rig: RigDescription, plan: ScanPlan | None = None, motions: Sequence[Motion] = ALL_MOTIONS, *, guide_at_zero: bool = False
) -> tuple[Viewpoint, ...]:
    """Return the viewpoints of a calibration: `pose…` for cameras and hand-eye, `axis…`, `guide…` and further passes along it, `station…`.

    The poses bring the board into the corners of the images, for distortion is known only where there were marks, and let it lean to
    all four sides. Turning it in the image meanwhile also gives hand-eye what Tsai and Lenz ask for (IEEE Trans. Robotics and
    Automation 5(3), 1989): large rotations about axes that are not parallel. From the stations of ``plan`` the board is viewed at several
    table angles: a part appears enlarged by twice the robot's error towards the table unless that error is known where the scan is made.
    Viewpoints that the rig cannot reach are omitted.

    Parameters
    ----------
    motions : which of these groups
    guide_at_zero : reach the same views with the guide at 0, as far as possible: the robot's base then stays where it is
    """
    centre = _board_middle_mm(rig)
    groups: dict[Motion, Callable[[], list[Viewpoint]]] = {
        "robot": lambda: _poses(rig, centre),
        "table": lambda: _axis(rig, centre),
        "guide": lambda: _passes(rig, centre, ("guide",)),
        "passes": lambda: _passes(rig, centre, ("below", "above")),
        "stations": lambda: _stations(plan),
    }
    candidates = (viewpoint for motion in groups if motion in motions for viewpoint in groups[motion]())
    chosen = (_with_guide_at_zero(one) for one in candidates if not obstacles(one, rig)) if guide_at_zero else candidates
    return tuple(viewpoint for viewpoint in chosen if not obstacles(viewpoint, rig))


def _with_guide_at_zero(viewpoint: Viewpoint) -> Viewpoint:
    slid = RigidTransform.from_parts(np.eye(3), np.array([0.0, viewpoint.guide_mm, 0.0]), "base", "base")
    flange = FlangePose.of(slid @ viewpoint.flange.transform())
    return viewpoint.model_copy(update={"flange": flange, "guide_mm": 0.0})


def check_viewpoints(rig: RigDescription) -> tuple[Viewpoint, ...]:
    """Return a few poses with the board in the middle, the table turned a little, which differ in every axis: each link of the chain is tested."""
    centre = _board_middle_mm(rig)
    looks = [
        _Look(LIGHT_DEG, lean, turn, rig.standoff_mm + DISTANCES_MM[1], (0, 0)) for lean, turn in zip(LEANS_DEG, TURNS_DEG, strict=True)
    ]
    views = [
        _viewpoint(rig, f"check{number:02d}", centre, look, aside_mm)
        for number, (look, aside_mm) in enumerate(zip(looks, CHECK_SLIDES_MM, strict=True), start=1)
    ]
    turned = [view.model_copy(update={"table_deg": angle}) for view, angle in zip(views, CHECK_ANGLES_DEG, strict=True)]
    return tuple(view for view in turned if not obstacles(view, rig))


def _board_middle_mm(rig: RigDescription) -> FloatArray:
    return np.array(rig.table.centre_in_guide_mm) + np.array([0.0, 0.0, BOARD_ABOVE_TABLE_MM])


@dataclass(frozen=True, slots=True)
class _Look:
    """How the board is to appear before the head."""

    tilt_deg: float  # of its face against the head's line of sight
    lean_deg: float  # to which side of the image its face turns; 0: right, 90: down
    turn_deg: float  # in the image, before it is tilted
    distance_mm: float
    corner: tuple[int, int]  # of the image, into which it goes; (0, 0): in the middle

    def head_from_board(self, rig: RigDescription) -> RigidTransform:
        """Return head_from_board, the board's origin in its middle."""
        lean = np.deg2rad(self.lean_deg)
        tilt = rotation_about([-np.sin(lean), np.cos(lean), 0.0], np.deg2rad(self.tilt_deg))
        turn = rotation_about([0.0, 0.0, 1.0], np.deg2rad(self.turn_deg))
        camera = rig.camera(rig.reference)
        field_mm = np.array([camera.width_px, camera.height_px]) * self.distance_mm / camera.focal_px
        aside = np.array(ASIDE_ON_EDGE if self.turn_deg % 180.0 else ASIDE) * (ASIDE_STRONG if self.tilt_deg > LIGHT_DEG else 1.0)
        return RigidTransform.from_parts(tilt @ turn, [*(aside * self.corner * field_mm), self.distance_mm], "head", "board")


def _poses(rig: RigDescription, centre: FloatArray) -> list[Viewpoint]:
    """The board leaning to each of four sides, lightly once per corner of the image and strongly twice, turned in the image meanwhile.

    A strong lean goes by the sides of the board, where the robot can reach: to lean up or down in the image the head is rolled.
    """
    views = []
    for way, lean_deg in enumerate(LEANS_DEG):
        for corner, side in enumerate(CORNERS):
            distance_mm = rig.standoff_mm + DISTANCES_MM[(way + 2 * corner) % 3]
            views.append(_Look(LIGHT_DEG, lean_deg, TURNS_DEG[(way + corner) % 4], distance_mm, side))
    for way, lean_deg in enumerate(LEANS_DEG):
        for again, distance_mm in enumerate((DISTANCES_MM[0], DISTANCES_MM[-1])):
            turn_deg = TURNS_DEG[2 * again + way % 2]
            views.append(_Look(STRONG_DEG, lean_deg, turn_deg, rig.standoff_mm + distance_mm, CORNERS[(way + 2 * again) % 4]))
    return [_viewpoint(rig, f"pose{number:02d}", centre, look) for number, look in enumerate(views, start=1)]


def _viewpoint(rig: RigDescription, name: str, centre: FloatArray, look: _Look, aside_mm: float = 0.0) -> Viewpoint:
    """The viewpoint from which the board on its stand appears like that, the slide following the head or standing beside it."""
    slope = np.deg2rad(BOARD_ELEVATION_DEG)
    across, down = np.array([0.0, -1.0, 0.0]), np.array([-np.sin(slope), 0.0, -np.cos(slope)])
    guide_from_board = RigidTransform.from_parts(np.column_stack([across, down, np.cross(across, down)]), centre, "guide", "board")
    guide_from_head = guide_from_board @ look.head_from_board(rig).inverse()
    guide_mm = round(SLIDE_SHARE * float(guide_from_head.translation_mm[1]) + aside_mm, 1)
    base_from_guide = RigidTransform.from_parts(np.eye(3), [0.0, -guide_mm, 0.0], "base", "guide")
    base_from_flange = base_from_guide @ guide_from_head @ rig.flange_from_head.transform("flange", "head").inverse()
    return Viewpoint(id=name, flange=FlangePose.of(base_from_flange), guide_mm=guide_mm, table_deg=0.0)


def _axis(rig: RigDescription, centre: FloatArray) -> list[Viewpoint]:
    """One pose of the robot, the table turned as far as the board stays in sight to both sides."""
    gaze = Gaze(0.0, BOARD_ELEVATION_DEG + 10.0, rig.standoff_mm + 60.0)
    angles = np.arange(-60.0, 60.1, 10.0)
    return [
        viewpoint_looking_at(rig, f"axis{index + 1:02d}", centre, gaze, table_deg=round(float(angle), 3))
        for index, angle in enumerate(angles)
    ]


def _passes(rig: RigDescription, centre: FloatArray, names: Sequence[str]) -> list[Viewpoint]:
    """A few poses of the robot, each slid along the guide as far as one camera at least still sees the board.

    Only a robot that stands still carries none of its error into the guide's direction and scale. A longer travel tells them better, but ends
    with the image; so the board passes several times, higher and lower in the image and turned to either side, which shows the cameras too.
    """
    views = []
    for name in names:
        tilt_deg, lean_deg, side, beyond_mm = PASSES[name]
        still = _viewpoint(rig, name, centre, _Look(tilt_deg, lean_deg, 0.0, rig.standoff_mm + beyond_mm, (0, side)))
        places = [round(still.guide_mm + slide_mm, 1) for slide_mm in SLIDES_MM]
        views += [still.model_copy(update={"id": f"{name}{number:02d}", "guide_mm": at}) for number, at in enumerate(places, start=1)]
    return views


def _stations(plan: ScanPlan | None) -> list[Viewpoint]:
    """The board from every place at which the plan lets the robot stand, the table turned to both sides."""
    places = {} if plan is None else {(viewpoint.flange, viewpoint.guide_mm): None for viewpoint in plan}
    return [
        Viewpoint(id=f"station{number + 1:02d}-{turn + 1}", flange=flange, guide_mm=guide_mm, table_deg=angle)
        for turn, angle in enumerate(STATION_ANGLES_DEG)  # outer loop: the robot comes to every station several times
        for number, (flange, guide_mm) in enumerate(places)
    ]
