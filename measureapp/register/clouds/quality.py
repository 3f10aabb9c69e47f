"""What one cloud is worth: density, noise, outliers and distortion on a sample of whole patches (methods sheet, section 8)."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import CloudQuality, PointCloud
from measureapp.register.settings import QualitySettings

CELL_MM = 6.0
SAMPLE_POINTS = 60_000
CELLS_AROUND = 6  # times as many points lie in a cell and around it as in it, on a surface
JUDGED_POINTS = 1500
NEIGHBOURS = 8
OUTLIER_FACTOR = 3.0  # a point whose neighbours are this many times further than usual is an outlier
PLANE_POINTS = 32
WAVE_MM = CELL_MM  # radius within which a smooth surface is a quadric; the neighbourhoods of a sample are whole up to there
WAVE_PATCHES = 200
WAVE_POINTS = 400  # at most in a patch
LEAST_WAVE_POINTS = 30
WAVE_CELL_MM = 2.0  # cells of a patch
LEAST_IN_WAVE_CELL = 5
LEAST_WAVE_CELLS = 12
GAUSSIAN = 1.4826  # standard deviation over the median absolute deviation of normal errors
SMOOTH_COSINE = 0.94  # normals within 20° of their mean: no edge runs through the patch
LEAST_SMOOTH = 8  # patches
WORST_SHARE = 0.9  # distortions are local: of all patches the worst tenth is judged


def judge(cloud: PointCloud, settings: QualitySettings | None = None, *, completeness: float = 1.0) -> CloudQuality:
    """Judge a cloud by the definitions of the methods sheet.

    Density is points per mm² of surface from the distance of the eighth neighbour; noise the RMS distance to a plane
    through the points within a fixed radius; the outlier ratio is the share of points whose neighbours are more
    than three times as far as usual. Distortion is by how much smooth patches of 6 mm radius depart from a quadric beyond their noise,
    at the edge of the worst tenth: waves shorter than the patches and longer than their cells of 2 mm, as wrong phases leave them. All are taken on a random sample of
    whole patches.

    Parameters
    ----------
    completeness : share of the pixels that see the part and have a point; known to whoever reconstructed the cloud
    """
    settings = settings or QualitySettings()
    if len(cloud) <= PLANE_POINTS:
        return CloudQuality(len(cloud), 0.0, 0.0, 0.0, completeness, False, f"only {len(cloud)} points")
    density, noise, outliers = _figures(np.asarray(cloud.points_mm), settings.plane_radius_mm)
    distortion = _distortion(np.asarray(cloud.points_mm), np.asarray(cloud.normals))
    reasons = _reasons(len(cloud), density, noise, outliers, completeness, distortion, settings)
    return CloudQuality(len(cloud), density, noise, outliers, completeness, not reasons, "; ".join(reasons), distortion)


def _reasons(
    points: int, density: float, noise: float, outliers: float, completeness: float, distortion: float, settings: QualitySettings
) -> list[str]:
    found = []
    if points < settings.least_points:
        found.append(f"only {points} points")
    if density < settings.least_density_per_mm2:
        found.append(f"only {density:.2f} points per mm²")
    if noise > settings.largest_noise_mm:
        found.append(f"noise of {noise:.3f} mm")
    if outliers > settings.largest_outlier_ratio:
        found.append(f"{outliers:.1%} outliers")
    if distortion > settings.largest_distortion_mm:
        found.append(f"the surface waves by {distortion:.3f} mm")
    if completeness < settings.least_completeness:
        found.append(f"only {completeness:.0%} of the visible surface has points")
    return found


def patches(points_mm: FloatArray, wanted: int = SAMPLE_POINTS) -> tuple[FloatArray, FloatArray]:
    """Return the points of randomly chosen cells of space with all points around them, and those of the cells alone.

    About ``wanted`` points are taken in all. The neighbourhood of every point of the cells is whole.
    """
    around, core = _patches(points_mm, wanted)
    return points_mm[around], points_mm[core]


def _patches(points_mm: FloatArray, wanted: int) -> tuple[IntArray, IntArray]:
    """Return the indices of the points of `patches`."""
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
    """Return the usual distance of neighbouring points on the surface, as that of a square grid of the same density."""
    sample, core = patches(points_mm)
    distances, _ = cKDTree(sample).query(_judged(core), min(NEIGHBOURS + 1, len(sample)))
    return float(1 / np.sqrt(_density(distances[:, 1:])))


def _judged(core: FloatArray) -> FloatArray:
    return core[np.random.default_rng(1).choice(len(core), min(JUDGED_POINTS, len(core)), replace=False)]


def _density(distances: FloatArray) -> float:
    return float(distances.shape[1] / (np.pi * max(float(np.median(distances[:, -1])) ** 2, 1e-12)))


def _figures(points_mm: FloatArray, radius_mm: float) -> tuple[float, float, float]:
    sample, core = patches(points_mm)
    distances, index = cKDTree(sample).query(_judged(core), PLANE_POINTS)
    mean = distances[:, 1 : NEIGHBOURS + 1].mean(axis=1)
    outliers = float(np.mean(mean > OUTLIER_FACTOR * np.median(mean)))
    return _density(distances[:, 1 : NEIGHBOURS + 1]), _plane_noise(sample[index], distances <= radius_mm), outliers


def _distortion(points_mm: FloatArray, normals: FloatArray) -> float:
    """Return by how much smooth patches depart from a quadric beyond the noise; zero where too few patches are smooth."""
    around, core = _patches(points_mm, SAMPLE_POINTS)
    sample, facing = points_mm[around], np.asarray(normals[around], np.float64)
    middles = np.random.default_rng(2).choice(core, min(WAVE_PATCHES, len(core)), replace=False)
    _, index = cKDTree(sample).query(points_mm[middles], min(WAVE_POINTS, len(sample)), distance_upper_bound=WAVE_MM)
    excess = []
    for near in index:
        inside = near[near < len(sample)]
        mean = facing[inside].mean(axis=0)
        length = float(np.linalg.norm(mean))
        if len(inside) >= LEAST_WAVE_POINTS and length > 0 and np.quantile(facing[inside] @ mean / length, 0.05) > SMOOTH_COSINE:
            departure = _departure(sample[inside], mean / length)
            excess += [] if departure is None else [departure]
    return float(np.sqrt(max(np.quantile(excess, WORST_SHARE), 0.0))) if len(excess) >= LEAST_SMOOTH else 0.0


def _departure(points_mm: FloatArray, normal: FloatArray) -> float | None:
    """Return the variance of a patch about the quadric over the plane across ``normal``, beyond its noise; None where it has too few points.

    Taken on medians of small cells, so that neither single stray points nor the noise of a surface seen askance count as waves.
    """
    across = np.linalg.svd(normal[None])[2][1:]
    away = points_mm - points_mm.mean(axis=0)
    u, v, height = away @ across[0], away @ across[1], away @ normal
    cell = np.unique(np.floor(np.column_stack([u, v]) / WAVE_CELL_MM).astype(int), axis=0, return_inverse=True)[1].ravel()
    order = np.argsort(cell, kind="stable")
    parts = [part for part in np.split(order, np.flatnonzero(np.diff(cell[order])) + 1) if len(part) >= LEAST_IN_WAVE_CELL]
    if len(parts) < LEAST_WAVE_CELLS:
        return None
    middle = np.array([[u[part].mean(), v[part].mean(), np.median(height[part])] for part in parts])
    scatter = np.array([GAUSSIAN * np.median(np.abs(height[part] - at)) for part, at in zip(parts, middle[:, 2], strict=True)])
    of_noise = float(np.mean(np.pi / 2 * np.median(scatter) ** 2 / np.array([len(part) for part in parts])))
    x, y, z = middle.T
    terms = np.column_stack([np.ones(len(x)), x, y, x * x, x * y, y * y])
    left = z - terms @ np.linalg.lstsq(terms, z)[0]
    return float(left @ left / (len(left) - terms.shape[1])) - of_noise


def _plane_noise(near: FloatArray, inside: FloatArray) -> float:
    """Return the median over patches of the RMS distance to their plane; patches of fewer than 8 points are passed over."""
    enough = inside.sum(axis=1) >= 8
    if not enough.any():
        return 0.0
    near, weight = near[enough], inside[enough].astype(float)
    count = weight.sum(axis=1)
    offset = near - (near * weight[:, :, None]).sum(axis=1, keepdims=True) / count[:, None, None]
    scatter = np.einsum("nk,nki,nkj->nij", weight, offset, offset)
    least = np.maximum(np.linalg.eigvalsh(scatter)[:, 0], 0)
    return float(np.median(np.sqrt(least / (count - 3))))
