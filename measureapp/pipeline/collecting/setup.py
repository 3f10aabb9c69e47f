"""What a collection is for, and what it needs to know beforehand."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from typing import Literal

from measureapp.calibrate.boards.find import require_unambiguous
from measureapp.calibrate.cameras.camera import FIXED_COEFFICIENTS
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, HandEye
from measureapp.errors import InputError

Kind = Literal["cameras", "projector", "axis", "hand-eye", "guide", "rig"]
KINDS: tuple[Kind, ...] = ("cameras", "projector", "axis", "hand-eye", "guide", "rig")
PURPOSES: Mapping[Kind, str] = {
    "cameras": "a calibration of several cameras",
    "projector": "the projector",
    "axis": "the rotation axis",
    "hand-eye": "the hand-eye transform",
    "guide": "the linear guide",
    "rig": "the rig",
}
NEEDED: Mapping[Kind, tuple[str, ...]] = {
    "cameras": (),
    "projector": (),
    "axis": (),  # table angles help, but can be estimated
    "hand-eye": ("base_from_flange",),
    "guide": ("base_from_flange", "guide_mm"),
    "rig": ("base_from_flange", "guide_mm", "table_rad"),
}
"""Which read-backs an observation must have, by kind."""


@dataclass(frozen=True, slots=True, eq=False)
class Setup:
    """Everything a collection is told before the first image.

    Raises
    ------
    InputError
        The cameras or the hand-eye transform that this kind needs are missing, or names do not fit.
    CalibrationError
        The board looks the same after half a turn, where that matters.
    """

    kind: Kind
    board: BoardDescription
    camera_names: tuple[str, ...]  # the reference first
    cameras: CameraArrayCalibration | None = None  # needed by projector, axis, hand-eye and guide; a rig without them calibrates its own
    hand_eye: HandEye | None = None  # needed by guide; an axis that is to be told in the rig is judged with it
    noise: AxisNoise = field(default_factory=AxisNoise)
    distortion_count: int = 5
    standoff_mm: float | None = None  # where parts are measured; None: where the board was shown
    length_mm: float = 300.0  # for which the verdict is told
    serials: Mapping[str, str] = field(default_factory=dict)  # camera -> serial number
    projector_px: tuple[int, int] | None = None  # width and height of the projector's image, where it is calibrated

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise InputError(f"{self.kind!r} is no kind of calibration.", "Choose one of: " + ", ".join(KINDS) + ".")
        if not self.camera_names or len(set(self.camera_names)) < len(self.camera_names):
            raise InputError("Every camera needs a name of its own.", "Name the cameras once each, the reference first.")
        if self.distortion_count not in FIXED_COEFFICIENTS:
            raise InputError(f"{self.distortion_count} distortion coefficients are not offered.", "Choose 4, 5 or 8.")
        if self.kind != "cameras" or len(self.camera_names) > 1:
            require_unambiguous(self.board, PURPOSES[self.kind])
        if self.cameras is None and not self.calibrates_cameras:
            raise InputError(f"To calibrate {PURPOSES[self.kind]}, calibrated cameras are needed.", "Calibrate the cameras first.")
        if self.kind == "cameras" and self.cameras is not None:
            raise InputError("The cameras are what is to be calibrated.", "Start without calibrated cameras; compare with them later.")
        unknown = [name for name in self.camera_names if self.cameras is not None and name not in self.cameras.cameras]
        if unknown and self.cameras is not None:
            raise InputError(f"Camera {unknown[0]!r} is not calibrated.", "There are: " + ", ".join(self.cameras.cameras) + ".")
        if self.kind == "projector":
            self._require_projector()
        if self.kind == "guide" and self.hand_eye is None:
            raise InputError("To calibrate the linear guide, the hand-eye transform is needed.", "Calibrate hand-eye first.")

    def _require_projector(self) -> None:
        if PROJECTOR in self.camera_names:
            raise InputError(f"A camera is called {PROJECTOR!r}.", "Give the camera another name.")
        if self.projector_px is None:
            raise InputError("The size of the projector's image is not known.", "Give columns and rows of the projector.")

    @property
    def reference(self) -> str:
        """The camera in whose frame the result is told."""
        return self.camera_names[0] if self.cameras is None else self.cameras.reference

    @property
    def calibrates_cameras(self) -> bool:
        """Whether the cameras are part of the result."""
        return self.kind == "cameras" or (self.kind == "rig" and self.cameras is None)

    @property
    def lenses(self) -> tuple[str, ...]:
        """Whose lens and place are the result: cameras, or the projector."""
        return self.camera_names if self.calibrates_cameras else (PROJECTOR,) if self.kind == "projector" else ()

    @property
    def seeing(self) -> tuple[str, ...]:
        """Who sees the board: the cameras, and before them the projector where it is calibrated."""
        return (PROJECTOR, *self.camera_names) if self.kind == "projector" else self.camera_names

    def is_seen(self, by: Collection[str]) -> bool:
        """Whether a position counts that these saw."""
        return PROJECTOR in by if self.kind == "projector" else bool(by)
