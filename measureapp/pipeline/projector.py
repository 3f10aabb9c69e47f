"""From fringe images of the board at several positions to the calibrated projector."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from measureapp.calibrate.boards.find import require_unambiguous
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.cameras.array import CameraArrayProblem
from measureapp.calibrate.cameras.projector import HeadSolution, solve_head
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.kinds.projector import head_problem
from measureapp.calibrate.sightings import Rejection, Sighting
from measureapp.calibration_session.board_in_fringes import detect_under_fringes, projector_size_px, require_both_directions
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import FringeStack
from measureapp.errors import CalibrationError, InputError
from measureapp.fringe.settings import DecodeSettings
from measureapp.progress import PartOf, Progress

LEAST_POSITIONS = 3
NOT_KNOWN = (0, 0)


@dataclass(frozen=True, slots=True)
class ProjectorRequest:
    """A calibration of the projector with known cameras, or of projector and cameras together."""

    board: BoardDescription
    cameras: CameraArrayCalibration | None  # None: the cameras are calibrated from the same images
    projector_px: tuple[int, int] | None = None  # width and height; None: from the stacks
    distortion_count: int = 5
    decoding: DecodeSettings = field(default_factory=DecodeSettings)


def calibrate_projector(stacks: Iterable[FringeStack], positions: int, request: ProjectorRequest, progress: Progress) -> HeadSolution:
    """Find the board in the mean image of each stack, read the projector's pixels at its marks, and solve.

    Parameters
    ----------
    stacks : one per board position, with vertical and horizontal fringes; taken one after the other, none is kept
    positions : how many there are

    Raises
    ------
    CalibrationError
        Fewer than three positions, fringes in one direction only, a symmetric board, or sightings that do not determine the projector.
    InputError
        The stacks have other cameras or another size than the calibrated ones, or differ in the projector's size.
    """
    require_unambiguous(request.board, "the calibration of the projector")
    if positions < LEAST_POSITIONS:
        raise CalibrationError(
            f"{positions} positions of the board do not determine the projector.",
            f"Record vertical and horizontal fringes on the board at {LEAST_POSITIONS} positions at least, better 12, tilted differently.",
        )
    observations: list[Observation] = []
    missed: list[Rejection] = []
    sizes: dict[str, tuple[int, int]] = {}
    size_px = request.projector_px or NOT_KNOWN
    for number, stack in enumerate(stacks):
        view, part = f"{number + 1:02d}", PartOf(progress, 0.9 * number / positions, 0.9 * (number + 1) / positions)
        size_px = _size_of(stack, size_px, given=request.projector_px is not None)
        _require_same_cameras(stack, sizes, request.cameras)
        found = detect_under_fringes(stack, view, request.board, request.decoding, part)
        observations.append(Observation(view, seen=found.all_sightings))
        missed += [Rejection(camera, view, f"{error.message} {error.hint}".rstrip(".")) for camera, error in found.refused.items()]
        missed += [] if found.best is not None else [one for one in found.readings.values() if isinstance(one, Rejection)][:1]
    _require_different([marks.of(camera, one.id) for one in observations for camera, marks in one.seen.items()])
    names = request.cameras.names if request.cameras is not None else tuple(sizes)
    empty = CameraArrayProblem(request.board, names[0], sizes, (), distortion_count=request.distortion_count)
    problem = head_problem(empty, observations, request.cameras, tuple(missed))
    read = [one.seen[PROJECTOR].of(PROJECTOR, one.id) for one in observations if PROJECTOR in one.seen]
    return solve_head(problem, read, size_px, PartOf(progress, 0.9, 1.0))


def _require_different(sightings: list[Sighting]) -> None:
    """Refuse a position that was given twice: it would count twice."""
    first: dict[tuple[str, bytes], str] = {}
    for one in sightings:
        same = first.setdefault((one.camera, one.corners_px.tobytes()), one.view)
        if same != one.view:
            raise CalibrationError(
                f"Views {same} and {one.view} of camera {one.camera!r} are the same image: it would count twice.",
                "Give every position of the board once.",
            )


def _size_of(stack: FringeStack, before: tuple[int, int], *, given: bool) -> tuple[int, int]:
    require_both_directions(stack)
    if given:
        return before
    size = projector_size_px(stack)
    if before not in (NOT_KNOWN, size):
        raise InputError(
            f"The fringes of {stack.viewpoint_id} run over {size[0]} × {size[1]} px of the projector, those before over "
            f"{before[0]} × {before[1]} px.",
            "Give stacks of one projector, or its size by --projector-px.",
        )
    return size


def _require_same_cameras(stack: FringeStack, sizes: dict[str, tuple[int, int]], known: CameraArrayCalibration | None) -> None:
    for camera, images in stack.images.items():
        if known is not None and camera not in known.cameras:
            raise InputError(
                f"{stack.viewpoint_id} has images of camera {camera!r}, which is not calibrated.",
                "The calibration has: " + ", ".join(known.names) + ".",
            )
        size = (images.shape[3], images.shape[2])
        lens = None if known is None else known.cameras[camera].pinhole
        expected = sizes.setdefault(camera, size) if lens is None else (lens.width_px, lens.height_px)
        if size != expected:
            raise InputError(
                f"The images of camera {camera!r} in {stack.viewpoint_id} are {size[0]} × {size[1]} px, not {expected[0]} × {expected[1]} px.",
                "Give images of one resolution, that of the calibrated camera.",
            )
