"""Cleaning of a depth map on the pixel grid: uncertain points, flying pixels, outliers, grazing incidence, isolated patches. Also its normals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from math import prod

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.reconstruct import kernels
from measureapp.reconstruct.cleaning.depth_grid import DepthGrid, Lens
from measureapp.reconstruct.cleaning.gather import gather_normals
from measureapp.reconstruct.kernels.clean import CHUNK, Criteria
from measureapp.reconstruct.kernels.structures import LANES
from measureapp.reconstruct.rectification.jacobian import PixelJacobian
from measureapp.reconstruct.settings import ReconstructSettings

ONE_SURFACE_DEG = 80.0  # least incidence up to which neighbours count as one surface
WORDS = {
    PointState.UNMATCHED: "unmatched",
    PointState.AMBIGUOUS: "ambiguous",
    PointState.CONTRADICTED: "contradicted",
    PointState.UNCERTAIN: "uncertain",
    PointState.FLYING: "flying",
    PointState.OUTLIER: "outlier",
    PointState.GRAZING: "grazing",
    PointState.PARTNER_GRAZING: "grazing for a partner",
    PointState.ISLAND: "island",
    PointState.RIM: "at a rim",
}


@dataclass(frozen=True, slots=True, eq=False)
class CleanDepth:
    """A depth map after cleaning."""

    depth_mm: FloatArray  # (H, W) float32, 0 for none
    normals: FloatArray  # (H, W, 3) float32, in the camera's frame, towards it
    state: IntArray  # (H, W) uint8 of PointState, NO_PHASE where there was no depth
    rejected: dict[str, int]  # reason -> count


@dataclass(frozen=True, slots=True, eq=False)
class Partner:
    """Another camera that takes part in points."""

    centre_mm: FloatArray  # (3,) in the frame of the camera whose depth map it is
    takes_part: BoolArray  # (H, W)


def clean(
    depth_mm: FloatArray,
    sigma_mm: FloatArray,
    rays: FloatArray,
    spacing: float,
    partners: Sequence[Partner],
    settings: ReconstructSettings,
) -> CleanDepth:
    """Reject points that cannot be trusted and count them by reason.

    Parameters
    ----------
    depth_mm, sigma_mm : (H, W) float32, 0 where there is no point
    rays : (H, W, 2) float32, normalised image coordinates
    spacing : distance of neighbouring pixels in normalised coordinates
    partners : the other cameras; what one of them sees at grazing incidence is mostly the edge of another surface
    """
    depth, sigma = np.ascontiguousarray(depth_mm, np.float32), np.ascontiguousarray(sigma_mm, np.float32)
    others = np.zeros(depth.shape, np.uint8)
    for place, partner in enumerate(partners):
        others |= partner.takes_part.astype(np.uint8) << np.uint8(place)
    state = np.where(depth > 0, PointState.VALID, PointState.NO_PHASE).astype(np.uint8)
    lens = Lens(rays, PixelJacobian.of(rays), spacing)
    grid = clean_grid(depth, sigma, others, state, lens, [partner.centre_mm for partner in partners], settings)
    pixel, normals = gather_normals(grid, len(partners))
    dense = np.zeros((*depth.shape, 3), np.float32)
    dense[..., 2] = -1
    dense[pixel[:, 0], pixel[:, 1]] = normals
    return CleanDepth(np.where(state == PointState.VALID, depth, np.float32(0)), dense, state, count_rejections(state))


def count_rejections(*states: IntArray) -> dict[str, int]:
    """Count pixels that had a phase and gave no point, by reason."""
    counts = np.sum([in_bands(partial(_histogram, state), len(state)) for state in states], axis=(0, 1))
    return {words: int(counts[state]) for state, words in WORDS.items()}


def _histogram(state: IntArray, start: int, stop: int) -> FloatArray:
    count = len(PointState)
    return np.asarray(cv2.calcHist([state[start:stop]], [0], None, [count], [0, count]), np.float64).ravel()


def clean_grid(
    depth_mm: FloatArray,
    sigma_mm: FloatArray,
    others: IntArray,
    state: IntArray,
    lens: Lens,
    centres_mm: Sequence[FloatArray],
    settings: ReconstructSettings,
    memory: BufferPool | None = None,
) -> DepthGrid:
    """Reject points of a depth map; ``state`` is written to. Isolated patches are what is connected after all other rejections.

    Parameters
    ----------
    others : (H, W) uint8, bit i: the camera at ``centres_mm[i]``, in the frame of the depth map's, takes part

    Raises
    ------
    ReconstructError
        The image has less than 16 columns.
    """
    memory = memory or BufferPool()
    depth_mm, sigma_mm = read_only(depth_mm), read_only(sigma_mm)  # kernels are compiled once more for arrays that can be written to
    height, width = depth_mm.shape
    if width < LANES:
        raise ReconstructError(f"The image has {width} columns; at least {LANES} are needed.", "Use images of the whole sensor.")
    radius = settings.normal_radius_px
    padded = (height + 2 * radius, width + 2 * radius)
    inverse = memory.empty(prod(padded), np.float32).reshape(padded)
    inverse[:radius], inverse[-radius:], inverse[:, :radius], inverse[:, -radius:] = 0, 0, 0, 0
    step_per_px = np.float32(lens.spacing * np.tan(np.radians(max(settings.max_incidence_deg, ONE_SURFACE_DEG))))
    normals, per_row = memory.empty((3, height, width), np.float32), np.empty(height, np.int64)
    grid = DepthGrid(depth_mm, sigma_mm, others, state, lens, inverse, radius, step_per_px, normals, per_row)
    removed = np.empty((height, -(-width // CHUNK)), np.uint8)
    worst = np.float32(np.inf if settings.max_sigma_mm is None else settings.max_sigma_mm)
    in_bands(lambda start, stop: kernels.invert_depth(depth_mm, sigma_mm, worst, radius, start, stop, inverse, state), height)
    surface, criteria = grid.surface, _criteria(centres_mm, lens, settings)
    in_bands(lambda start, stop: kernels.reject_points(surface, others, criteria, start, stop, state, normals, removed), height)
    _remove_isolated_patches(grid, settings.min_island_px, removed, memory)
    in_bands(lambda start, stop: kernels.refit_normals(surface, removed, start, stop, normals), height)
    return grid


def _criteria(centres_mm: Sequence[FloatArray], lens: Lens, settings: ReconstructSettings) -> Criteria:
    return Criteria(
        np.float32(settings.min_neighbours),
        np.float32(settings.outlier_sigmas),
        np.float32(settings.outlier_slope * settings.normal_radius_px * lens.spacing),
        np.float32(np.cos(np.radians(settings.max_incidence_deg))),
        np.float32(np.cos(np.radians(settings.max_partner_incidence_deg))),
        np.array([*centres_mm], np.float32).reshape(-1, 3),
    )


def _remove_isolated_patches(grid: DepthGrid, min_pixels: int, removed: IntArray, memory: BufferPool) -> None:
    shape, surface, state = grid.state.shape, grid.surface, grid.state
    starts, stops, counts = memory.empty(shape, np.int16), memory.empty(shape, np.int16), np.empty(shape[0], np.int32)
    in_bands(lambda start, stop: kernels.find_runs(surface, state, removed, start, stop, starts, stops, counts), shape[0])
    kernels.remove_small_components(surface, min_pixels, starts, stops, counts, state, removed, grid.per_row)
