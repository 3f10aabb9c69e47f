"""One sighting of the board: its images, where the axes stood, what was found, and what came of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.calibrate.cameras.projector_sightings import ProjectorPixels, called
from measureapp.calibrate.motions.axis_noise import SAME_POSE
from measureapp.calibrate.sightings import Cause, FoundBoard
from measureapp.data.fringe import AxisReadback
from measureapp.errors import CalibrationError, StorageError
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.projector_pixels import checksum_of, read_projector_pixels
from measureapp.project.frame_store import checksum
from measureapp.project.images import read_image

READBACK_WORDS = {"base_from_flange": "the robot's pose", "guide_mm": "the guide's position", "table_rad": "the table's angle"}
Standing = Literal["new", "used", "rejected", "removed", "no board"]


@dataclass(frozen=True, slots=True, eq=False)
class Readback:
    """Where the axes said they were, as far as it is known: a table alone has no robot."""

    base_from_flange: RigidTransform | None = None
    guide_mm: float | None = None
    table_rad: float | None = None

    @classmethod
    def of(cls, full: AxisReadback) -> Readback:
        """Return the read-back of a whole rig."""
        return cls(full.base_from_flange, full.guide_mm, full.table_rad)

    def holds_cameras_as(self, other: Readback) -> bool:
        """Whether the cameras stood where they stand in another one; without robot and guide they are taken to be fixed."""
        mine, theirs = self.base_from_flange, other.base_from_flange
        if (mine is None) != (theirs is None) or (self.guide_mm is None) != (other.guide_mm is None):
            return False
        slid = abs((self.guide_mm or 0.0) - (other.guide_mm or 0.0))
        gap = np.zeros(1) if mine is None or theirs is None else mine.matrix - theirs.matrix
        return slid <= SAME_POSE and bool(np.abs(gap).max() <= SAME_POSE)

    def full(self) -> AxisReadback:
        """Return it as that of a whole rig. Raises CalibrationError where an axis is missing."""
        if self.base_from_flange is None or self.guide_mm is None or self.table_rad is None:
            raise CalibrationError("The read-back of an axis is missing.", "Give robot pose, slide position and table angle.")
        return AxisReadback(self.base_from_flange, self.guide_mm, self.table_rad)


@dataclass(frozen=True, slots=True)
class StoredImage:
    """An image on disk, read only when it is looked at."""

    path: Path
    checksum: str  # SHA-256 of its pixels
    size_px: tuple[int, int]  # (width, height)
    name: str = ""  # of the file it came from; empty for one from a camera

    def pixels(self) -> ImageArray:
        """Return the image (H, W). Raises InputError where the file is damaged or gone."""
        return read_image(self.path)

    def verified(self) -> ImageArray:
        """Return the image (H, W). Raises InputError as `pixels`, StorageError where it is not the one that was kept."""
        found = self.pixels()
        _require_same(self.path, checksum(found), self.checksum)
        return found


@dataclass(frozen=True, slots=True)
class StoredPixels:
    """Which pixels of the projector light the board in one camera's image, on disk."""

    path: Path
    checksum: str  # SHA-256 of its arrays
    camera: str

    def verified(self) -> ProjectorPixels:
        """Return them. Raises StorageError where the file is damaged or gone, or not the one that was kept."""
        found = read_projector_pixels(self.path)
        _require_same(self.path, checksum_of(found), self.checksum)
        return found


def _require_same(path: Path, found: str, kept: str) -> None:
    if found != kept:
        raise StorageError(f"{path} is not what was kept: its checksum differs.", "Restore it from a backup.")


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why no marks were taken from an image."""

    cause: Cause
    message: str
    hint: str


@dataclass(frozen=True, slots=True, eq=False)
class Observation:
    """One position of the board as all cameras saw it.

    `standing` and the residuals are those of the last solution; an observation that came later is "new".
    """

    id: str
    images: Mapping[str, StoredImage]
    readback: Readback
    seen: Mapping[str, FoundBoard]  # camera -> marks
    refused: Mapping[str, Refusal]  # camera -> why it gave none
    temperature_c: float | None = None  # of the head, where it was measured
    lit: StoredPixels | None = None  # of a position under fringes: what the projector's marks were read from
    standing: Standing = "new"
    reason: str = ""  # in words, where it is not used or only in part
    residuals_px: Mapping[str, float] = field(default_factory=dict)  # camera -> rms distance of its marks from where they should be
    residual_mm: float | None = None  # the same on the board, where axes are calibrated
    approach: int | None = None  # of the robot, counted over all that was collected


def lost_images(observations: Iterable[Observation]) -> list[tuple[str, str]]:
    """Return the images of observations that show nothing at all, as they are called, with the reason and what to do."""
    return [
        (f"observation {one.id}, {called(camera)[0].lower()}{called(camera)[1:]}", f"{refusal.message} {refusal.hint}")
        for one in observations
        if one.standing == "no board"
        for camera, refusal in one.refused.items()
    ]
