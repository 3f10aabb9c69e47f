"""Detection of the board under fringes: its marks in every camera, and in projector coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR, ProjectorPixels, projector_sighting
from measureapp.calibrate.sightings import Rejection, Sighting
from measureapp.data.board import BoardDescription
from measureapp.data.fringe import FringeStack, PhaseShiftGroup
from measureapp.data.phase import PhaseMap
from measureapp.errors import CalibrationError, DecodeError
from measureapp.fringe.decode import decode
from measureapp.fringe.settings import DecodeSettings
from measureapp.progress import Progress


@dataclass(frozen=True, slots=True, eq=False)
class BoardInFringes:
    """The marks and phases of one position of the board."""

    view: str
    images: Mapping[str, ImageArray]  # camera -> (H, W) uint8, the board in even light
    seen: Mapping[str, Sighting]  # camera -> marks
    refused: Mapping[str, CalibrationError]  # camera -> reason why it has none
    phases: Mapping[str, PhaseMap]  # camera that detected the board -> phase of the vertical fringes, with that of the horizontal ones
    lit: Mapping[str, ProjectorPixels]  # camera that detected the board -> the projector's pixels around its marks
    readings: Mapping[
        str, Sighting | Rejection
    ]  # camera that detected the board -> the marks in the projector's pixels, or the reason for their rejection

    @property
    def best(self) -> str | None:
        """The camera whose marks are used for the projector: that with most marks with both phases; None without any."""
        counts = {camera: len(one.corners_px) for camera, one in self.readings.items() if isinstance(one, Sighting)}
        return max(counts, key=lambda camera: counts[camera], default=None)

    @property
    def all_sightings(self) -> dict[str, Sighting]:
        """The marks in every camera, and in the projector's pixels as the best camera reads them."""
        reading = None if self.best is None else self.readings[self.best]
        return {**self.seen, **({PROJECTOR: reading} if isinstance(reading, Sighting) else {})}


def detect_under_fringes(
    stack: FringeStack, view: str, board: BoardDescription, settings: DecodeSettings, progress: Progress
) -> BoardInFringes:
    """Find the board in the mean image of every camera, decode the fringes, and interpolate the phases at the marks.

    Raises
    ------
    CalibrationError
        The stack has fringes in one direction only.
    """
    require_both_directions(stack)
    images, seen, refused = {}, {}, {}
    for camera in stack.images:
        images[camera], found = _board(stack, camera, board)
        if isinstance(found, Sighting):
            seen[camera] = found
        else:
            refused[camera] = found
    if not seen:
        progress.report(1, 1)
        return BoardInFringes(view, images, seen, refused, {}, {}, {})
    try:
        phases = decode(replace(stack, images={camera: stack.images[camera] for camera in seen}), settings, progress)
    except DecodeError as error:
        reason = error.message.rstrip(".")
        return BoardInFringes(view, images, seen, refused, {}, {}, {camera: Rejection(PROJECTOR, view, reason) for camera in seen})
    marks = {camera: found.of(camera, view) for camera, found in seen.items()}
    lit = {camera: pixels for camera, one in marks.items() if (pixels := ProjectorPixels.around(one, phases[camera])) is not None}
    readings = {camera: projector_sighting(one, lit.get(camera)) for camera, one in marks.items()}
    return BoardInFringes(view, images, seen, refused, phases, lit, readings)


def require_both_directions(stack: FringeStack) -> None:
    """Raise CalibrationError for fringes in one direction only, which do not determine the projector's other coordinate."""
    directions = stack.patterns.directions
    if len(directions) < 2:
        raise CalibrationError(
            f"{stack.viewpoint_id} has {directions[0]} fringes only; the projector needs those of both directions.",
            "Record vertical and horizontal fringes at every position: `measureapp patterns export` writes such a set.",
        )


def projector_size_px(stack: FringeStack) -> tuple[int, int]:
    """Return width and height of the projector's image over which the fringes of both directions run."""
    return stack.patterns.projector_px, stack.patterns.projector_rows or stack.patterns.projector_px


def board_image(stack: FringeStack, camera: str, exposure: int) -> ImageArray:
    """Return the mean (H, W) of the sinusoidal images of one exposure: the board in even light; full scale where one is saturated."""
    images = stack.images[camera][exposure]
    groups = [group for group in stack.patterns.groups for _ in range(group.count)]
    sinusoids = [number for number, group in enumerate(groups) if isinstance(group, PhaseShiftGroup)]
    mean = np.zeros(images.shape[1:], np.float32)
    clipped = np.zeros(images.shape[1:], bool)
    for number in sinusoids:
        mean += images[number]
        clipped |= images[number] >= stack.saturation
    levels = np.round(mean * (255.0 / stack.saturation / len(sinusoids)))
    return np.where(clipped, 255, levels).astype(np.uint8)


def _board(stack: FringeStack, camera: str, board: BoardDescription) -> tuple[ImageArray, Sighting | CalibrationError]:
    """The board in the longest exposure that allows it; without any the longest one's image and its reason."""
    first: tuple[ImageArray, CalibrationError] | None = None
    for exposure in range(len(stack.exposures_us)):
        image = board_image(stack, camera, exposure)
        try:
            return image, find_board(image, board)
        except CalibrationError as error:
            first = first or (image, error)
    assert first is not None  # a stack has an exposure
    return first
