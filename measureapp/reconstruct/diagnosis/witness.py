"""Independent checks of matched samples: by a third camera, orthogonal fringes, the projector, or the texture of the part."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import sqrt

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.calibration import CameraCalibration, ProjectorCalibration
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct.diagnosis.sample import COARSE_PX, SAMPLES, FlatView, SampleMatches, Samples

BLUR_SHARE, MIN_BLUR_PX = 1 / 160, 4.0  # of the image's width: what counts as surroundings in its contrast
LEAST_CONTRAST = 3e-3  # relative: above the noise of blurred grey values
CELLS, LEAST_IN_CELL = 4, 20  # parts of the image along each side; residuals that a median needs
STEP = 1e-4  # share of the depth by which a point is moved to see where its image goes


def extract_contrast(phase_map: PhaseMap) -> PhaseMap:
    """Return the map with the fine contrast of its grey values (log grey minus its surroundings') in the place of the phase."""
    there = np.asarray(phase_map.valid).astype(np.float32)
    grey = np.where(phase_map.valid, np.log(np.maximum(phase_map.grey, 1.0)), 0.0).astype(np.float32)
    wide = max(MIN_BLUR_PX, phase_map.phase_rad.shape[1] * BLUR_SHARE)
    near, far = (_blur(grey, there, width) for width in (wide / 5, wide))
    return replace(phase_map, phase_rad=np.where(phase_map.valid, near - far, np.float32(0)))


def _blur(image: FloatArray, there: FloatArray, width_px: float) -> FloatArray:
    blurred = cv2.GaussianBlur(image * there, (0, 0), width_px)
    return np.asarray(blurred / np.maximum(cv2.GaussianBlur(there, (0, 0), width_px), np.float32(1e-3)))


def correlate_contrast(
    matches: SampleMatches,
    samples: Samples,
    here: CameraCalibration,
    there: CameraCalibration,
    contrasts: tuple[PhaseMap, PhaseMap],
) -> float | None:
    """Return the correlation of the fine contrast of matched pixels of both cameras; None where one of them has none.

    The same spot of a part has the same print, scratches and shade in both images; places that only share a column have not.
    """
    index, w = matches.index[matches.front], matches.inverse_depth[matches.front]
    rays = np.column_stack([matches.flat[matches.front], np.ones(len(w))])
    spot, ahead = _normalise((there.reference_from_camera.inverse() @ here.reference_from_camera).apply(rays / w[:, None]))
    seen, there_is = FlatView.of(contrasts[1], there).at(spot[:, None])
    columns, rows = samples.pixel[index].astype(int).T
    usable = there_is[:, 0] & ahead
    both = [contrasts[0].phase_rad[rows, columns][usable].astype(float), seen[:, 0][usable].astype(float)]
    if len(both[0]) < SAMPLES // 10:
        return None
    scatter = [1.4826 * float(np.median(np.abs(values - np.median(values)))) for values in both]
    if min(scatter) < LEAST_CONTRAST:
        return None
    one, other = (np.clip(values - np.median(values), -3 * size, 3 * size) for values, size in zip(both, scatter, strict=True))
    return float(np.corrcoef(one, other)[0, 1])


@dataclass(frozen=True, slots=True, eq=False)
class Residuals:
    """Residuals of matched points observed by a witness, in pixels, with the noise that phases alone explain."""

    px: FloatArray  # (R,)
    sigma_px: FloatArray  # (R,)
    depth_per_px: FloatArray  # (R,) mm
    pixel: FloatArray  # (R, 2), where in the first camera

    def systematic_px(self) -> tuple[float, float]:
        """Return the root mean square of the medians over parts of the image, without their noise, and that noise.

        Medians of hundreds of residuals show a camera that moved by less than the noise of one pixel, and do not depend on the predicted σ.
        """
        low, high = self.pixel.min(axis=0), self.pixel.max(axis=0)
        cells = np.minimum((self.pixel - low) / np.maximum(high - low, 1.0) * CELLS, CELLS - 1).astype(int)
        numbers = cells[:, 0] + CELLS * cells[:, 1]
        squares, noises = [], []
        for number in np.unique(numbers):
            px = self.px[numbers == number]
            if len(px) >= LEAST_IN_CELL:
                middle = float(np.median(px))
                squares.append(middle**2)
                noises.append((1.2533 * 1.4826 * float(np.median(np.abs(px - middle)))) ** 2 / len(px))
        if not squares:
            return 0.0, np.inf
        noise = float(np.mean(noises))
        return sqrt(max(float(np.mean(squares)) - noise, 0.0)), sqrt(noise)

    @property
    def noise_px(self) -> float:
        """Median standard deviation that phase noise explains."""
        return float(np.median(self.sigma_px))

    @property
    def beyond_noise_px(self) -> float:
        """The robust root mean square, without what phase noise explains."""
        middle = float(np.median(self.px))
        scatter = 1.4826 * float(np.median(np.abs(self.px - middle)))
        return sqrt(max(middle**2 + scatter**2 - self.noise_px**2, 0.0))


def observe_with_camera(
    matches: SampleMatches, samples: Samples, here: CameraCalibration, witness: CameraCalibration, view: FlatView, orthogonal: bool = False
) -> Residuals:
    """Observe the points of a pair with a camera; residuals in pixels across the fringes, where calibration errors appear in full.

    A third camera observes the phase that was matched. With ``orthogonal``, ``samples`` and ``view`` hold the phase of the orthogonal
    fringes, and the camera may be one of the pair.
    """
    index, w = matches.index[matches.front], matches.inverse_depth[matches.front]
    rays = np.column_stack([matches.flat[matches.front], np.ones(len(w))])
    change = witness.reference_from_camera.inverse() @ here.reference_from_camera
    spot, ahead = _normalise(change.apply(rays / w[:, None]))
    way = _normalise(change.apply(rays / (w * (1 + STEP))[:, None]))[0] - spot
    per_w = np.linalg.norm(way, axis=1) * view.focal_px / (STEP * w)
    way /= np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-30)
    half, aside = way * view.step / 2, np.column_stack([-way[:, 1], way[:, 0]]) * view.step / 2
    phase, there_is = view.at(np.stack([spot, spot - half, spot + half, spot - aside, spot + aside], axis=1))
    along, beside = (phase[:, 2] - phase[:, 1]) / COARSE_PX, (phase[:, 4] - phase[:, 3]) / COARSE_PX
    steep = np.hypot(along, beside)
    usable = ahead & there_is.all(axis=1) & (steep * COARSE_PX < np.pi) & (steep > 1e-9) & np.isfinite(samples.phase[index])
    gain = 0.0 if orthogonal else np.abs(along * per_w / np.where(matches.slope[matches.front] == 0, 1e-30, matches.slope[matches.front]))
    noise = samples.sigma[index] * np.sqrt(2 + 2 * gain**2)
    safe = np.where(usable, steep, 1.0)
    px, sigma = (samples.phase[index] - phase[:, 0]) / safe, noise / safe
    return Residuals(px[usable], sigma[usable], matches.depth_per_px[matches.front][usable], samples.pixel[index][usable])


def _normalise(points: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Return normalised image coordinates (N, 2), and which points (N, 3) lie in front."""
    ahead = points[:, 2] > 0
    return points[:, :2] / np.where(ahead, points[:, 2], 1.0)[:, None], ahead


def compare_with_projector(
    matches: SampleMatches, samples: Samples, here: CameraCalibration, projector: ProjectorCalibration, phase_map: PhaseMap
) -> tuple[Residuals, FloatArray]:
    """Compare the projector's columns of points with those of their phase, in pixels of the camera; also both columns (R, 2)."""
    index, w = matches.index[matches.front], matches.inverse_depth[matches.front]
    rays = np.column_stack([matches.flat[matches.front], np.ones(len(w))])
    points = (projector.reference_from_projector.inverse() @ here.reference_from_camera).apply(rays / w[:, None])
    ahead = points[:, 2] > 0
    columns = np.zeros((len(w), 2))
    columns[ahead, 0] = projector.pinhole.project(points[ahead])[:, 0]
    scale, offset = phase_map.pixel_of_phase()
    columns[:, 1] = samples.phase[index] * scale + offset
    per_px = np.maximum(np.linalg.norm(samples.gradient[index], axis=1) * scale, 1e-9)
    noise = samples.sigma[index] * scale / per_px
    px = (columns[:, 0] - columns[:, 1]) / per_px
    return Residuals(px[ahead], 2 * noise[ahead], matches.depth_per_px[matches.front][ahead], samples.pixel[index][ahead]), columns[ahead]
