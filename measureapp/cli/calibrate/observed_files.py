"""Observations of the board from image files and tables of read-backs, as the commands that calibrate axes need them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from measureapp.calibrate.boards.find import require_unambiguous
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import stated_pose
from measureapp.calibrate.draft.draft import Draft, Setup, Solved
from measureapp.calibrate.draft.locate import Located, locate
from measureapp.calibrate.sightings import explain_by_refused
from measureapp.calibration_session.observing import Observed, Position, observe
from measureapp.cli.calibrate.options import BoardSource
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import Readback
from measureapp.errors import CalibrationError, InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Progress
from measureapp.project.calibration.board_images import BoardImages, find_board_images
from measureapp.project.calibration.camera_file import read_cameras
from measureapp.project.tables import read_poses, require_millimetres


@dataclass(frozen=True, slots=True, eq=False)
class ObservedFiles:
    """Observations from images of the board by calibrated cameras."""

    board: BoardDescription
    cameras: CameraArrayCalibration
    files: BoardImages
    observed: Observed

    @property
    def camera_names(self) -> tuple[str, ...]:
        """The cameras with images, the reference first where it has some."""
        return tuple(sorted(self.files.cameras, key=lambda name: name != self.cameras.reference))

    def draft(self, setup: Setup) -> Draft:
        """Return the draft to be solved."""
        return self.observed.draft(setup, {})  # the cameras are known, and so are their sizes

    def located(self) -> Located:
        """Return the observations with the pose of the board. Raises CalibrationError where most images contradict the cameras."""
        return locate(self.observed.usable, self.cameras, self.board)

    def rejected(self, contradicting: Mapping[str, str]) -> list[dict[str, Any]]:
        """Return the images that gave no marks, and those of observations in which the cameras contradict each other (id -> reason)."""
        numbers = {one.id: number for number, one in enumerate(self.observed.observations)}
        rows = [(one.camera, numbers[one.id], one.camera, one.reason) for one in self.observed.refused]
        for one in self.observed.usable:
            if one.id in contradicting:
                rows.append((", ".join(one.seen), numbers[one.id], next(iter(one.seen)), f"{contradicting[one.id]}; take them again"))
        return [
            {"camera": cameras, "position": number, "image": self.files.path(camera, number), "reason": reason}
            for cameras, number, camera, reason in rows
        ]

    def outcome(self, solved: Solved) -> tuple[list[dict[str, Any]], dict[str, str]]:
        """Return the rejected images of a solution, and observation -> reason of those in which the board had moved."""
        contradicting = {name: reason for name, reason in solved.rejected.items() if name not in solved.places}
        return self.rejected(contradicting), {name: reason for name, reason in solved.rejected.items() if name in solved.places}

    @contextmanager
    def explain_failure(self) -> Iterator[None]:
        """Let a calibration that fails name the images that gave nothing. Raises CalibrationError."""
        try:
            yield
        except CalibrationError as error:
            without = {one.id for one in self.observed.observations if not one.seen}
            numbers = {one.id: number for number, one in enumerate(self.observed.observations)}
            lost = [(str(self.files.path(one.camera, numbers[one.id])), one.reason) for one in self.observed.refused if one.id in without]
            raise explain_by_refused(error, lost) from error


def observe_files(source: BoardSource, subject: str, progress: Progress, readbacks: Mapping[str, Readback] | None = None) -> ObservedFiles:
    """Detect the board in all images of the options.

    Parameters
    ----------
    readbacks : name of each position -> axis positions, in the order of the images; None: positions are numbered from 0

    Raises
    ------
    InputError
        Images, cameras or board are missing or do not fit each other.
    CalibrationError
        The board is symmetric.
    """
    if source.cameras is None:
        raise InputError("--images need --cameras.", "Calibrate the cameras first: `measureapp calibrate cameras`.")
    board = source.board.description()
    require_unambiguous(board, subject)
    cameras, files = read_cameras(source.cameras), find_board_images(source.images or ())
    unknown = [name for name in files.cameras if name not in cameras.cameras]
    if unknown:
        raise InputError(f"{source.cameras} has no camera {unknown[0]!r}.", "It has: " + ", ".join(cameras.cameras) + ".")
    if readbacks is None:
        readbacks = {str(number): Readback() for number in range(files.positions)}
    if len(readbacks) != files.positions:
        raise InputError(
            f"{files.positions} images per camera do not belong to {len(readbacks)} read-backs.",
            "Give one line per position in every table.",
        )
    lenses = {name: cameras.cameras[name].pinhole for name in files.cameras}
    sizes = {name: (lens.width_px, lens.height_px) for name, lens in lenses.items()}
    positions = [
        Position(name, lambda number=number: files.read(number, sizes, calibrated=True), readback)  # type: ignore[misc]
        for number, (name, readback) in enumerate(readbacks.items())
    ]
    return ObservedFiles(board, cameras, files, observe(positions, board, cameras, progress))


def observed_at_robot_poses(
    robot: Mapping[str, Readback], board_poses: Path | None, source: BoardSource, progress: Progress
) -> ObservedFiles | None:
    """Detect the board in the images of the options, one per robot pose; None where a table has the board poses instead.

    Raises
    ------
    InputError
        Neither or both sources were given, or names or counts do not fit.
    """
    if (board_poses is None) == (not source.images):
        raise InputError("Give either --board-poses or --images.", "With --images also --cameras, --board and --square-mm.")
    return observe_files(source, "this calibration", progress, robot) if board_poses is None else None


def read_board_poses(path: Path, robot: Mapping[str, Readback], sigma_mm: float, sigma_deg: float) -> Located:
    """Read the board pose of every robot pose from a table, with the stated standard deviation. Raises InputError."""
    table = read_poses(path, "camera", "board")
    require_millimetres(path, table)
    require_same_names(path, tuple(robot), tuple(table))
    observations = (
        Observation(name, readback, stated_pose(table[name], math.radians(sigma_deg), sigma_mm)) for name, readback in robot.items()
    )
    return Located(tuple(observations), {}, None)


def read_robot_poses(path: Path) -> dict[str, RigidTransform]:
    """Read base_from_flange by name, in mm. Raises InputError."""
    poses = read_poses(path, "base", "flange")
    require_millimetres(path, poses)
    return poses


def require_same_names(path: Path, wanted: Sequence[str], given: Sequence[str]) -> None:
    """Refuse a table whose names differ from those of the robot poses. Raises InputError naming the first."""
    for name in (*(name for name in wanted if name not in given), *(name for name in given if name not in wanted)):
        where = "is missing in" if name in wanted else "of"
        other = "" if name in wanted else " is not among the robot poses"
        raise InputError(f"The name {name!r} {where} {path}{other}.", "Use the same names in all tables.")
