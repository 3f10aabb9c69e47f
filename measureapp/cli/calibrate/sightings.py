"""Board poses from images or from a table, as the calibrations of the axes need them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.calibrate.boards.agreement import agreeing
from measureapp.calibrate.boards.find import find_board, require_unambiguous
from measureapp.calibrate.boards.pose import BoardPose, board_pose, stated_pose
from measureapp.calibrate.boards.together import find_beside
from measureapp.calibrate.boards.turned import TurnedBoard, find_turned
from measureapp.calibrate.cameras.prior import pose_by_cameras
from measureapp.calibrate.motions.moved_boards import STAND_IN_MM
from measureapp.calibrate.sightings import AmbiguousPart, FoundBoard, naming_refused
from measureapp.cli.calibrate.options import BoardSource
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, LabelledCovariance
from measureapp.errors import CalibrationError, InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Progress
from measureapp.project.calibration.board_images import BoardImages, find_board_images
from measureapp.project.calibration.camera_file import read_cameras
from measureapp.project.tables import read_poses, require_millimetres


@dataclass(frozen=True, slots=True, eq=False)
class CameraUncertainty:
    """How board poses move with the cameras, and what the cameras' calibration leaves uncertain; both None where that is not known."""

    by_cameras: FloatArray | None = None  # (N, 6, C)
    prior: LabelledCovariance | None = None


@dataclass(frozen=True, slots=True, eq=False)
class PosesFromImages:
    """Board poses by position; a position without a board is missing."""

    board: BoardDescription
    cameras: CameraArrayCalibration
    positions: int
    poses: dict[int, BoardPose]
    rejected: list[dict[str, Any]]
    lost: list[dict[str, Any]]  # those rejected of positions in which no camera saw the board
    by_cameras: dict[int, FloatArray]  # (6, C), change of each pose with the cameras; empty where cameras.json holds no covariance

    def uncertainty(self, positions: Iterable[int]) -> CameraUncertainty:
        """Return what the cameras leave uncertain in the poses of ``positions``, in this order."""
        if not self.by_cameras:
            return CameraUncertainty()
        return CameraUncertainty(np.array([self.by_cameras[position] for position in positions]), self.cameras.covariance)


@dataclass(frozen=True, slots=True, eq=False)
class NamedBoardPoses:
    """The board pose of every robot pose."""

    poses: dict[str, BoardPose]
    rejected: list[dict[str, Any]]
    cameras: CameraUncertainty  # in the order of ``poses``
    lost: list[dict[str, Any]]  # those rejected of poses from which no camera saw the board
    marks_mm: FloatArray  # (M, 3) of the board, or of one that stands in for it


def poses_from_images(source: BoardSource, purpose: str, progress: Progress, table_rad: Sequence[float] | None = None) -> PosesFromImages:
    """Find the board in all images and its pose at every position; the noise of the corners is that of all residuals.

    Parameters
    ----------
    table_rad : angle of the table at every position before cameras that stand still, where it is known: tells parts of the board that
        no camera can tell by itself

    Raises
    ------
    InputError
        Images, cameras or board are missing or do not fit each other.
    CalibrationError
        The board is symmetric.
    """
    if source.cameras is None:
        raise InputError("--images need --cameras.", "Calibrate the cameras first: `measureapp calibrate cameras`.")
    description = source.board.description()
    require_unambiguous(description, purpose)
    array = read_cameras(source.cameras)
    files = find_board_images(source.images or ())
    unknown = [name for name in files.cameras if name not in array.cameras]
    if unknown:
        raise InputError(f"{source.cameras} has no camera {unknown[0]!r}.", "It has: " + ", ".join(array.cameras) + ".")
    if table_rad is not None and len(table_rad) != files.positions:
        raise InputError(f"There are {len(table_rad)} table angles for {files.positions} positions.", "Give one angle per position.")
    found, rejected = _corners(files, array, description, table_rad, progress)
    places = agreeing({position: _pose(seen, array, description) for position, seen in sorted(found.items())})
    for position, reason in places.rejected.items():
        cameras = tuple(found[position])
        image = files.path(cameras[0], position)
        rejected.append({"camera": ", ".join(cameras), "position": position, "image": image, "reason": f"{reason}; take them again"})
    poses, prior = dict(places.poses), array.covariance
    lost = [one for one in rejected if one["position"] not in poses]
    by_cameras = {} if prior is None else {at: _by_cameras(pose, found[at], array, description, prior) for at, pose in poses.items()}
    return PosesFromImages(description, array, files.positions, poses, rejected, lost, by_cameras)


def _corners(
    files: BoardImages,
    array: CameraArrayCalibration,
    board: BoardDescription,
    table_rad: Sequence[float] | None,
    progress: Progress,
) -> tuple[dict[int, dict[str, FoundBoard]], list[dict[str, Any]]]:
    found: dict[int, dict[str, FoundBoard]] = {position: {} for position in range(files.positions)}
    rejected: list[dict[str, Any]] = []
    unclear: list[tuple[str, int, ImageArray]] = []
    total = len(files.cameras) * files.positions
    for done, (camera, position, image) in enumerate(files.each()):
        path = files.path(camera, position)
        progress.report(done, total, path.name)
        lens = array.cameras[camera].pinhole
        if image.shape[:2] != (lens.height_px, lens.width_px):
            raise InputError(
                f"{path} is {image.shape[1]} × {image.shape[0]} px, camera {camera!r} was calibrated for {lens.width_px} × {lens.height_px} px.",
                "Use the calibration of the camera that took the images.",
            )
        try:
            found[position][camera] = find_board(image, board)
        except AmbiguousPart:
            unclear.append((camera, position, image))
        except CalibrationError as error:
            rejected.append({"camera": camera, "position": position, "image": path, "reason": f"{error.message} {error.hint}"})
    for camera, position, image in sorted(unclear, key=lambda one: not found[one[1]]):  # first those that other cameras tell
        try:
            found[position] = {**found[position], camera: _told(image, camera, position, found, array, board, table_rad)}
        except CalibrationError as error:
            rejected.append(
                {"camera": camera, "position": position, "image": files.path(camera, position), "reason": f"{error.message} {error.hint}"}
            )
    progress.report(total, total)
    return {position: corners for position, corners in found.items() if corners}, rejected


def _told(
    image: ImageArray,
    camera: str,
    position: int,
    found: Mapping[int, dict[str, FoundBoard]],
    array: CameraArrayCalibration,
    board: BoardDescription,
    table_rad: Sequence[float] | None,
) -> FoundBoard:
    """The part of the board that an image shows, as other cameras tell it or the angles of the table. Raises CalibrationError."""
    if found[position]:
        return find_beside(image, camera, found[position], array, board)
    if table_rad is None:
        return find_board(image, board)
    seen = [TurnedBoard(_pose(one, array, board), table_rad[other]) for other, one in found.items() if one]
    return find_turned(image, camera, seen, table_rad[position], array, board)


def _pose(seen: dict[str, FoundBoard], array: CameraArrayCalibration, board: BoardDescription) -> BoardPose:
    corners = {camera: found.corners_px for camera, found in seen.items()}
    return board_pose(corners, array, board, ids={camera: found.ids for camera, found in seen.items()})


def _by_cameras(
    pose: BoardPose, seen: dict[str, FoundBoard], array: CameraArrayCalibration, board: BoardDescription, prior: LabelledCovariance
) -> FloatArray:
    return pose_by_cameras(pose, {camera: found.ids for camera, found in seen.items()}, array, board, prior.parameters)


def named_board_poses(
    names: Sequence[str],
    board_poses: Path | None,
    source: BoardSource,
    noise: tuple[float, float],
    progress: Progress,
) -> NamedBoardPoses:
    """Return the board pose of every robot pose, from a table or from images in the order of the sorted names.

    ``noise`` is the standard deviation (mm, degrees) of poses from a table.

    Raises
    ------
    InputError
        Neither or both sources were given, or names or counts do not fit.
    """
    if (board_poses is None) == (not source.images):
        raise InputError("Give either --board-poses or --images.", "With --images also --cameras, --board and --square-mm.")
    if board_poses is not None:
        table = read_poses(board_poses, "camera", "board")
        require_millimetres(board_poses, table)
        same_names(board_poses, names, tuple(table))
        return NamedBoardPoses(
            {name: stated_pose(table[name], math.radians(noise[1]), noise[0]) for name in names}, [], CameraUncertainty(), [], STAND_IN_MM
        )
    seen = poses_from_images(source, "this calibration", progress)
    if seen.positions != len(names):
        raise InputError(f"{seen.positions} images do not belong to {len(names)} robot poses.", "Give one image per camera and robot pose.")
    poses = {names[position]: pose for position, pose in seen.poses.items()}
    return NamedBoardPoses(poses, seen.rejected, seen.uncertainty(seen.poses), seen.lost, seen.board.corners_mm)


@contextmanager
def telling_refused(seen: PosesFromImages | NamedBoardPoses | None) -> Iterator[None]:
    """Let a calibration that fails name the images of positions that give nothing. Raises CalibrationError."""
    try:
        yield
    except CalibrationError as error:
        lost = [] if seen is None else seen.lost
        raise naming_refused(error, [(str(one["image"]), one["reason"]) for one in lost]) from error


def read_robot_poses(path: Path) -> dict[str, RigidTransform]:
    """Read base_from_flange by name, in mm. Raises InputError."""
    poses = read_poses(path, "base", "flange")
    require_millimetres(path, poses)
    return poses


def same_names(path: Path, wanted: Sequence[str], given: Sequence[str]) -> None:
    """Refuse a table whose names differ from those of the robot poses. Raises InputError naming the first."""
    for name in (*(name for name in wanted if name not in given), *(name for name in given if name not in wanted)):
        where = "is missing in" if name in wanted else "of"
        other = "" if name in wanted else " is not among the robot poses"
        raise InputError(f"The name {name!r} {where} {path}{other}.", "Use the same names in all tables.")
