"""Detection of the board in the images of one position, with the reason where an image gives nothing."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import pose_of
from measureapp.calibrate.boards.predicted_part import find_part_by_cameras, find_part_by_table
from measureapp.calibrate.cameras.projector_picture import projector_picture
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR, ProjectorPixels, projector_sighting
from measureapp.calibrate.draft.draft import Setup
from measureapp.calibrate.motions.axis_noise import SAME_POSE
from measureapp.calibrate.sightings import AmbiguousPart, BoardDetectionError, Sighting
from measureapp.calibration_session.board_in_fringes import BoardInFringes, detect_under_fringes
from measureapp.calibration_session.observation import CollectedObservation, Refusal
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import FringeStack, Readback
from measureapp.errors import CalibrationError
from measureapp.fringe.settings import DecodeSettings
from measureapp.progress import Progress

DETECTION_THREADS = 2
UNLIT = "Light the whole board with the fringes, neither too dark nor clipped."


@dataclass(frozen=True, slots=True, eq=False)
class Detection:
    """The sightings and refused images of one position."""

    images: Mapping[str, ImageArray]  # camera or projector -> image to be stored
    seen: Mapping[str, Sighting]
    refused: Mapping[str, Refusal]
    lit: tuple[str, ProjectorPixels] | None = (
        None  # under fringes: the camera used for the projector, and the projector pixels in its image
    )


@dataclass(frozen=True, slots=True, eq=False)
class DetectionContext:
    """Cameras and other observations that identify ambiguous parts of the board."""

    cameras: CameraArrayCalibration | None  # calibrated before, or as the views collected so far have them
    observations: Sequence[Observation] = ()  # other positions


def detect(images: Mapping[str, ImageArray], readback: Readback, board: BoardDescription, context: DetectionContext) -> Detection:
    """Detect the board in one image of each camera; ambiguous parts are identified by `identify_parts`."""
    with ThreadPoolExecutor(DETECTION_THREADS) as pool:
        results = dict(zip(images, pool.map(lambda pixels: _try_find(lambda: find_board(pixels, board)), images.values()), strict=True))
    known = {camera: one for camera, one in results.items() if isinstance(one, Sighting)}
    unclear = {camera: images[camera] for camera, one in results.items() if isinstance(one, AmbiguousPart)}
    results |= identify_parts(unclear, known, readback, board, context)
    refused = {camera: refusal(one) for camera, one in results.items() if isinstance(one, CalibrationError)}
    return Detection(images, {camera: one for camera, one in results.items() if isinstance(one, Sighting)}, refused)


def identify_parts(
    unclear: Mapping[str, ImageArray], known: Mapping[str, Sighting], readback: Readback, board: BoardDescription, context: DetectionContext
) -> dict[str, Sighting | CalibrationError]:
    """Identify the parts of the board in these images: by cameras that detected the same position, else by other table angles.

    Parameters
    ----------
    unclear : camera -> image of a part that may be one of several
    known : other cameras -> their sightings of the same position
    readback : positions of the axes

    Returns
    -------
    camera -> marks, or the reason why they are still ambiguous; empty where they cannot be identified
    """
    cameras, answers = context.cameras, dict[str, Sighting | CalibrationError]()
    if cameras is None or not unclear:
        return answers
    if known:
        return {camera: _try_find(partial(find_part_by_cameras, image, camera, known, cameras, board)) for camera, image in unclear.items()}
    turned, table_rad = _observations_from_here(context.observations, readback, cameras, board), readback.table_rad
    if table_rad is None or not turned:
        return answers
    return {
        camera: _try_find(partial(find_part_by_table, image, camera, turned, table_rad, cameras, board))
        for camera, image in unclear.items()
    }


def _observations_from_here(
    observations: Sequence[Observation], readback: Readback, cameras: CameraArrayCalibration, board: BoardDescription
) -> list[Observation]:
    """Other observations with the cameras in the same place, the table's angle known."""
    found = []
    for one in observations:
        seen = {camera: marks for camera, marks in one.seen.items() if camera in cameras.cameras}
        if seen and one.readback.table_rad is not None and _has_same_camera_pose(one.readback, readback):
            found.append(Observation(one.id, one.readback, pose_of(seen, cameras, board)))
    return found


def _has_same_camera_pose(one: Readback, other: Readback) -> bool:
    """Whether the cameras were in the same place; without robot and guide they are taken to be stationary."""
    first, second = one.base_from_flange, other.base_from_flange
    if (first is None) != (second is None) or (one.guide_mm is None) != (other.guide_mm is None):
        return False
    slid = abs((one.guide_mm or 0.0) - (other.guide_mm or 0.0))
    gap = np.zeros(1) if first is None or second is None else first.matrix - second.matrix
    return slid <= SAME_POSE and bool(np.abs(gap).max() <= SAME_POSE)


def detect_in_fringes(stack: FringeStack, setup: Setup, size_px: tuple[int, int], progress: Progress) -> Detection:
    """Detect the board under fringes, and its marks in projector coordinates.

    Stored are the board in even light for every camera and, for display, for the projector; and around the board which pixel of the
    projector lights each pixel of the camera with most marks, from which the projector's marks can be read again.

    Raises
    ------
    CalibrationError
        The fringes run in one direction only.
    """
    found = detect_under_fringes(stack, stack.viewpoint_id, setup.board, DecodeSettings(), progress)
    images, seen = dict(found.images), found.all_sightings
    refused = {camera: refusal(error) for camera, error in found.refused.items()}
    best = found.best
    if best is None:
        refused[PROJECTOR] = _projector_refusal(found)
        return Detection(images, seen, refused)
    images[PROJECTOR] = projector_picture(found.images[best], found.phases[best], size_px)
    return Detection(images, seen, refused, (best, found.lit[best]))


def detect_in_stored(other: CollectedObservation, setup: Setup, context: DetectionContext) -> Detection:
    """Detect the board again in the stored images of an observation; under fringes, read the projector's marks from the stored projector pixels.

    Raises
    ------
    StorageError, InputError
        An image is damaged or gone, or not the one that was kept.
    CalibrationError
        Nothing was kept of the fringes.
    """
    images = {camera: image.read_verified() for camera, image in other.images.items()}
    if not setup.kind.uses_fringes:
        return detect(images, other.readback, setup.board, context)
    if other.lit is None and PROJECTOR in other.seen:
        raise CalibrationError(
            f"The fringes of observation {other.id} were not kept, so the projector's marks cannot be read again.",
            "It was recorded with an earlier version: record the position again.",
        )
    results = {camera: _try_find(partial(find_board, image, setup.board)) for camera, image in images.items() if camera != PROJECTOR}
    seen = {camera: one for camera, one in results.items() if isinstance(one, Sighting)}
    refused = {camera: refusal(one) for camera, one in results.items() if isinstance(one, CalibrationError)}
    if other.lit is None:
        return Detection(images, seen, refused | {name: why for name, why in other.refused.items() if name == PROJECTOR})
    camera, lit = other.lit.camera, other.lit.read_verified()
    reading = projector_sighting(seen[camera].of(camera, other.id), lit) if camera in seen else None
    if isinstance(reading, Sighting):
        seen[PROJECTOR] = reading
    return Detection(images, seen, refused, (camera, lit))


def _projector_refusal(found: BoardInFringes) -> Refusal:
    reasons = [reading.reason for reading in found.readings.values() if not isinstance(reading, Sighting)]
    if not reasons:
        return Refusal("not found", "No camera found the board.", "Show it whole, sharp and evenly lit.")
    return Refusal("too dark", f"{reasons[0][0].upper()}{reasons[0][1:]}.", UNLIT)


def _try_find(find: Callable[[], Sighting]) -> Sighting | CalibrationError:
    try:
        return find()
    except CalibrationError as error:
        return error


def refusal(error: CalibrationError) -> Refusal:
    """Convert an error to the reason why an image has no marks."""
    return Refusal(error.cause if isinstance(error, BoardDetectionError) else "not found", error.message, error.hint)
