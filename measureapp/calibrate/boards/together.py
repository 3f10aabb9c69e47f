"""A part of the board in one camera's image, told by the other cameras that saw the same board at the same time."""

from __future__ import annotations

from collections.abc import Mapping

from measureapp.arrays import ImageArray
from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.pose import pose_of
from measureapp.calibrate.sightings import Sighting
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration


def find_beside(
    image: ImageArray, camera: str, seen: Mapping[str, Sighting], cameras: CameraArrayCalibration, board: BoardDescription
) -> Sighting:
    """Find the part of the board in the image of ``camera``, knowing what other calibrated cameras saw of it; as `find_board`.

    Parameters
    ----------
    seen : other cameras -> what they saw of the same position, at least one

    Raises
    ------
    CalibrationError
        As `find_board`; also where the others' pose of the board does not tell which part it is.
    """
    pose = pose_of(seen, cameras, board)
    own = cameras.cameras[camera]
    expected = own.pinhole.project(own.reference_from_camera.inverse().apply(pose.camera_from_board.apply(board.corners_mm)))
    return find_board(image, board, expected)
