"""Shortfalls of views of the board: too few, too little tilt, too little of the image."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.cameras.array import CameraArrayProblem
from measureapp.calibrate.cameras.camera import LEAST_VIEWS
from measureapp.calibrate.cameras.projector_sightings import device_title
from measureapp.calibrate.sightings import Sighting

ADVISED_VIEWS = 10
ADVISED_TILT_RAD = np.deg2rad(15.0)
ADVISED_COVERAGE = 0.6
CELLS = 5  # the image is divided into CELLS × CELLS for the coverage
ROUGH_FOCAL = 1.5  # focal length over image width, enough to estimate tilts


def shortfalls(problem: CameraArrayProblem) -> tuple[str, ...]:
    """Determine what is still missing, for every camera."""
    missing = []
    for camera in problem.sizes_px:
        name, count = device_title(camera), len(_sightings_of(problem, camera))
        if count < LEAST_VIEWS:
            missing.append(f"{name}: {LEAST_VIEWS - count} more views are needed.")
            continue
        if count < ADVISED_VIEWS:
            missing.append(f"{name}: {ADVISED_VIEWS - count} more views would make it reliable.")
        if tilt_rad(problem, camera) < ADVISED_TILT_RAD:
            missing.append(f"{name}: tilt the board by 20° to 45° in several directions.")
        covered = coverage(problem, camera)
        if covered < ADVISED_COVERAGE:
            missing.append(f"{name}: only {covered:.0%} of the image was covered; bring the board to its borders.")
    return tuple(missing)


def coverage(problem: CameraArrayProblem, camera: str) -> float:
    """Return the fraction of the image's 5 × 5 cells with corners."""
    pixels = [sighting.corners_px for sighting in _sightings_of(problem, camera)]
    if not pixels:
        return 0.0
    cells = np.floor(np.concatenate(pixels) / np.array(problem.sizes_px[camera]) * CELLS).clip(0, CELLS - 1).astype(int)
    return len(np.unique(cells, axis=0)) / CELLS**2


def tilt_rad(problem: CameraArrayProblem, camera: str) -> float:
    """Return the largest angle between the board's normals in two views, from a rough focal length."""
    normals = np.array([_normal(problem, sighting) for sighting in _sightings_of(problem, camera)]).reshape(-1, 3)
    return float(np.arccos(np.clip(normals @ normals.T, -1, 1)).max()) if len(normals) else 0.0


def _sightings_of(problem: CameraArrayProblem, camera: str) -> list[Sighting]:
    return [sighting for sighting in problem.sightings if sighting.camera == camera]


def _normal(problem: CameraArrayProblem, sighting: Sighting) -> FloatArray:
    width, height = problem.sizes_px[sighting.camera]
    focal = ROUGH_FOCAL * width
    matrix = np.array([[focal, 0, width / 2], [0, focal, height / 2], [0, 0, 1]])
    marks, corners = problem.board.flat_corners_mm[sighting.ids], np.array(sighting.corners_px)
    _, turn, _ = cv2.solvePnP(marks, corners, matrix, np.zeros(5), flags=cv2.SOLVEPNP_IPPE)
    return np.asarray(cv2.Rodrigues(turn)[0], np.float64)[:, 2]
