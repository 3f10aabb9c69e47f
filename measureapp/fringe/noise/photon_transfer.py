"""Photon transfer: the noise model of a camera from how the variance of its pixels grows with their mean."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from measureapp.arrays import FloatArray, ImageArray
from measureapp.errors import CalibrationError
from measureapp.fringe.noise.model import QUANTISATION_VARIANCE, CameraNoise
from measureapp.fringe.noise.transfer_points import TransferPoint, points_of_flats

LEAST_POINTS, LEAST_SPAN = 3, 0.08  # of saturation between the darkest and the brightest point
SOUND_DEVIATION, POOR_DEVIATION = 0.05, 0.15  # of a point's variance from the model
SOUND_CHI2 = 3.0
LARGEST_GAIN_SD = 0.2  # share of the gain
LEAST_PEAK = 0.3  # of saturation, where the variance may begin to fall because pixels are full
CLIPPED_DARK = 0.01  # share of zeros in dark images above which there is no black level to measure
HARMONICS_OF_ROUNDING = 100
BLACK_SHARE_OF_FLOOR = 4.0  # standard deviations by which the fitted line may pass below zero
TAKE_FLATS = "Take pairs of images of an evenly lit, unmoved surface at five or more exposures from dark to nearly saturated."


@dataclass(frozen=True, slots=True)
class NoiseEstimate:
    """The noise model of one camera with its standard deviations and how well it fits."""

    camera: str
    noise: CameraNoise
    saturation: float
    gain_e_per_grey: float
    gain_sd: float
    full_well_sd_e: float
    read_noise_sd_e: float
    points: tuple[TransferPoint, ...]
    predicted_variance: tuple[float, ...]  # of the points, grey levels²
    chi2: float  # per degree of freedom, from the statistical error of the points alone
    worst_deviation: float  # of a point's variance from the model, as a share of it
    verdict: str
    accepted: bool


def estimate_noise(levels: Sequence[ImageArray], saturation: float, camera: str = "", dark: ImageArray | None = None) -> NoiseEstimate:
    """Estimate gain, read noise and quantisation step from repeated flat images [1]_ [2]_.

    The images of a level are differenced, which cancels the fixed pattern; pixels are gathered by their mean, so that
    an uneven flat (or any still scene) gives several points. Over the points the variance is
    (mean − black)/K + (r/K)² plus what rounding adds; K is the gain in electrons per grey level and r the read noise. Where noise is
    below half a grey level, rounding adds less than 1/12 to a difference of two images: that is in the model.

    Parameters
    ----------
    levels : of each brightness (n ≥ 2, H, W) images of the same scene; at least as many brightnesses as give three points
    saturation : grey level of a saturated pixel; saturated and clipped pixels are not used
    dark : (n ≥ 2, H, W) images without light, which give the black level; without them it is 0

    Raises
    ------
    CalibrationError
        Too few levels, all of them saturated or dark, images of a level that differ in brightness, or a variance that
        does not grow with the mean.

    References
    ----------
    .. [1] EMVA Standard 1288, Release 4.0, sections 2.2 and 6, 2021.
    .. [2] J. R. Janesick, Photon Transfer, SPIE Press, 2007.
    """
    step = _grey_step([*levels, *([] if dark is None else [dark])])
    black = 0.0 if dark is None or np.mean(dark == 0) > CLIPPED_DARK else float(np.mean(dark, dtype=np.float64))
    points = points_of_flats(levels, saturation, camera, step)
    if dark is not None:
        points += points_of_flats([dark], saturation, camera, step)
    return fit_transfer(points, saturation, camera, black, step)


def fit_transfer(points: Sequence[TransferPoint], saturation: float, camera: str, black_grey: float, step_grey: float) -> NoiseEstimate:
    """Fit the noise model to mean and variance of pixels; see `estimate_noise`."""
    used = _below_soft_saturation(points, LEAST_PEAK * saturation)
    mean, variance, sd = (np.array([getattr(point, name) for point in used]) for name in ("mean", "variance", "variance_sd"))
    _check_determined(mean, saturation, camera)
    light = mean - black_grey

    def model(values: FloatArray) -> FloatArray:
        return rounded_variance(np.maximum(light * values[0] + values[1], 1e-9), step_grey)

    start = _straight_line(light, variance - QUANTISATION_VARIANCE * step_grey**2, sd)
    _check_black_level(start, black_grey, camera)
    bounds = ([1e-12, 0.0], [np.inf, np.inf])
    first = [max(start.slope, 1e-6), max(start.floor, 1e-4 * step_grey**2)]
    fit = least_squares(lambda values: (model(values) - variance) / sd, first, bounds=bounds, x_scale=first)
    covariance = np.linalg.pinv(fit.jac.T @ fit.jac)
    predicted = model(fit.x)
    freedom = max(1, len(mean) - 2)
    chi2 = float(2 * fit.cost / freedom)
    deviation = float((np.abs(variance / predicted - 1) * (sd < SOUND_DEVIATION * predicted)).max())
    fitted = _Fit(fit.x, covariance * max(1.0, chi2), used, predicted, chi2, deviation)
    return _estimate(fitted, saturation, camera, black_grey, step_grey)


def rounded_variance(variance: FloatArray, step_grey: float) -> FloatArray:
    """Return half the mean squared difference of two rounded values whose common mean lies anywhere between two grey levels.

    For a difference δ of the values before rounding it is ½ E[δ² + f(1 − f)] with f the fraction of |δ|: variance + 1/12 for
    large noise, less where both values are mostly rounded to the same level. The series is that of f(1 − f) under the normal distribution.

    >>> float(rounded_variance(np.array(4.0), 1.0).round(4))
    4.0833
    """
    orders = np.arange(1, HARMONICS_OF_ROUNDING + 1)
    share = np.asarray(variance)[..., None] / step_grey**2
    missing = (np.exp(-4 * np.pi**2 * orders**2 * share) / orders**2).sum(axis=-1) / (2 * np.pi**2)
    return np.asarray(variance + step_grey**2 * (QUANTISATION_VARIANCE - missing))


def _grey_step(levels: Sequence[ImageArray]) -> float:
    """Return the distance of neighbouring grey levels that occur: more than 1 where fewer bits were stretched."""
    step = 0
    for images in levels:
        step = int(np.gcd.reduce(np.append(np.unique(images[0]), step)))
    return float(max(step, 1))


def _below_soft_saturation(points: Sequence[TransferPoint], least_peak: float) -> list[TransferPoint]:
    """Reject points beyond the peak of the variance: there pixels fill up. A peak in the dark has other reasons."""
    if not points:
        return []
    peak = max(points, key=lambda point: point.variance)
    return [point for point in points if peak.mean < least_peak or point.mean <= peak.mean or point.variance > 0.8 * peak.variance]


def _check_determined(mean: FloatArray, saturation: float, camera: str) -> None:
    named = f"The images of camera {camera!r}" if camera else "The images"
    if len(mean) == 0:
        raise CalibrationError(f"{named} are saturated, black, or too small everywhere.", TAKE_FLATS)
    if len(mean) < LEAST_POINTS or np.ptp(mean) < LEAST_SPAN * saturation:
        raise CalibrationError(
            f"{named} give {len(mean)} usable brightness levels from {mean.min():.1f} to {mean.max():.1f} grey levels: "
            "gain and read noise cannot be separated.",
            TAKE_FLATS,
        )


@dataclass(frozen=True, slots=True)
class _Line:
    slope: float
    floor: float
    floor_sd: float


def _straight_line(light: FloatArray, variance: FloatArray, sd: FloatArray) -> _Line:
    design = np.stack([light, np.ones_like(light)], axis=1) / sd[:, None]
    solution, *_ = np.linalg.lstsq(design, variance / sd, rcond=None)
    scatter = float(np.sqrt(max(1.0, ((design @ solution - variance / sd) ** 2).sum() / max(1, len(light) - 2))))
    sds = scatter * np.sqrt(np.diag(np.linalg.pinv(design.T @ design)))
    return _Line(float(solution[0]), float(solution[1]), float(sds[1]))


def _check_black_level(line: _Line, black_grey: float, camera: str) -> None:
    named = f"camera {camera!r}" if camera else "the camera"
    if line.slope <= 0:
        raise CalibrationError(
            f"The variance of {named} does not grow with its brightness.",
            "Use raw images: without gamma, denoising, automatic gain or lossy compression.",
        )
    if black_grey == 0 and line.floor < -BLACK_SHARE_OF_FLOOR * line.floor_sd - 0.1:
        raise CalibrationError(
            f"The variance of {named} would vanish at grey level {-line.floor / line.slope:.1f}: it has a black level.",
            "Give dark images too (lens covered), or switch the black level off.",
        )


@dataclass(frozen=True, slots=True, eq=False)
class _Fit:
    values: FloatArray  # slope and floor of the variance
    covariance: FloatArray
    points: list[TransferPoint]
    predicted: FloatArray  # variance of the points
    chi2: float  # per degree of freedom
    worst_deviation: float


def _estimate(fit: _Fit, saturation: float, camera: str, black_grey: float, step_grey: float) -> NoiseEstimate:
    (slope, floor), covariance = (float(value) for value in fit.values), fit.covariance
    gain = 1.0 / slope
    gain_sd = float(np.sqrt(covariance[0, 0])) * gain**2
    read = gain * floor**0.5
    floor_sd = float(np.sqrt(covariance[1, 1]))
    if floor > 2 * floor_sd:
        by_floor = gain / (2 * floor**0.5)
        slopes = np.array([-read * gain, by_floor])
        read_sd = float(np.sqrt(slopes @ covariance @ slopes))
    else:  # read noise that cannot be distinguished from none: its upper limit
        read_sd = gain * floor_sd**0.5
    verdict, accepted = _verdict(fit.chi2, fit.worst_deviation, read <= read_sd)
    if gain_sd > LARGEST_GAIN_SD * gain:
        verdict, accepted = (
            f"poor: the gain is uncertain by {gain_sd / gain:.0%}; more images or a wider range of brightness are needed",
            False,
        )
    noise = CameraNoise(full_well_e=gain * saturation, read_noise_e=read, step_grey=step_grey, black_grey=black_grey)
    return NoiseEstimate(
        camera=camera,
        noise=noise,
        saturation=saturation,
        gain_e_per_grey=gain,
        gain_sd=gain_sd,
        full_well_sd_e=gain_sd * saturation,
        read_noise_sd_e=read_sd,
        points=tuple(fit.points),
        predicted_variance=tuple(float(value) for value in fit.predicted),
        chi2=fit.chi2,
        worst_deviation=fit.worst_deviation,
        verdict=verdict,
        accepted=accepted,
    )


def _verdict(chi2: float, deviation: float, read_is_small: bool) -> tuple[str, bool]:
    small = "; read noise is below what these images resolve" if read_is_small else ""
    if chi2 <= SOUND_CHI2 or deviation <= SOUND_DEVIATION:
        return f"sound: variance and mean follow the model (χ² {chi2:.2g}, at most {deviation:.1%} off){small}", True
    if deviation <= POOR_DEVIATION:
        return f"usable: the variance differs from the model by up to {deviation:.0%} (χ² {chi2:.2g}){small}", True
    return (
        f"poor: the variance differs from the model by up to {deviation:.0%} (χ² {chi2:.2g}); "
        "something moved, the lamp flickers, or the images are not raw",
        False,
    )
