"""An observation of a session: its images on disk, refused images with reasons, and its fit to the last solution."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

from measureapp.arrays import ImageArray
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.cameras.projector_sightings import ProjectorPixels, device_title
from measureapp.calibrate.draft.draft import Solved
from measureapp.calibrate.sightings import Cause
from measureapp.errors import StorageError
from measureapp.project.calibration.projector_pixels import checksum_of, read_projector_pixels
from measureapp.project.frame_store import checksum
from measureapp.project.images import read_image

Status = Literal["new", "used", "rejected", "removed", "no board"]


@dataclass(frozen=True, slots=True)
class StoredImage:
    """An image on disk, read only when it is needed."""

    path: Path
    checksum: str  # SHA-256 of its pixels
    size_px: tuple[int, int]  # (width, height)
    name: str = ""  # of the file it came from; empty for one from a camera

    def pixels(self) -> ImageArray:
        """Return the image (H, W). Raises InputError where the file is damaged or gone."""
        return read_image(self.path)

    def read_verified(self) -> ImageArray:
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

    def read_verified(self) -> ProjectorPixels:
        """Return them. Raises StorageError where the file is damaged or gone, or not the one that was kept."""
        found = read_projector_pixels(self.path)
        _require_same(self.path, checksum_of(found), self.checksum)
        return found


def _require_same(path: Path, found: str, kept: str) -> None:
    if found != kept:
        raise StorageError(f"{path} has changed since it was saved: its checksum differs.", "Restore it from a backup.")


@dataclass(frozen=True, slots=True)
class Refusal:
    """The reason why an image has no marks."""

    cause: Cause
    message: str
    hint: str


@dataclass(frozen=True, slots=True, eq=False)
class CollectedObservation(Observation):
    """An observation with its images on disk.

    `status` and the residuals are those of the last solution; an observation that was added later is "new".
    """

    images: Mapping[str, StoredImage] = field(default_factory=dict)
    refused: Mapping[str, Refusal] = field(default_factory=dict)  # camera -> reason
    temperature_c: float | None = None  # of the head, where it was measured
    lit: StoredPixels | None = None  # of a position under fringes: source of the projector's marks
    status: Status = "new"
    reason: str = ""  # in words, where it is not used or only in part
    residuals_px: Mapping[str, float] = field(default_factory=dict)  # camera -> rms distance of its marks from the predicted ones
    residual_mm: float | None = None  # the same on the board, where axes are calibrated

    @property
    def refusals(self) -> str:
        """Reasons of refused images, in sentences."""
        return " ".join(f"{device_title(camera)}: {refusal.message} {refusal.hint}" for camera, refusal in self.refused.items())

    @property
    def unclear(self) -> tuple[str, ...]:
        """The cameras that see an ambiguous part of the board, which calibrated cameras may identify; none where it was removed."""
        return () if self.status == "removed" else tuple(camera for camera, refusal in self.refused.items() if refusal.cause == "part")

    def with_fit(self, solved: Solved) -> CollectedObservation:
        """Return the observation with its fit to a solution that it entered."""
        return replace(
            self,
            status="used" if self.id in solved.used else "rejected",
            reason=_sentences(solved.reasons.get(self.id, ""), self.refusals),
            residuals_px=solved.residuals_px.get(self.id, {}),
            residual_mm=solved.residuals_mm.get(self.id),
        )


def images_without_board(observations: Iterable[CollectedObservation]) -> list[tuple[str, str]]:
    """Return the images of observations without any marks by name, each with the reason and the remedy."""
    return [
        (f"observation {one.id}, {device_title(camera)[0].lower()}{device_title(camera)[1:]}", f"{refusal.message} {refusal.hint}")
        for one in observations
        if one.status == "no board"
        for camera, refusal in one.refused.items()
    ]


def _sentences(*parts: str) -> str:
    whole = (part[0].upper() + part[1:] for part in parts if part)
    return " ".join(part if part.endswith(".") else f"{part}." for part in whole)
