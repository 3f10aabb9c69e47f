"""What the wizards have in common is one window; here is how they differ."""

from __future__ import annotations

from dataclasses import dataclass

from ui.controllers.collecting_nouns import Kind


@dataclass(frozen=True)
class WizardKind:
    """One wizard in words."""

    kind: Kind
    title: str
    action: str  # on its button
    tip: str
    purpose: str  # said on the first page
    takes_images: bool  # whether recorded images alone are enough, without read-backs of the axes
    step: str  # the name of the second step


CAMERAS = WizardKind(
    "cameras",
    "Calibrate the cameras",
    "Cameras",
    "Focal length, image centre, distortion and place of every camera",
    "Finds lens and place of every camera from images of a board seen from many sides. Fill the images to their borders, and tilt the board.",
    True,
    "Show the board",
)
