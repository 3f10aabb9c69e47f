"""Images of boards by the virtual rig's optics, with the truth of every mark; the camera is the paper's, 550 mm away."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, lru_cache

import numpy as np

from measureapp.arrays import FloatArray, ImageArray, read_only
from measureapp.data.board import BoardDescription, CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.simulate.optics import ProjectorLight, SeeingCamera, expose
from measureapp.simulate.options import LightSettings
from measureapp.simulate.printed_board import PrintedBoard
from measureapp.simulate.sensor import SensorSettings, read_out

CHECKER = CheckerboardDescription(columns=14, rows=11, square_mm=15.0)
CHARUCO = CharucoDescription(kind="charuco", columns=14, rows=11, square_mm=15.0, marker_mm=11.0)
CIRCLES = CirclesDescription(kind="circles", columns=7, rows=15, spacing_mm=12.0, diameter_mm=11.0)
BOARDS = {"checkerboard": CHECKER, "charuco": CHARUCO, "circles": CIRCLES}
FULL, HALF, QUARTER = (2592, 1944, 4090.0), (1296, 972, 2045.0), (648, 486, 1022.5)
LENS = (-0.1, 0.05, 3e-4, -2e-4, 0.0)
EXPOSURE_US = 100_000


@dataclass(frozen=True, eq=False)
class Shot:
    """An image and where the marks truly are in it."""

    image: ImageArray
    marks_px: FloatArray
    camera: PinholeCamera
    camera_from_board: RigidTransform


@cache
def shot(
    board: BoardDescription,
    tilt_deg: float = 30.0,
    towards_deg: float = 100.0,
    roll_deg: float = 40.0,
    size: tuple[int, int, float] = HALF,
    exposure_us: int = EXPOSURE_US,
    aside_mm: tuple[float, float] = (0.0, 0.0),
    noise: bool = True,
    lens: tuple[float, ...] = LENS,
) -> Shot:
    """Photograph a board tilted about an axis in the image plane, turned about its normal and moved aside."""
    width, height, focal = size
    camera = PinholeCamera(
        width, height, np.array([[focal, 0, width / 2 + 7], [0, focal * 1.001, height / 2 - 5], [0, 0, 1]]), np.array(lens)
    )
    tilt, towards, roll = np.deg2rad([tilt_deg, towards_deg, roll_deg])
    turn = rotation_about([np.cos(towards), np.sin(towards), 0], tilt) @ rotation_about([0, 0, 1], roll)
    centre = np.array([*aside_mm, 550.0])
    pose = RigidTransform.from_parts(turn, centre - turn @ board.middle_mm, "camera", "board")
    key = int(1000 * tilt_deg + 10 * towards_deg + roll_deg)
    image = photographed(board, camera, pose, key, exposure_us=exposure_us, noise=noise)
    return Shot(image, camera.project(pose.apply(board.corners_mm)), camera, pose)


def photographed(
    board: BoardDescription,
    camera: PinholeCamera,
    camera_from_board: RigidTransform,
    key: int,
    *,
    exposure_us: int = EXPOSURE_US,
    noise: bool = True,
) -> ImageArray:
    """Photograph a board where it stands; ``key`` draws the noise."""
    place = (camera_from_board.matrix.tobytes(), camera.matrix.tobytes(), tuple(camera.distortion.tolist()))
    light = _light(board, camera.width_px, camera.height_px, place)
    return read_only(read_out(expose(light, None, exposure_us, LightSettings()), 8, SensorSettings(noise=noise), key))


@lru_cache(maxsize=4)  # a few exposures follow each other in a test; a map takes 20 MB
def _light(board: BoardDescription, width_px: int, height_px: int, place: tuple[bytes, bytes, tuple[float, ...]]) -> FloatArray:
    """Return the light on the board, which takes nine tenths of a photograph, by what determines it: pose, camera matrix, distortion."""
    pose, matrix = (np.frombuffer(one).reshape(size, size) for one, size in zip(place, (4, 3), strict=False))
    camera = PinholeCamera(width_px, height_px, matrix, np.array(place[2]))
    lamp = RigidTransform.from_parts(np.eye(3), np.array([-60.0, 0, 0]), "camera", "projector")
    board_from_camera = RigidTransform(pose, "camera", "board").inverse()
    light = np.empty((height_px, width_px, 4), np.float32)
    PrintedBoard(board, 0.0).illuminate(
        SeeingCamera(camera), board_from_camera, ProjectorLight(camera, board_from_camera @ lamp, 550.0), light
    )
    return light


def middle_of(image: ImageArray, marks_px: FloatArray) -> ImageArray:
    """Hide all but the middle of a board: no margin and no end of it can be seen."""
    part = np.full_like(image, 70)
    x, y = marks_px.mean(axis=0).astype(int)
    part[y - 180 : y + 180, x - 220 : x + 220] = image[y - 180 : y + 180, x - 220 : x + 220]
    return read_only(part)
