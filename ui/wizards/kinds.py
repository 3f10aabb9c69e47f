"""What the wizards have in common is one window; here is how they differ."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ui.controllers.collecting_nouns import Kind

Needs = Literal["", "cameras", "rig"]


@dataclass(frozen=True)
class WizardKind:
    """One wizard in words."""

    kind: Kind
    title: str
    action: str  # on its button
    tip: str
    purpose: str  # said on the first page
    tables: tuple[str, ...]  # what recorded images need besides: where these axes stood
    step: str  # the name of the second step
    tips: tuple[str, ...]  # what good views are like
    needs: Needs = ""  # what has to be calibrated before
    recorded: str = "Recorded images"
    folder: str = "A folder with images such as left01.png, right01.png: images with the same number show the same place of the board."


VIEWS = (
    "Cover the images to their borders and corners: lenses distort most there.",
    "Tilt the board by 20° to 45° to all four sides: that tells the focal length from the distance.",
    "Show it nearer and farther, sharp, evenly lit and not so bright that its white is clipped.",
)
ALL = ("base_from_flange", "guide_mm", "table_rad")
CAMERAS = WizardKind(
    "cameras",
    "Calibrate the cameras",
    "Cameras",
    "Focal length, image centre, distortion and place of every camera",
    "Finds lens and place of every camera from images of a board seen from many sides. Fill the images to their borders, and tilt the board.",
    (),
    "Show the board",
    VIEWS,
)
PROJECTOR = WizardKind(
    "projector",
    "Calibrate the projector",
    "Projector",
    "Lens and place of the projector, beside cameras that are calibrated",
    "Finds lens and place of the projector from fringes of both directions on the board, with the cameras as they are calibrated. "
    "The phases around a corner of the board say which projector pixel lights it.",
    (),
    "Take the views",
    (
        "Bring the board to the borders of the projector's light, not only of the images.",
        "Tilt it by 20° to 45° to all four sides, and show it nearer and farther.",
        "Nothing moves while the fringes of one view are taken. White should be bright, but not clipped.",
    ),
    "cameras",
    "Recorded fringes",
    "A folder with one folder per place of the board, each with its fringe images of both directions and a MANIFEST.toml.",
)
RIG = WizardKind(
    "rig",
    "Calibrate the whole rig",
    "Whole rig",
    "Cameras, hand–eye, linear guide and table axis in one automatic run",
    "Fix the board on the table. The rig looks at it from all sides, slides along the guide and turns the table, and everything is solved together.",
    ALL,
    "Take the views",
    VIEWS,
)
HAND_EYE = WizardKind(
    "hand-eye",
    "Calibrate hand–eye",
    "Hand–eye",
    "Where the head sits on the robot's flange",
    "Finds where the head sits on the flange, with the cameras as they are calibrated. Fix the board on the table; the robot turns the head.",
    ("base_from_flange",),
    "Take the views",
    (
        "The board must not move between the views.",
        "Turn the head about all three axes: up and down, sideways, and about its line of sight.",
        "Take ten poses or more: the robot's own errors average out.",
    ),
    "rig",
)
GUIDE = WizardKind(
    "guide",
    "Calibrate the linear guide",
    "Linear guide",
    "Direction and scale of the guide",
    "Finds direction and scale of the guide, with cameras and hand–eye as they are calibrated. Fix the board on the table; the robot slides past.",
    ("base_from_flange", "guide_mm"),
    "Take the views",
    (
        "Neither the board nor the robot's arm moves; the slide does.",
        "Slide as far as the board stays in sight: the longer the way, the better its direction.",
    ),
    "rig",
)
AXIS = WizardKind(
    "axis",
    "Calibrate the table axis",
    "Table axis",
    "Where the rotary table's axis stands",
    "Finds the table's axis, with cameras and robot as they are calibrated. Fix the board on the table; the table turns it.",
    ALL,
    "Take the views",
    (
        "Fix the board on the table so that it cannot slip.",
        "Turn the table as far as the board stays in sight: short arcs leave their centre uncertain.",
    ),
    "rig",
)
KINDS = (RIG, CAMERAS, PROJECTOR, HAND_EYE, GUIDE, AXIS)
