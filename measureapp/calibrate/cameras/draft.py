"""Collecting views of the board until they determine the cameras."""

from __future__ import annotations

from collections.abc import Mapping

import cv2
import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.cameras.array import CameraArrayProblem
from measureapp.calibrate.cameras.camera import LEAST_VIEWS
from measureapp.calibrate.cameras.projector_sightings import device_title
from measureapp.calibrate.sightings import Rejection, Sighting
from measureapp.data.board import BoardDescription

ADVISED_VIEWS = 10
ADVISED_TILT_RAD = np.deg2rad(15.0)
ADVISED_COVERAGE = 0.6
CELLS = 5  # the image is divided into CELLS × CELLS for the coverage
ROUGH_FOCAL = 1.5  # focal length over image width, enough to estimate tilts


class CameraArrayDraft:
    """The sightings collected so far, and the rejected images with their reasons."""

    def __init__(self, board: BoardDescription, reference: str, sizes_px: Mapping[str, tuple[int, int]], distortion_count: int = 5) -> None:
        self._board, self._reference, self._sizes = board, reference, dict(sizes_px)
        self._distortion_count = distortion_count
        self._sightings: dict[tuple[str, str], Sighting] = {}
        self._rejected: dict[tuple[str, str], Rejection] = {}

    def add_sighting(self, sighting: Sighting) -> None:
        """Add the sighting of one camera in one view."""
        self._sightings[sighting.camera, sighting.view] = sighting

    def reject(self, camera: str, view: str, reason: str) -> None:
        """Note that an image was rejected, with the reason."""
        self._rejected[camera, view] = Rejection(camera, view, reason)

    def remove(self, view: str) -> None:
        """Remove a view, in all cameras."""
        self._sightings = {key: sighting for key, sighting in self._sightings.items() if key[1] != view}
        self._rejected = {key: rejection for key, rejection in self._rejected.items() if key[1] != view}

    def coverage(self, camera: str) -> float:
        """Return the fraction of the image's 5 × 5 cells with corners."""
        pixels = [sighting.corners_px for sighting in self._of(camera)]
        if not pixels:
            return 0.0
        cells = np.floor(np.concatenate(pixels) / np.array(self._sizes[camera]) * CELLS).clip(0, CELLS - 1).astype(int)
        return len(np.unique(cells, axis=0)) / CELLS**2

    def tilt_rad(self, camera: str) -> float:
        """Return the largest angle between the board's normals in two views, from a rough focal length."""
        normals = np.array([self._normal(sighting) for sighting in self._of(camera)]).reshape(-1, 3)
        return float(np.arccos(np.clip(normals @ normals.T, -1, 1)).max()) if len(normals) else 0.0

    def shortfalls(self) -> tuple[str, ...]:
        """Say what is still missing, for every camera."""
        missing = []
        for camera in self._sizes:
            count = len(self._of(camera))
            if count < LEAST_VIEWS:
                missing.append(f"{device_title(camera)}: {LEAST_VIEWS - count} more views are needed.")
                continue
            if count < ADVISED_VIEWS:
                missing.append(f"{device_title(camera)}: {ADVISED_VIEWS - count} more views would make it reliable.")
            if self.tilt_rad(camera) < ADVISED_TILT_RAD:
                missing.append(f"{device_title(camera)}: tilt the board by 20° to 45° in several directions.")
            if self.coverage(camera) < ADVISED_COVERAGE:
                missing.append(
                    f"{device_title(camera)}: only {self.coverage(camera):.0%} of the image was covered; bring the board to its borders."
                )
        return tuple(missing)

    def problem(self) -> CameraArrayProblem:
        """Return what was collected."""
        return CameraArrayProblem(
            self._board,
            self._reference,
            self._sizes,
            tuple(self._sightings.values()),
            tuple(self._rejected.values()),
            self._distortion_count,
        )

    def _of(self, camera: str) -> list[Sighting]:
        return [sighting for sighting in self._sightings.values() if sighting.camera == camera]

    def _normal(self, sighting: Sighting) -> FloatArray:
        width, height = self._sizes[sighting.camera]
        focal = ROUGH_FOCAL * width
        matrix = np.array([[focal, 0, width / 2], [0, focal, height / 2], [0, 0, 1]])
        _, turn, _ = cv2.solvePnP(
            self._board.flat_corners_mm[sighting.ids],
            np.array(sighting.corners_px),
            matrix,
            np.zeros(5),
            flags=cv2.SOLVEPNP_IPPE,
        )
        return np.asarray(cv2.Rodrigues(turn)[0], np.float64)[:, 2]
