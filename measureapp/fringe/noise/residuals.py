"""What the residuals of N ≥ 4 steps say of the images they came from: noise of the camera, motion, and light that changed.

N steps leave N − 3 sums in which the fringes cancel whatever the phase. What is left is noise, which differs from pixel to pixel; what follows the
phase, as harmonics of a projector or a camera that is not linear, and is smooth; and what contradicts the model: a phase that
moved between the steps follows the sine and cosine of the fringes, light that changed follows the brightness.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from measureapp.arrays import FloatArray, ImageArray, IntArray
from measureapp.data.phase import StackEvidence
from measureapp.fringe.noise.model import QUANTISATION_VARIANCE, CameraNoise

SAMPLES = 6_000  # patches of an image
BINS, LEAST_OF_BIN = 12, 100
LEAST_FREEDOM = 1000  # degrees of freedom; fewer leave the assumed noise as it is
PRIOR_SPREAD = 2.0  # standard deviation of the assumed gain and floor, as a share of them
LEAST_SPREAD, LEAST_VARIANCE_SD = 0.1, 0.003  # of the variance of a bin, what the straight line leaves; grey levels²
LEAST_STEP = 0.1  # of the light, from one group of images to the next
CLEARLY = 5.0  # standard deviations of a coefficient
HARMONICS = (2, 3, 4)
PATCH = (
    np.outer([1.0, -2.0, 1.0], [1.0, -2.0, 1.0]) / 6
)  # weights of 3 x 3 pixels that leave noise its variance, and nothing that is smooth
NORMAL_MEDIAN = 0.4549  # of the square of a normal variable of variance 1
LEVEL, BRIGHTNESS, COSINE, SINE = range(4)  # regressors of what contradicts the model; those of the harmonics follow
MOTION_TO_PHASE = 1.5  # variance of the phase of N steps, times N, over that of their independent displacements


@dataclass(frozen=True, slots=True, eq=False)
class _Block:
    """The residuals of one group at one exposure."""

    exposure_us: float
    pixel: IntArray  # (n,) which samples are neither black nor saturated
    mean: FloatArray  # (n,) grey levels
    modulation: FloatArray  # (n,)
    noise: FloatArray  # (N - 3, n) residuals without what is smooth
    terms: FloatArray  # (4, N - 3) coefficients of LEVEL … SINE
    terms_sd: FloatArray  # (4,) their standard deviations
    typical: float  # median of the means, at which LEVEL is a change
    steps: int


class StackResiduals:
    """Collects the residuals of some pixels of one camera's images, exposure by exposure.

    Parameters
    ----------
    groups : first image and number of steps of every group of shifted sinusoids
    exposures_us : from long to short
    prior : noise that is assumed of the camera
    shape : (height, width) of the images
    """

    def __init__(
        self,
        groups: Sequence[tuple[int, int]],
        exposures_us: Sequence[float],
        saturation: float,
        prior: CameraNoise,
        shape: tuple[int, int],
    ) -> None:
        self._groups, self._exposures_us, self._saturation, self._prior = groups, exposures_us, saturation, prior
        self._every = max(1, int(np.sqrt(shape[0] * shape[1] / SAMPLES)))
        self._blocks: list[_Block] = []

    def add(self, exposure: int, images: ImageArray) -> None:
        """Take the samples of one exposure (P, H, W)."""
        for first, steps in self._groups:
            if steps < 4:
                continue
            shown = _patches(images[first : first + steps], self._every)
            block = _block(shown, self._saturation, float(self._exposures_us[exposure]))
            if block is not None:
                self._blocks.append(block)

    def noise(self) -> CameraNoise:
        """Return the noise of the camera by these images; that assumed where they do not determine it.

        The variance over the brightness is a straight line, photon transfer [1]_. Gain and floor of the assumed model enter as
        observations with a standard deviation of twice their value: few or evenly bright pixels leave them where they were.

        References
        ----------
        .. [1] J. R. Janesick, Photon Transfer, SPIE Press, 2007.
        """
        prior, saturation = self._prior, self._saturation
        if sum(block.noise.size for block in self._blocks) < LEAST_FREEDOM:
            return prior
        light, variance, spread = self._transfer()
        gain, floor = 1 / prior.electrons_per_grey(saturation), prior.floor_variance(saturation)
        rows = np.concatenate(
            [np.stack([light, np.ones_like(light)], axis=1) / spread[:, None], np.diag([1 / gain, 1 / floor]) / PRIOR_SPREAD]
        )
        aims = np.concatenate([variance / spread, np.full(2, 1 / PRIOR_SPREAD)])
        least = np.array([gain / 100, QUANTISATION_VARIANCE * prior.step_grey**2])
        found = np.linalg.lstsq(rows, aims, rcond=None)[0]
        for held in np.flatnonzero(found < least):  # no less than that: the other one alone explains what is measured
            found = least.copy()
            found[1 - held] = max(
                least[1 - held], float(np.linalg.lstsq(rows[:, [1 - held]], aims - rows[:, held] * least[held], rcond=None)[0][0])
            )
        slope, dark = found
        read = float(np.sqrt(dark - least[1]) / slope)
        return prior.model_copy(update={"full_well_e": float(saturation / slope), "read_noise_e": read})

    def _transfer(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return light, variance and its standard deviation of groups of equally bright pixels."""
        mean = np.concatenate([block.mean for block in self._blocks for _ in block.noise])
        square = np.concatenate([row**2 for block in self._blocks for row in block.noise]).astype(np.float64)
        edges = np.quantile(mean, np.linspace(0, 1, BINS + 1)[1:-1])
        number = np.searchsorted(edges, mean)
        chosen = [each for one in range(BINS) if len(each := np.flatnonzero(number == one)) >= LEAST_OF_BIN]
        variance = np.array([np.median(square[each]) / NORMAL_MEDIAN for each in chosen])  # edges are no noise, and rare
        light = np.maximum(np.array([mean[each].mean() for each in chosen]) - self._prior.black_grey, 0.0)
        counted = 1.65 * variance * np.sqrt(2 / np.array([len(each) for each in chosen]))  # of a median, over that of a mean
        return light, variance, np.hypot(np.hypot(counted, LEAST_SPREAD * variance), LEAST_VARIANCE_SD)

    def evidence(self, noise: CameraNoise, scatter: float) -> StackEvidence:
        """Return what the residuals say of the images; ``scatter`` is that of the phases over what ``noise`` predicts."""
        if not self._blocks:
            return StackEvidence(noise.full_well_e, noise.read_noise_e, False, scatter)
        light = [_light_rad(block) for block in self._blocks]
        motion = np.array([_motion_square(block) for block in self._blocks])
        step, after = max(_level_steps(self._blocks), key=lambda each: abs(each[0]), default=(0.0, 0))
        if abs(step) > LEAST_STEP:  # in the middle of a group of four it leaves no residual: half of it at most counts as noise
            light[after] = max(light[after], 0.5 * abs(step) * self._blocks[after].typical / _typical_modulation(self._blocks[after]))
        worst, count = int(np.argmax(light)), len(self._blocks)
        return StackEvidence(
            noise.full_well_e,
            noise.read_noise_e,
            noise != self._prior,
            scatter=scatter,
            vibration_rad=float(np.sqrt(motion.mean() / count)),
            light_rad=float(np.sqrt(np.square(light).sum()) / count),
            light_step=step,
            light_exposure_us=self._blocks[after if abs(step) > LEAST_STEP else worst].exposure_us,
        )


def _block(images: ImageArray, saturation: float, exposure_us: float) -> _Block | None:
    """Fit what the residuals of patches (N, 9, patches) follow; None where too few see light."""
    steps = len(images)
    pixel = np.flatnonzero((images.max(axis=(0, 1)) < saturation) & (images.min(axis=(0, 1)) > 0))
    if len(pixel) < LEAST_OF_BIN:
        return None
    patches = images[:, :, pixel].astype(np.float32)
    values = patches[:, 4]
    shifts = 2 * np.pi * np.arange(steps) / steps
    waves = np.stack([np.ones(steps), np.cos(shifts), np.sin(shifts)])
    basis = np.linalg.svd(waves)[2][3:].astype(np.float32)  # orthonormal, orthogonal to mean and fringes
    mean = values.mean(axis=0)
    typical = max(float(np.median(mean)), 1e-3)
    fringe = (np.exp(1j * shifts) @ values * (2 / steps)).astype(np.complex64)
    modulation = np.abs(fringe)
    unit = fringe / np.maximum(modulation, 1e-3)
    rows = [np.ones_like(mean), mean / typical - 1, fringe.real, fringe.imag]
    for order in HARMONICS:
        if order % steps not in (0, 1, steps - 1) and order % steps <= steps // 2:
            rows += [(modulation * unit**order).real, (modulation * unit**order).imag]
    design = np.stack(rows).astype(np.float32)
    residual = basis @ values
    square = (design @ design.T).astype(np.float64)
    inverse = np.linalg.pinv(square, rcond=1e-9, hermitian=True)  # evenly lit surfaces do not separate all of them
    terms = inverse @ (design @ residual.T).astype(np.float64)
    left = residual - terms.T.astype(np.float32) @ design
    sd = np.sqrt(np.diag(inverse) * (float(np.mean(left.astype(np.float64) ** 2)) + LEAST_VARIANCE_SD)) + 1e-9
    noise = basis @ np.tensordot(patches, PATCH.ravel().astype(np.float32), (1, 0))
    return _Block(exposure_us, pixel, mean, modulation, noise, terms[: SINE + 1], sd[: SINE + 1], typical, steps)


def _patches(images: ImageArray, every: int) -> ImageArray:
    """Return 3 x 3 pixels about every so many of images (N, H, W), (N, 9, patches)."""
    height, width = images.shape[1:]
    shown = [images[:, dy : height - 2 + dy : every, dx : width - 2 + dx : every] for dy in range(3) for dx in range(3)]
    return np.stack(shown, axis=1).reshape(len(images), 9, -1)


def _motion_square(block: _Block) -> float:
    """Return the phase variance of fringes that moved between the steps, rad²; 0 where no motion is clear, or changing light alone explains it."""
    waves = block.terms[[COSINE, SINE]]
    if np.abs(waves / block.terms_sd[[COSINE, SINE], None]).max() < CLEARLY:
        return 0.0
    freedom = block.terms.shape[1]
    own = float((block.terms_sd[[COSINE, SINE]] ** 2).sum())
    square = max(0.0, float((waves**2).sum() / freedom) - own - float(((block.terms[LEVEL] / block.typical) ** 2).sum() / freedom))
    return MOTION_TO_PHASE / block.steps * square


def _light_rad(block: _Block) -> float:
    """Return the phase noise of light that changed between the steps of a group, rad; 0 where no change is clear."""
    if np.abs(block.terms[LEVEL] / block.terms_sd[LEVEL]).max() < CLEARLY:
        return 0.0
    return float(np.sqrt(2 / block.steps * (block.terms[LEVEL] ** 2).mean())) / _typical_modulation(block)


def _typical_modulation(block: _Block) -> float:
    lit = block.modulation[block.modulation > 1]
    return float(np.median(lit)) if len(lit) else np.inf


def _level_steps(blocks: list[_Block]) -> list[tuple[float, int]]:
    """Return by which share the light of the room and the projector changed from one block to the next, and the number of that."""
    steps = []
    for number, (before, after) in enumerate(pairwise(blocks)):
        _, one, other = np.intersect1d(before.pixel, after.pixel, assume_unique=True, return_indices=True)
        lit = before.modulation[one] > 1
        if np.count_nonzero(lit) >= LEAST_OF_BIN:
            ratio = float(after.mean[other][lit].sum() / before.mean[one][lit].sum())
            steps.append((ratio * before.exposure_us / after.exposure_us - 1, number + 1))
    return steps
