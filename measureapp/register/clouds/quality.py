"""Quality of one cloud: density, noise, outliers and distortion, on a random sample of patches (methods sheet, section 8)."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import CloudQuality, PointCloud
from measureapp.register.settings import QualitySettings

CELL_MM = 6.0
SAMPLE_POINTS = 60_000
CELLS_AROUND = 6  # on a surface, a cell and its neighbours hold this many times the points of the cell
EVALUATED_POINTS = 1500
NEIGHBOURS = 8
OUTLIER_FACTOR = 3.0  # an outlier's mean neighbour distance exceeds this multiple of the median
PLANE_POINTS = 32
WAVE_MM = CELL_MM  # radius of the quadric patches; sampled neighbourhoods are complete up to there
WAVE_PATCHES = 200
WAVE_POINTS = 400  # at most in a patch
LEAST_WAVE_POINTS = 30
WAVE_CELL_MM = 2.0  # cells of a patch
LEAST_IN_WAVE_CELL = 5
LEAST_WAVE_CELLS = 12
MAD_TO_SIGMA = 1.4826  # standard deviation over the median absolute deviation of normal errors
SMOOTH_COSINE = 0.94  # normals within 20° of their mean: no edge in the patch
LEAST_SMOOTH = 8  # patches
DISTORTION_QUANTILE = 0.9  # distortions are local: the worst tenth of the patches counts


def assess_cloud(cloud: PointCloud, settings: QualitySettings | None = None, *, completeness: float = 1.0) -> CloudQuality:
    """Assess a cloud by the definitions of the methods sheet.

    Density: points per mm² of surface, from the distance of the eighth neighbour. Noise: rms distance to the plane through the points
    within a fixed radius. Outlier ratio: share of points whose mean neighbour distance exceeds three times the median. Distortion: rms
    departure of smooth patches of 6 mm radius from a quadric beyond their noise, 90 % quantile over the patches; it shows waves between
    2 mm (the cells) and 6 mm, as wrong phases cause them. All are evaluated on a random sample of complete patches.

    Parameters
    ----------
    completeness : share of the pixels on the part that have a point, from reconstruction
    """
    settings = settings or QualitySettings()
    if len(cloud) <= PLANE_POINTS:
        return CloudQuality(len(cloud), 0.0, 0.0, 0.0, completeness, False, f"only {len(cloud)} points")
    density, noise, outliers = _density_noise_outliers(np.asarray(cloud.points_mm), settings.plane_radius_mm)
    distortion = _distortion(np.asarray(cloud.points_mm), np.asarray(cloud.normals))
    reasons = _list_shortfalls(len(cloud), density, noise, outliers, completeness, distortion, settings)
    return CloudQuality(len(cloud), density, noise, outliers, completeness, not reasons, "; ".join(reasons), distortion)


def _list_shortfalls(
    points: int, density: float, noise: float, outliers: float, completeness: float, distortion: float, settings: QualitySettings
) -> list[str]:
    found = []
    if points < settings.least_points:
        found.append(f"only {points} points")
    if density < settings.least_density_per_mm2:
        found.append(f"only {density:.2f} points per mm²")
    if noise > settings.largest_noise_mm:
        found.append(f"point noise of {noise:.3f} mm")
    if outliers > settings.largest_outlier_ratio:
        found.append(f"{outliers:.1%} outliers")
    if distortion > settings.largest_distortion_mm:
        found.append(f"surface distortion of {distortion:.3f} mm")
    if completeness < settings.least_completeness:
        found.append(f"only {completeness:.0%} of the visible surface has points")
    return found


def sample_patches(points_mm: FloatArray, wanted: int = SAMPLE_POINTS) -> tuple[FloatArray, FloatArray]:
    """Sample about ``wanted`` points of random grid cells: the cells with all points around them, and the points of the cells alone.

    The neighbourhood of every point of the cells is complete.
    """
    around, core = _sample_patch_indices(points_mm, wanted)
    return points_mm[around], points_mm[core]


def _sample_patch_indices(points_mm: FloatArray, wanted: int) -> tuple[IntArray, IntArray]:
    """Return the indices of the points of `sample_patches`."""
    if len(points_mm) <= wanted:
        return np.arange(len(points_mm)), np.arange(len(points_mm))
    index = np.floor((points_mm - points_mm.min(axis=0)) / CELL_MM).astype(np.int64) + 1
    extent = index.max(axis=0) + 2
    flat = (index[:, 0] * extent[1] + index[:, 1]) * extent[2] + index[:, 2]
    cells = np.unique(flat[:: max(1, len(flat) // 20_000)])
    share = max(1, min(len(cells), round(len(cells) * wanted / len(points_mm) / CELLS_AROUND)))
    chosen = np.random.default_rng(0).choice(cells, share, replace=False)
    steps = [(x * extent[1] + y) * extent[2] + z for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)]
    around = np.flatnonzero(np.isin(flat, (chosen[:, None] + np.array(steps)).ravel()))
    return around, around[np.isin(flat[around], chosen)]


def point_spacing_mm(points_mm: FloatArray) -> float:
    """Return the median point spacing on the surface: that of a square grid of the same density."""
    sample, core = sample_patches(points_mm)
    distances, _ = cKDTree(sample).query(_subsample(core), min(NEIGHBOURS + 1, len(sample)))
    return float(1 / np.sqrt(_density(distances[:, 1:])))


def _subsample(core: FloatArray) -> FloatArray:
    return core[np.random.default_rng(1).choice(len(core), min(EVALUATED_POINTS, len(core)), replace=False)]


def _density(distances: FloatArray) -> float:
    return float(distances.shape[1] / (np.pi * max(float(np.median(distances[:, -1])) ** 2, 1e-12)))


def _density_noise_outliers(points_mm: FloatArray, radius_mm: float) -> tuple[float, float, float]:
    sample, core = sample_patches(points_mm)
    distances, index = cKDTree(sample).query(_subsample(core), PLANE_POINTS)
    mean = distances[:, 1 : NEIGHBOURS + 1].mean(axis=1)
    outliers = float(np.mean(mean > OUTLIER_FACTOR * np.median(mean)))
    return _density(distances[:, 1 : NEIGHBOURS + 1]), _plane_noise(sample[index], distances <= radius_mm), outliers


def _distortion(points_mm: FloatArray, normals: FloatArray) -> float:
    """Return the departure of smooth patches from a quadric beyond the noise (mm); zero with too few smooth patches."""
    around, core = _sample_patch_indices(points_mm, SAMPLE_POINTS)
    sample, facing = points_mm[around], np.asarray(normals[around], np.float64)
    middles = np.random.default_rng(2).choice(core, min(WAVE_PATCHES, len(core)), replace=False)
    _, index = cKDTree(sample).query(points_mm[middles], min(WAVE_POINTS, len(sample)), distance_upper_bound=WAVE_MM)
    excess = []
    for near in index:
        inside = near[near < len(sample)]
        mean = facing[inside].mean(axis=0)
        length = float(np.linalg.norm(mean))
        if len(inside) >= LEAST_WAVE_POINTS and length > 0 and np.quantile(facing[inside] @ mean / length, 0.05) > SMOOTH_COSINE:
            departure = _quadric_residual_variance(sample[inside], mean / length)
            excess += [] if departure is None else [departure]
    return float(np.sqrt(max(np.quantile(excess, DISTORTION_QUANTILE), 0.0))) if len(excess) >= LEAST_SMOOTH else 0.0


def _quadric_residual_variance(points_mm: FloatArray, normal: FloatArray) -> float | None:
    """Return the residual variance (mm²) of a patch about a quadric height field along ``normal``, less its noise; None with too few points.

    Medians of small cells are fitted, so that neither stray points nor the noise of an obliquely viewed surface count as waves.
    """
    across = np.linalg.svd(normal[None])[2][1:]
    away = points_mm - points_mm.mean(axis=0)
    u, v, height = away @ across[0], away @ across[1], away @ normal
    cell = np.floor(np.column_stack([u, v]) / WAVE_CELL_MM).astype(np.int64)
    cell -= cell.min(axis=0)
    number = cell[:, 0] * (int(cell[:, 1].max()) + 1) + cell[:, 1]
    order = np.lexsort((height, number))
    first = np.flatnonzero(np.diff(number[order], prepend=-1))
    count = np.diff(first, append=len(order))
    level = _middles(height[order], first, count)
    away_from_level = np.abs(height[order] - np.repeat(level, count))
    scatter = MAD_TO_SIGMA * _middles(away_from_level[np.lexsort((away_from_level, number[order]))], first, count)
    full = count >= LEAST_IN_WAVE_CELL
    if np.count_nonzero(full) < LEAST_WAVE_CELLS:
        return None
    middle = np.column_stack([np.add.reduceat(u[order], first) / count, np.add.reduceat(v[order], first) / count, level])[full]
    of_noise = float(np.mean(np.pi / 2 * np.median(scatter[full]) ** 2 / count[full]))
    x, y, z = middle.T
    terms = np.column_stack([np.ones(len(x)), x, y, x * x, x * y, y * y])
    left = z - terms @ np.linalg.lstsq(terms, z)[0]
    return float(left @ left / (len(left) - terms.shape[1])) - of_noise


def _middles(values: FloatArray, first: IntArray, count: IntArray) -> FloatArray:
    """Return the medians of groups of ``values``, which are sorted within their groups: from ``first`` on, ``count`` of them."""
    return np.asarray((values[first + (count - 1) // 2] + values[first + count // 2]) / 2)


def _plane_noise(near: FloatArray, inside: FloatArray) -> float:
    """Return the median over patches of the rms distance to their plane; patches of fewer than 8 points are skipped."""
    enough = inside.sum(axis=1) >= 8
    if not enough.any():
        return 0.0
    near, weight = near[enough], inside[enough].astype(float)
    count = weight.sum(axis=1)
    offset = near - (near * weight[:, :, None]).sum(axis=1, keepdims=True) / count[:, None, None]
    scatter = np.einsum("nk,nki,nkj->nij", weight, offset, offset)
    least = np.maximum(np.linalg.eigvalsh(scatter)[:, 0], 0)
    return float(np.median(np.sqrt(least / (count - 3))))
