"""Cleaning of a depth map on the pixel grid: flying pixels, islands, outliers, grazing and uncertain points. Also its normals."""

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
from measureapp.reconstruct import kernels
from measureapp.reconstruct.cleaning.depth_grid import DepthGrid, Lens
from measureapp.reconstruct.cleaning.gather import gathered_normals
from measureapp.reconstruct.rectification.cubics import PixelSteps
from measureapp.reconstruct.settings import ReconstructSettings

ONE_SURFACE_DEG = 80.0
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
    """What is left."""

    depth_mm: FloatArray  # (H, W) float32, 0 for none
    normals: FloatArray  # (H, W, 3) float32, in the camera's frame, towards it
    fate: IntArray  # (H, W) uint8 of PointState, NO_PHASE where there was no depth
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
    """Remove what cannot be trusted and count it by reason.

    Parameters
    ----------
    depth_mm, sigma_mm : (H, W) float32, 0 where there is no point
    rays : (H, W, 2) float32, normalised image coordinates
    spacing : distance of neighbouring pixels in normalised coordinates
    partners : the other cameras; what one of them sees at a grazing angle is mostly the border of another surface
    """
    depth, sigma = np.ascontiguousarray(depth_mm, np.float32), np.ascontiguousarray(sigma_mm, np.float32)
    others = np.zeros(depth.shape, np.uint8)
    for place, partner in enumerate(partners):
        others |= partner.takes_part.astype(np.uint8) << np.uint8(place)
    fate = np.where(depth > 0, PointState.VALID, PointState.NO_PHASE).astype(np.uint8)
    lens = Lens(rays, PixelSteps.of(rays), spacing)
    grid = cleaned(depth, sigma, others, fate, lens, [partner.centre_mm for partner in partners], settings)
    pixel, normals = gathered_normals(grid)
    dense = np.zeros((*depth.shape, 3), np.float32)
    dense[..., 2] = -1
    dense[pixel[:, 0], pixel[:, 1]] = normals
    return CleanDepth(np.where(fate == PointState.VALID, depth, np.float32(0)), dense, fate, rejections(fate))


def rejections(*fates: IntArray) -> dict[str, int]:
    """Count pixels that had a phase and gave no point, by reason."""
    counts = np.sum([in_bands(partial(_histogram, fate), len(fate)) for fate in fates], axis=(0, 1))
    return {words: int(counts[state]) for state, words in WORDS.items()}


def _histogram(fate: IntArray, start: int, stop: int) -> FloatArray:
    states = len(PointState)
    return np.asarray(cv2.calcHist([fate[start:stop]], [0], None, [states], [0, states]), np.float64).ravel()


def cleaned(
    depth_mm: FloatArray,
    sigma_mm: FloatArray,
    others: IntArray,
    fate: IntArray,
    lens: Lens,
    centres_mm: Sequence[FloatArray],
    settings: ReconstructSettings,
    memory: BufferPool | None = None,
) -> DepthGrid:
    """Remove what cannot be trusted from a depth map; ``fate`` is written to. Islands are what hangs together after all else is gone.

    Parameters
    ----------
    others : (H, W) uint8, bit i: the camera at ``centres_mm[i]``, in the frame of the depth map's, takes part
    """
    memory = memory or BufferPool()
    depth_mm, sigma_mm = read_only(depth_mm), read_only(sigma_mm)  # kernels are compiled once more for arrays that can be written to
    height, width = depth_mm.shape
    border = settings.normal_radius_px
    grown = (height + 2 * border, width + 2 * border)
    inverse = memory.empty(prod(grown) + kernels.PIXELS, np.float32)[: prod(grown)].reshape(grown)
    inverse[:border], inverse[-border:], inverse[:, :border], inverse[:, -border:] = 0, 0, 0, 0
    per_px = np.float32(lens.spacing * np.tan(np.radians(max(settings.max_incidence_deg, ONE_SURFACE_DEG))))
    normals = memory.empty((3, height, width), np.float32)
    removed = np.empty((height, -(-width // kernels.CHUNK)), np.uint8)
    made = DepthGrid(depth_mm, sigma_mm, others, fate, lens, inverse, border, per_px, normals, removed, np.empty(height, np.int64))
    worst = np.float32(settings.max_sigma_mm)
    in_bands(lambda start, stop: kernels.invert(depth_mm, sigma_mm, worst, border, start, stop, inverse, fate), height)
    _judge(made, centres_mm, settings)
    _drop_islands(made, settings.min_island_px, memory)
    return made


def _judge(grid: DepthGrid, centres_mm: Sequence[FloatArray], settings: ReconstructSettings) -> None:
    centres = np.array([*centres_mm], np.float32).reshape(-1, 3)
    limits = (
        settings.min_neighbours,
        settings.outlier_sigmas,
        settings.outlier_slope * settings.normal_radius_px * grid.lens.spacing,
        np.cos(np.radians(settings.max_incidence_deg)),
        np.cos(np.radians(settings.max_partner_incidence_deg)),
    )
    numbers = tuple(np.float32(limit) for limit in limits)
    steps, rays = grid.lens.steps, grid.lens.flat_rays
    in_bands(
        lambda start, stop: kernels.judge(
            grid.inverse,
            grid.sigma_mm,
            rays,
            steps.cubics,
            steps.unit,
            grid.per_px,
            grid.border,
            numbers,
            centres,
            grid.others,
            start,
            stop,
            grid.fate,
            grid.normals,
            grid.removed,
        ),
        len(grid.fate),
    )


def _drop_islands(grid: DepthGrid, least: int, memory: BufferPool) -> None:
    shape = grid.fate.shape
    starts, stops, counts = memory.empty(shape, np.int16), memory.empty(shape, np.int16), np.empty(shape[0], np.int32)
    in_bands(
        lambda start, stop: kernels.find_runs(
            grid.inverse, grid.sigma_mm, grid.fate, grid.per_px, grid.border, start, stop, grid.removed, starts, stops, counts
        ),
        shape[0],
    )
    kernels.drop_islands(
        grid.inverse, grid.sigma_mm, grid.per_px, grid.border, least, starts, stops, counts, grid.fate, grid.removed, grid.per_row
    )
