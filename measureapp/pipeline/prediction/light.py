"""Brightness of a part before it is seen, and the phase noise that follows from it."""

from __future__ import annotations

from dataclasses import dataclass
from math import tau

import numpy as np
from pydantic import Field

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.fringe import GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.model import Model
from measureapp.fringe.exposures.weights import exposure_weights
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.unwrap import plan_heterodyne

CLIP_SIGMAS = 2.0  # noise above the brightest step of a pixel that must stay below saturation
NOT_USED = -1


class PartLight(Model):
    """Assumed light of a matt part, relative to saturation.

    A matt surface that faces the projector at the standoff has the grey level `white` under white light at the plan's longest exposure. With the
    default it just saturates there, as a bracket is chosen; a scan of the part tells more (`light_of_views`).
    """

    white: float = Field(default=1.0, gt=0, le=100, description="grey level under white light at the longest exposure, over saturation")
    contrast: float = Field(
        default=0.95, gt=0, le=1, description="modulation of the fringes over their mean grey level, without ambient light"
    )
    ambient: float = Field(
        default=0.03, ge=0, le=1, description="grey level without the projector at the longest exposure, over saturation"
    )


@dataclass(frozen=True, slots=True, eq=False)
class PhaseNoise:
    """Phase noise of the pixels of a camera."""

    sigma_rad: FloatArray  # (N,), of the absolute phase of the finest pitch; inf where every exposure saturates
    exposure: IntArray  # (N,), longest unsaturated exposure; `NOT_USED` where there is none
    modulation: FloatArray  # (N,), at that exposure, over saturation
    of_all: FloatArray  # (N,), modulation of an image at that exposure that would be as exact as all exposures together, over saturation


@dataclass(frozen=True, slots=True)
class CameraExposures:
    """How a camera takes the fringes of one direction."""

    patterns: PatternSet  # the groups of this direction alone
    exposures_us: tuple[int, ...]  # long to short
    longest_us: int  # exposure that the grey levels refer to
    noise: CameraNoise
    saturation: float

    def phase_noise(self, mean: FloatArray, modulation: FloatArray) -> PhaseNoise:
        """Return the phase noise of pixels of ``mean`` and ``modulation`` (N,) at `longest_us`, over saturation.

        As decoding sums the unsaturated exposures: σ² = (2/N) Σ n² σ_I² / (Σ n B)² for each pitch, and pitches averaged by inverse variance.
        """
        shares = np.array(self.exposures_us, float) / self.longest_us
        least = DecodeSettings().min_modulation_grey(self.saturation)
        counts = np.array(exposure_weights(self.exposures_us, self.noise, self.saturation, least), float)
        sigma, chosen, of_all = np.full(len(mean), np.inf), np.full(len(mean), NOT_USED), np.zeros(len(mean))
        peak_grey = (mean + modulation) * self.saturation
        for first, share in enumerate(shares):
            peak = peak_grey * share
            fits = (chosen == NOT_USED) & (peak + CLIP_SIGMAS * np.sqrt(self.noise.variance(peak, self.saturation)) < self.saturation)
            rows = np.flatnonzero(fits)
            chosen[rows] = first
            grey = mean[rows, None] * self.saturation * shares[None, first:]
            variance = (counts[first:] ** 2 * self.noise.variance(grey, self.saturation)).sum(axis=1)
            signal = modulation[rows] * self.saturation * float((counts[first:] * shares[first:]).sum())
            sigma[rows] = self._pitch_factor * np.sqrt(variance) / np.maximum(signal, 1e-9)
            of_all[rows] = signal * np.sqrt(self.noise.variance(grey[:, 0], self.saturation) / variance) / self.saturation
        return PhaseNoise(sigma, chosen, np.where(chosen == NOT_USED, 0.0, modulation * shares[chosen]), of_all)

    def largest_sigma_rad(self, settings: DecodeSettings) -> float:
        """Return the noise of the averaged phase above which decoding finds a pixel too weak: too inexact, or no vote settles its order."""
        chain = None if any(isinstance(group, GrayCodeGroup) for group in self.patterns.groups) else plan_heterodyne(self.patterns)
        if chain is None or chain.amplification == 0:
            return settings.max_sigma_rad
        scales = self.patterns.finest_pitch_px / np.array(self.patterns.pitches_px)
        return min(settings.max_sigma_rad, chain.settled_sigma_rad(votes=settings.vote_radius > 0) / float(np.sqrt((scales**2).sum())))

    @property
    def _pitch_factor(self) -> float:
        """Noise of the averaged phase of the finest pitch, over noise-to-signal of one image."""
        groups = [group for group in self.patterns.groups if isinstance(group, PhaseShiftGroup)]
        information = sum((tau / group.pitch_px) ** 2 * group.steps / 2 for group in groups)
        return float(tau / self.patterns.finest_pitch_px / np.sqrt(information))
