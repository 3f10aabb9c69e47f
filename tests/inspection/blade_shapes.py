"""Blades of known form: round-edged ones that are the envelope of circles about an arc, and NACA four-digit profiles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

SAMPLES = 20_001


@dataclass(frozen=True)
class RoundBlade:
    """Circles whose radius runs from the leading to the trailing one with a hump between; their centres on an arc of given rise."""

    span_mm: float = 58.0  # between the centres of the edges
    leading_mm: float = 1.2
    trailing_mm: float = 0.6
    hump_mm: float = 2.1
    rise_mm: float = 6.0

    def _radii(self, s: np.ndarray) -> np.ndarray:
        return self.leading_mm + (self.trailing_mm - self.leading_mm) * s + self.hump_mm * np.sin(np.pi * s) ** 2

    def _arc(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
        """Centres, unit tangents, and arc length over s."""
        bend = (self.span_mm**2 / 4 + self.rise_mm**2) / (2 * self.rise_mm)
        half = np.arcsin(self.span_mm / 2 / bend)
        angle = half - 2 * half * s
        centres = np.array([self.span_mm / 2, self.rise_mm - bend]) + bend * np.column_stack([-np.sin(angle), np.cos(angle)])
        return centres, np.column_stack([np.cos(angle), np.sin(angle)]), 2 * half * bend

    @property
    def thickness_mm(self) -> float:
        """Diameter of the greatest circle."""
        return float(2 * self._radii(np.linspace(0, 1, SAMPLES)).max())

    @property
    def ends_mm(self) -> np.ndarray:
        """Outermost points of both edges along the mean line (2, 2), leading first."""
        centres, tangents, _ = self._arc(np.array([0.0, 1.0]))
        return np.stack([centres[0] - self.leading_mm * tangents[0], centres[1] + self.trailing_mm * tangents[1]])

    @property
    def chord_mm(self) -> float:
        return float(np.linalg.norm(self.ends_mm[1] - self.ends_mm[0]))

    @property
    def camber_mm(self) -> float:
        """Greatest distance of the mean line from the chord."""
        chord = (self.ends_mm[1] - self.ends_mm[0]) / self.chord_mm
        offset = self._arc(np.linspace(0, 1, SAMPLES))[0] - self.ends_mm[0]
        return float(np.abs(offset @ [-chord[1], chord[0]]).max())

    def contour(self) -> np.ndarray:
        """The closed outline (K, 2), the leading edge first at the origin, the chord along x."""
        s = np.linspace(0, 1, SAMPLES)
        centres, along, length = self._arc(s)
        across, radii = np.column_stack([-along[:, 1], along[:, 0]]), self._radii(s)
        slope = np.gradient(radii, s) / length
        sides = [
            centres - (radii * slope)[:, None] * along + sign * (radii * np.sqrt(1 - slope**2))[:, None] * across for sign in (1.0, -1.0)
        ]
        turn = np.linspace(-np.pi / 2, np.pi / 2, 2001)[:, None]
        nose = centres[0] + radii[0] * (-np.cos(turn) * along[0] - np.sin(turn) * across[0])
        tail = centres[-1] + radii[-1] * (np.cos(turn) * along[-1] + np.sin(turn) * across[-1])
        outline = np.vstack([sides[0][::-1], nose, sides[1], tail])
        chord = (self.ends_mm[1] - self.ends_mm[0]) / self.chord_mm
        return (outline - self.ends_mm[0]) @ np.stack([chord, [-chord[1], chord[0]]]).T


def naca(chord_mm: float, thickness: float, camber: float, place: float) -> np.ndarray:
    """The outline of a NACA four-digit profile (NACA Report 824); lengths in chords but for the chord."""
    x = (1 - np.cos(np.linspace(0, np.pi, SAMPLES))) / 2
    half = 5 * thickness * (0.2969 * np.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
    front = x < place
    rise = np.where(front, camber / place**2 * (2 * place * x - x * x), camber / (1 - place) ** 2 * (1 - 2 * place + 2 * place * x - x * x))
    slope = np.where(front, 2 * camber / place**2 * (place - x), 2 * camber / (1 - place) ** 2 * (place - x))
    across = np.column_stack([-slope, np.ones_like(slope)]) / np.sqrt(1 + slope**2)[:, None]
    middle = np.column_stack([x, rise])
    return chord_mm * np.vstack([(middle + half[:, None] * across)[::-1], (middle - half[:, None] * across)[1:]])


def scattered(outline: np.ndarray, count: int, noise_mm: float, rng: np.random.Generator) -> np.ndarray:
    """Points (N, 2) spread evenly along an outline, with noise."""
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(outline, axis=0), axis=1))])
    at = rng.uniform(0, length[-1], count)
    return np.column_stack([np.interp(at, length, outline[:, k]) for k in (0, 1)]) + noise_mm * rng.standard_normal((count, 2))
