"""Response of a projector to grey levels: as a curve, and as the harmonics of its sinusoids."""

from __future__ import annotations

import numpy as np
from pydantic import Field, model_validator

from measureapp.arrays import FloatArray
from measureapp.data.fringe import Direction, PatternSet, PhaseShiftGroup
from measureapp.data.model import Model
from measureapp.errors import DecodeError
from measureapp.fringe.patterns.harmonics import TABLE, Harmonic, PhaseCorrection, Waveform, phase_correction

TOP_LEVEL = 255.0
CURVE_POINTS = 52  # every fifth level
HIGHEST_OF_CURVE = 9  # order of the harmonics derived from a curve
END_LEVELS = 10.0  # a ramp has to come this close to both ends
LEAST_RAMP = 5
LEAST_CONTRAST = 10.0  # grey levels between the ends of a ramp
FLAT = 0.002  # of the ramp; its last three levels must differ by more


class PitchWaveform(Model):
    """The waveform that a camera recorded of one pitch."""

    direction: Direction = "vertical"
    pitch_px: float = Field(gt=2)
    harmonics: tuple[Harmonic, ...] = ()


class ProjectorResponse(Model):
    """Response of a projector to grey levels: the curve corrects patterns before they are shown, the harmonics phases afterwards."""

    name: str = "projector"
    curve: tuple[tuple[float, float], ...] | None = Field(
        default=None, description="(level 0…255, light as a share of its range), both ascending; absent where only phases were recorded"
    )
    waveforms: tuple[PitchWaveform, ...] = ()

    @model_validator(mode="after")
    def _ascends(self) -> ProjectorResponse:
        if self.curve is None:
            if not self.waveforms:
                raise ValueError("give a curve or waveforms")
            return self
        levels, light = np.array(self.curve).T
        ends = len(levels) >= 2 and levels[0] == 0 and levels[-1] == TOP_LEVEL and abs(light[0]) < 1e-6 and abs(light[-1] - 1) < 1e-6
        if not ends or np.any(np.diff(levels) <= 0) or np.any(np.diff(light) <= 0):
            raise ValueError("the curve must ascend from (0, 0) to (255, 1)")
        return self

    @property
    def gamma(self) -> float | None:
        """The exponent of the power law closest to the curve; None without a curve."""
        from scipy.optimize import minimize_scalar

        if self.curve is None:
            return None
        levels, light = np.array(self.curve).T
        share = levels / TOP_LEVEL
        return float(minimize_scalar(lambda gamma: float(np.sum((share**gamma - light) ** 2)), bounds=(0.2, 5.0), method="bounded").x)

    def level_for(self, light: FloatArray) -> FloatArray:
        """Return the levels 0…255 that make the projector give shares of its range of light; raises DecodeError without a curve."""
        if self.curve is None:
            raise DecodeError(
                f"The response of {self.name!r} has no curve, so patterns cannot be corrected beforehand.",
                "Estimate it from a grey ramp, or from six or more steps of one pitch.",
            )
        levels, shares = np.array(self.curve).T
        return np.asarray(np.interp(light, shares, levels))

    def waveform(self, pitch_px: float, direction: Direction) -> Waveform:
        """Return the waveform recorded at the nearest pitch (of this direction, if there is one), otherwise that of the curve."""
        if self.waveforms:
            same = [each for each in self.waveforms if each.direction == direction] or list(self.waveforms)
            return min(same, key=lambda each: abs(np.log(each.pitch_px / pitch_px))).harmonics
        assert self.curve is not None
        levels, shares = np.array(self.curve).T
        return _waveform_of_curve(levels, shares)

    def phase_correction(self, patterns: PatternSet) -> tuple[PhaseCorrection, ...]:
        """Return the correction of each phase-shift group's wrapped phases, in the order of the groups.

        Raises
        ------
        DecodeError
            The harmonics are so strong that so few steps do not determine the phase.
        """
        groups = [group for group in patterns.groups if isinstance(group, PhaseShiftGroup)]
        return tuple(phase_correction(self.waveform(group.pitch_px, group.direction), group.steps) for group in groups)


def response_of_ramp(levels: FloatArray, grey: FloatArray, name: str = "projector") -> ProjectorResponse:
    """Estimate the curve from a grey ramp: the levels shown and the mean grey a linear camera measured of each.

    The curve is the monotone one closest to the measured means, scaled to the range between the ends.

    Raises
    ------
    DecodeError
        Too few levels, ends missing, a camera that saturates, or a ramp that does not rise.
    """
    order = np.argsort(levels, kind="stable")
    levels, grey = np.asarray(levels, float)[order], np.asarray(grey, float)[order]
    _check_ramp(levels, grey)
    return ProjectorResponse(name=name, curve=_curve(levels, grey))


def curve_of_waveform(waveform: Waveform) -> tuple[tuple[float, float], ...]:
    """Return the curve that turns a cosine of levels into this waveform.

    With level = 127.5 (1 + cos φ), cos kφ is the Chebyshev polynomial T_k of level / 127.5 − 1, so the shares of the harmonics
    are the coefficients of the curve. A lens that blurs fringes weakens high harmonics: coarse pitches are the most informative.
    """
    coefficients = np.zeros(1 + max([1, *(harmonic.order for harmonic in waveform)]))
    coefficients[1] = 1.0
    for harmonic in waveform:
        coefficients[harmonic.order] = harmonic.share * np.cos(harmonic.phase_rad)
    levels = np.linspace(0, TOP_LEVEL, CURVE_POINTS)
    return _curve(levels, np.polynomial.chebyshev.chebval(2 * levels / TOP_LEVEL - 1, coefficients))


def _waveform_of_curve(levels: FloatArray, shares: FloatArray) -> Waveform:
    phase = np.arange(TABLE) * (2 * np.pi / TABLE)
    series = np.fft.rfft(np.interp(TOP_LEVEL / 2 * (1 + np.cos(phase)), levels, shares))
    relative = series[2 : HIGHEST_OF_CURVE + 1] / series[1]
    return tuple(
        Harmonic(order=order, share=min(1.0, float(abs(term))), phase_rad=float(np.angle(term))) for order, term in enumerate(relative, 2)
    )


def _check_ramp(levels: FloatArray, grey: FloatArray) -> None:
    if len(levels) < LEAST_RAMP or np.any(np.diff(levels) <= 0):
        raise DecodeError(
            f"The grey ramp has {len(np.unique(levels))} different levels among {len(levels)}.", "Give each of at least five levels once."
        )
    if levels[0] < 0 or levels[-1] > TOP_LEVEL or levels[0] > END_LEVELS or levels[-1] < TOP_LEVEL - END_LEVELS:
        raise DecodeError(f"The grey ramp covers the levels {levels[0]:g}…{levels[-1]:g} of 0…255.", "Show the ramp from black to white.")
    if grey[-1] - grey[0] < LEAST_CONTRAST:
        raise DecodeError(
            f"The grey ramp rises by {grey[-1] - grey[0]:.1f} grey levels only.", "Expose longer, or turn the ambient light off."
        )
    if np.ptp(grey[-3:]) < FLAT * (grey[-1] - grey[0]):
        raise DecodeError("The grey ramp ends in equal levels: the camera or the projector saturates.", "Expose shorter.")


def _curve(levels: FloatArray, light: FloatArray) -> tuple[tuple[float, float], ...]:
    """Return the strictly ascending curve from (0, 0) to (255, 1) closest to measured light."""
    from scipy.optimize import isotonic_regression

    rising = isotonic_regression(light).x
    levels = np.concatenate([[0.0], levels[1:-1], [TOP_LEVEL]])
    share = (rising - rising[0]) / (rising[-1] - rising[0])
    # equal neighbours are separated by less than an 8-bit projector resolves
    share = np.maximum.accumulate(share) + np.arange(len(share)) * 1e-9
    share = (share - share[0]) / (share[-1] - share[0])
    return tuple((float(level), float(value)) for level, value in zip(levels, share, strict=True))
