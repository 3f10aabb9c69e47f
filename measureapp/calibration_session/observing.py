"""Observations from images of the board, without a session: what commands and the automatic run solve at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace

from measureapp.arrays import ImageArray
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.draft.draft import Draft, Setup, Solved
from measureapp.calibrate.draft.solve import solve, solve_cameras_alone
from measureapp.calibrate.rig.joint import number_approaches
from measureapp.calibrate.sightings import Sighting, explain_by_refused
from measureapp.calibration_session.detection import DETECTION_THREADS, Detection, DetectionContext, detect, identify_parts
from measureapp.calibration_session.observation import Refusal
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import Readback
from measureapp.errors import CalibrationError
from measureapp.progress import PartOf, Progress


@dataclass(frozen=True, slots=True, eq=False)
class Position:
    """Images of one position of the board; they are read when it is searched for the board."""

    id: str
    read: Callable[[], Mapping[str, ImageArray]]  # camera -> (H, W)
    readback: Readback = field(default_factory=Readback)


@dataclass(frozen=True, slots=True, eq=False)
class RefusedImage:
    """An image without usable marks."""

    id: str
    camera: str
    refusal: Refusal

    @property
    def reason(self) -> str:
        """Message and remedy."""
        return f"{self.refusal.message} {self.refusal.hint}"


@dataclass(frozen=True, slots=True, eq=False)
class Observed:
    """The sightings and refused images of all positions."""

    observations: tuple[Observation, ...]  # all positions, also those without any marks
    refused: tuple[RefusedImage, ...]
    unclear: Mapping[tuple[str, str], ImageArray]  # (position, camera) -> image of an ambiguous part of the board

    @property
    def usable(self) -> tuple[Observation, ...]:
        """The positions at which a camera detected the board."""
        return tuple(one for one in self.observations if one.seen)

    def draft(self, setup: Setup, sizes_px: Mapping[str, tuple[int, int]]) -> Draft:
        """Return the draft to be solved."""
        return Draft(setup, self.usable, sizes_px)

    def explain_failure(self, error: CalibrationError) -> CalibrationError:
        """Add an image without marks to the error of a solution that failed: often its cause."""
        without = {one.id for one in self.observations if not one.seen}
        return explain_by_refused(error, [(f"{one.id} ({one.camera})", one.reason) for one in self.refused if one.id in without])


def observe(
    positions: Sequence[Position],
    board: BoardDescription,
    cameras: CameraArrayCalibration | None,
    progress: Progress,
    threads: int = DETECTION_THREADS,
) -> Observed:
    """Detect the board in the images of all positions, ``threads`` of them at a time; known cameras identify ambiguous parts of it.

    Raises
    ------
    InputError
        An image cannot be read.
    """
    found: dict[str, Detection] = {}
    with ThreadPoolExecutor(threads) as pool:
        pending = [pool.submit(_detect, position, board) for position in positions]
        try:
            for number, (position, future) in enumerate(zip(positions, pending, strict=True)):
                progress.report(number, len(positions), f"detecting the board in {position.id}")
                found[position.id] = future.result()
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    poses = [position.readback.base_from_flange for position in positions]
    numbers = number_approaches([pose for pose in poses if pose is not None]) if None not in poses else (None,) * len(poses)
    observations = tuple(
        Observation(position.id, position.readback, approach=number, seen=found[position.id].seen)
        for position, number in zip(positions, numbers, strict=True)
    )
    refused = tuple(RefusedImage(id_, camera, why) for id_, one in found.items() for camera, why in one.refused.items())
    unclear = {(one.id, one.camera): found[one.id].images[one.camera] for one in refused if one.refusal.cause == "part"}
    progress.report(1, 1)
    return identify_ambiguous(Observed(observations, refused, unclear), board, cameras)


def identify_ambiguous(observed: Observed, board: BoardDescription, cameras: CameraArrayCalibration | None) -> Observed:
    """Identify ambiguous parts of the board with calibrated cameras; the same object where nothing is gained."""
    gained: dict[str, dict[str, Sighting]] = {}
    for one in observed.observations:
        images = {camera: image for (id_, camera), image in observed.unclear.items() if id_ == one.id}
        context = DetectionContext(cameras, tuple(other for other in observed.usable if other is not one))
        results = identify_parts(images, one.seen, one.readback, board, context)
        marks = {camera: found for camera, found in results.items() if isinstance(found, Sighting)}
        if marks:
            gained[one.id] = marks
    if not gained:
        return observed
    return Observed(
        tuple(replace(one, seen={**one.seen, **gained.get(one.id, {})}) for one in observed.observations),
        tuple(one for one in observed.refused if one.camera not in gained.get(one.id, {})),
        {key: image for key, image in observed.unclear.items() if key[1] not in gained.get(key[0], {})},
    )


def solve_observed(
    observed: Observed, setup: Setup, sizes_px: Mapping[str, tuple[int, int]], progress: Progress
) -> tuple[Observed, Solved]:
    """Solve with all parts of the board that the cameras, which this calibrates, identify. Raises CalibrationError."""
    draft = observed.draft(setup, sizes_px)
    try:
        if setup.cameras is not None or not observed.unclear:
            return observed, solve(draft, progress)
        first, second = PartOf(progress, 0.0, 0.5), PartOf(progress, 0.5, 1.0)
        alone = solve_cameras_alone(draft, first)
        if alone is not None:
            observed = identify_ambiguous(observed, setup.board, alone)
            return observed, solve(observed.draft(setup, sizes_px), second)
        solved = solve(draft, first)
        further = identify_ambiguous(observed, setup.board, solved.cameras)
        return further, solved if further is observed else solve(further.draft(setup, sizes_px), second)
    except CalibrationError as error:
        raise observed.explain_failure(error) from error


def _detect(position: Position, board: BoardDescription) -> Detection:
    detected = detect(position.read(), position.readback, board, DetectionContext(None))
    unclear = {camera for camera, refusal in detected.refused.items() if refusal.cause == "part"}
    return replace(detected, images={camera: image for camera, image in detected.images.items() if camera in unclear})
