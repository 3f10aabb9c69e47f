"""How the views of one camera are spread: over its image, over tilts and over distances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.calibrate.cameras.camera import estimate_poses
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.cameras.shortfalls import CELLS, ROUGH_FOCAL
from measureapp.calibrate.sightings import Sighting
from measureapp.data.board import BoardDescription
from measureapp.geometry.pinhole import PinholeCamera

TILT_TARGET_DEG = 20.0  # each way; 20° to 45° separate the focal length from the distance
SPAN_TARGET = 0.15  # of distances, over their mean
SIDES = {
    "on the left side": (slice(None), slice(0, 2)),
    "on the right side": (slice(None), slice(3, 5)),
    "in the upper part": (slice(0, 2), slice(None)),
    "in the lower part": (slice(3, 5), slice(None)),
}
CORNERS = {
    "in the upper left corner": (slice(0, 2), slice(0, 2)),
    "in the upper right corner": (slice(0, 2), slice(3, 5)),
    "in the lower left corner": (slice(3, 5), slice(0, 2)),
    "in the lower right corner": (slice(3, 5), slice(3, 5)),
}
MIDDLE = {"in the middle": (slice(1, 4), slice(1, 4))}
CENTRES = {  # of the regions, as shares of width and height
    "on the left side": (0.25, 0.5),
    "on the right side": (0.75, 0.5),
    "in the upper part": (0.5, 0.25),
    "in the lower part": (0.5, 0.75),
    "in the upper left corner": (0.25, 0.25),
    "in the upper right corner": (0.75, 0.25),
    "in the lower left corner": (0.25, 0.75),
    "in the lower right corner": (0.75, 0.75),
    "in the middle": (0.5, 0.5),
}
TILTS = {  # way -> (component of the board's normal, sign, which edge moves away from the camera)
    "to the left": (0, 1.0, "left edge"),
    "to the right": (0, -1.0, "right edge"),
    "upwards": (1, 1.0, "upper edge"),
    "downwards": (1, -1.0, "lower edge"),
}


@dataclass(frozen=True, slots=True, eq=False)
class LensViews:
    """Coverage, tilts and distances of the views of one camera or the projector, by its lens or a rough focal length."""

    camera: str
    pinhole: PinholeCamera
    cells: BoolArray  # (CELLS, CELLS), which parts of the image held marks: rows from the top
    normals: FloatArray  # (V, 3), the board's z axis (away from the camera) in the camera's frame
    distances_mm: FloatArray  # (V,), of the board's middle, along the line of sight

    @property
    def what(self) -> str:
        """What it is, in a sentence."""
        return "projector" if self.camera == PROJECTOR else "camera"

    @property
    def count(self) -> int:
        """How many views there are."""
        return len(self.distances_mm)

    @property
    def coverage(self) -> float:
        """Fraction of the image's cells with marks."""
        return float(self.cells.mean())

    @property
    def tilts_deg(self) -> dict[str, float]:
        """Way -> how far the board was tilted that way at most; never below 0.

        A board tilted to the left faces to the left in the image, so that its left edge is farther away.
        """
        angles = np.rad2deg(np.arctan2(self.normals[:, :2], self.normals[:, 2:]))
        return {way: float(max(0.0, (sign * angles[:, axis]).max(initial=0.0))) for way, (axis, sign, _) in TILTS.items()}

    @property
    def distance_span(self) -> float:
        """Largest less smallest distance, over their mean."""
        return float(np.ptp(self.distances_mm) / self.distances_mm.mean()) if self.count else 0.0

    def empty_region(self, wanted: float) -> str | None:
        """Return the region where the board should be shown: a side without any mark, a corner without, or what is emptiest.

        Parameters
        ----------
        wanted : coverage from which on only empty sides and corners count
        """
        for regions in (SIDES, CORNERS):
            empty = [name for name, place in regions.items() if not self.cells[place].any()]
            if empty:
                return empty[0]
        if self.coverage >= wanted:
            return None
        shares = {name: float(self.cells[place].mean()) for name, place in (CORNERS | MIDDLE).items()}
        return min(shares, key=lambda name: shares[name])

    def least_tilt(self) -> str | None:
        """Return the way in which the board should be tilted more; None where all were."""
        tilts = self.tilts_deg
        way = min(tilts, key=lambda name: tilts[name])
        return way if tilts[way] < TILT_TARGET_DEG else None

    def next_distance(self) -> str | None:
        """Return how the distance should change, as part of a sentence; None where it did."""
        if not self.count or self.distance_span >= SPAN_TARGET:
            return None
        middle, share = float(np.median(self.distances_mm)), SPAN_TARGET / 2
        near, far = 1 - self.distances_mm.min() / middle, self.distances_mm.max() / middle - 1
        if near < share / 2 and far < share / 2:
            return f"once {SPAN_TARGET / 2:.0%} nearer to the {self.what} and once {SPAN_TARGET / 2:.0%} farther away"
        return f"nearer to the {self.what}" if near < far else f"farther away from the {self.what}"


def rough_lens(size_px: tuple[int, int]) -> PinholeCamera:
    """Return a lens good enough to estimate tilts, without distortion."""
    width, height = size_px
    focal = ROUGH_FOCAL * width
    return PinholeCamera(width, height, np.array([[focal, 0, (width - 1) / 2], [0, focal, (height - 1) / 2], [0, 0, 1]]), np.zeros(5))


def lens_views(camera: str, pinhole: PinholeCamera, sightings: Sequence[Sighting], board: BoardDescription) -> LensViews:
    """Evaluate coverage, tilts and distances of the sightings of one camera."""
    own = [one for one in sightings if one.camera == camera]
    cells = np.zeros((CELLS, CELLS), bool)
    for one in own:
        at = np.floor(one.corners_px / np.array([pinhole.width_px, pinhole.height_px]) * CELLS).clip(0, CELLS - 1).astype(int)
        cells[at[:, 1], at[:, 0]] = True
    poses = list(estimate_poses(own, board, pinhole).camera_from_board.values())
    normals = np.array([pose.rotation[:, 2] for pose in poses]).reshape(-1, 3)
    middles = np.array([pose.apply(board.middle_mm) for pose in poses]).reshape(-1, 3)
    return LensViews(camera, pinhole, cells, normals, middles[:, 2])
