"""The paper's three cameras at full resolution before a board, and what triangulation makes of them."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.pose import triangulate
from measureapp.calibrate.cameras.array import CameraArrayProblem
from measureapp.calibrate.cameras.uncertainty import WorkingVolume
from measureapp.calibrate.sightings import Sighting
from measureapp.data.board import CheckerboardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about

SIZE = (2592, 1944)
FOCAL = 4085.0
BOARD = CheckerboardDescription(columns=14, rows=11, square_mm=15.0)
LEAST_CORNERS = 40  # corners; a view that shows fewer is not taken
MIDDLE, BORDERS = (90.0, 70.0), (150.0, 120.0)  # how far the board's middle goes aside, mm
VOLUME = WorkingVolume(standoff_mm=550.0, field_mm=(350.0, 280.0), depth_mm=100.0)


def drawn_head(generator: np.random.Generator) -> CameraArrayCalibration:
    """Draw three cameras around the nominal head: lenses, places and directions a little off."""
    half = np.deg2rad(17.6)
    to_middle = rotation_about([0, 1, 0], -half)
    nominal = {
        "left": (np.eye(3), np.zeros(3)),
        "right": (rotation_about([0, 1, 0], -2 * half), np.array([350 * np.cos(half), 0, 350 * np.sin(half)])),
        "upper": (to_middle @ rotation_about([1, 0, 0], -np.deg2rad(20)), to_middle @ [175.0, -200.0, 0.0]),
    }
    cameras = {}
    for name, (turn, place) in nominal.items():
        focal = FOCAL * (1 + 0.005 * generator.normal())
        centre = (np.array(SIZE) - 1) / 2 + 0.01 * SIZE[0] * generator.normal(size=2)
        matrix = np.array([[focal, 0, centre[0]], [0, focal * (1 + 2e-4 * generator.normal()), centre[1]], [0, 0, 1]])
        lens = np.array([-0.10, 0.05, 0, 0, 0]) + np.array([0.015, 0.02, 4e-4, 4e-4, 0]) * generator.normal(size=5)
        off = name != "left"
        turned = rotation_about(generator.normal(size=3), off * 0.01 * generator.normal()) @ turn
        pose = RigidTransform.from_parts(turned, place + off * generator.normal(size=3), "camera", name)
        cameras[name] = CameraCalibration(name, PinholeCamera(*SIZE, matrix, lens), pose)
    return CameraArrayCalibration("left", cameras)


def board_pose(generator: np.random.Generator, reach_mm: tuple[float, float] = MIDDLE) -> RigidTransform:
    """Draw a place of the board in the field of the head, about 550 mm away, tilted by 15° to 45°."""
    middle = rotation_about([0, 1, 0], -np.deg2rad(17.6))
    azimuth = generator.uniform(0, 2 * np.pi)
    turn = middle @ rotation_about([np.cos(azimuth), np.sin(azimuth), 0], np.deg2rad(generator.uniform(15, 45)))
    turn = turn @ rotation_about([0, 0, 1], generator.uniform(-0.8, 0.8))
    x, y = (generator.uniform(-reach, reach) for reach in reach_mm)
    aside = np.array([x, y, generator.uniform(490, 610)])
    centre = middle @ (np.array([175.0, -60.0, 0.0]) + aside)
    return RigidTransform.from_parts(turn, centre - turn @ BOARD.middle_mm, "camera", "board")


def seen(
    head: CameraArrayCalibration,
    pose: RigidTransform,
    sigma_px: float,
    generator: np.random.Generator,
    view: str,
    board: CheckerboardDescription = BOARD,
) -> list[Sighting]:
    """Return what the cameras see of the board, with noise; corners outside of an image are not seen."""
    result = []
    points = pose.apply(board.corners_mm)
    for name, camera in head.cameras.items():
        pixels = camera.pinhole.project(camera.reference_from_camera.inverse().apply(points))
        pixels = pixels + generator.normal(scale=sigma_px, size=pixels.shape)
        ids = np.flatnonzero(np.all((pixels > 8) & (pixels < np.array(SIZE) - 8), axis=1))
        if len(ids) >= LEAST_CORNERS:
            result.append(Sighting(name, view, pixels[ids], ids))
    return result


def problem(
    head: CameraArrayCalibration,
    views: int,
    sigma_px: float,
    generator: np.random.Generator,
    reach_mm: tuple[float, float] = MIDDLE,
) -> CameraArrayProblem:
    """Return a calibration from ``views`` board positions."""
    sightings = [one for view in range(views) for one in seen(head, board_pose(generator, reach_mm), sigma_px, generator, f"{view:02d}")]
    return CameraArrayProblem(BOARD, "left", dict.fromkeys(head.cameras, SIZE), tuple(sightings))


def shape_error_mm(found: CameraArrayCalibration, head: CameraArrayCalibration, points: FloatArray) -> FloatArray:
    """Return what is left (N, 3) of triangulated points against the truth after the best rigid fit; the images are free of noise."""
    pixels = {name: camera.pinhole.project(camera.reference_from_camera.inverse().apply(points)) for name, camera in head.cameras.items()}
    measured = triangulate(pixels, found)
    a, b = measured - measured.mean(axis=0), points - points.mean(axis=0)
    u, _, vt = np.linalg.svd(a.T @ b)
    return a @ (u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt) - b
