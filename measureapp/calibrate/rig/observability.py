"""Observability: the weak directions of the normal matrix, named by their largest parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray

LEVER_MM = 550.0  # from the camera to the part: lever arm of an angle
STROKE_MM = 500.0  # what an error of scale amounts to over a usual travel of the guide
NULL_SHARE = 1e-12
NAMED_SHARE = 0.3  # of the largest component: parameters below it are not named
MOST_NAMED = 3
HARDLY_SEEN_MM = 1.0
WORDS = {
    "hand_eye.rotation_x_rad": "rotation of the camera about the flange's x",
    "hand_eye.rotation_y_rad": "rotation of the camera about the flange's y",
    "hand_eye.rotation_z_rad": "rotation of the camera about the flange's z",
    "hand_eye.x_mm": "place of the camera along the flange's x",
    "hand_eye.y_mm": "place of the camera along the flange's y",
    "hand_eye.z_mm": "place of the camera along the flange's z",
    "guide.direction_1_rad": "direction of the guide, first tilt",
    "guide.direction_2_rad": "direction of the guide, second tilt",
    "guide.scale": "scale of the guide",
    "axis.direction_1_rad": "direction of the rotation axis, first tilt",
    "axis.direction_2_rad": "direction of the rotation axis, second tilt",
    "axis.point_1_mm": "place of the rotation axis, first way across",
    "axis.point_2_mm": "place of the rotation axis, second way across",
    "board.rotation_x_rad": "rotation of the board about the guide frame's x",
    "board.rotation_y_rad": "rotation of the board about the guide frame's y (along the guide)",
    "board.rotation_z_rad": "rotation of the board about the guide frame's z",
    "board.x_mm": "place of the board along x",
    "board.y_mm": "place of the board along y (along the guide)",
    "board.z_mm": "place of the board along z",
}


@dataclass(frozen=True, slots=True, eq=False)
class WeakDirection:
    """A combination of parameters and how well it is known."""

    sigma_mm: float  # at the part; infinite where nothing shows it
    parameters: tuple[str, ...]  # the largest first
    components: tuple[float, ...]  # their components in the unit vector, in mm at the part

    @property
    def sentence(self) -> str:
        """The direction in words."""
        what = " together with ".join(WORDS.get(name, name) for name in self.parameters)
        if not np.isfinite(self.sigma_mm):
            return f"{what}: not observable from these poses"
        seen = "is hardly observable from these poses" if self.sigma_mm > HARDLY_SEEN_MM else "is the least certain"
        return f"{what}: {seen} (± {self.sigma_mm:.3g} mm at the part)"


def lengths_of(labels: Sequence[str]) -> FloatArray:
    """Return the displacement at the part by one unit of each parameter, mm."""
    return np.array([LEVER_MM if label.endswith("_rad") else STROKE_MM if label.endswith("scale") else 1.0 for label in labels])


def weakest(covariance: FloatArray, labels: Sequence[str], count: int = 3) -> tuple[WeakDirection, ...]:
    """Return the ``count`` least certain directions of the labelled parameters, the worst first."""
    lengths = lengths_of(labels)
    values, vectors = np.linalg.eigh(covariance * np.outer(lengths, lengths))
    order = np.argsort(values)[::-1][:count]
    return tuple(_describe(float(np.sqrt(max(values[index], 0.0))), vectors[:, index], labels) for index in order)


def unobservable(hessian: FloatArray, labels: Sequence[str]) -> tuple[WeakDirection, ...]:
    """Return the directions that change no residual: null vectors of the normal matrix, whose first rows are ``labels``."""
    lengths = np.concatenate([lengths_of(labels), np.ones(len(hessian) - len(labels))])
    scaled = hessian / np.outer(lengths, lengths)
    diagonal = np.sqrt(np.maximum(np.diag(scaled), 0.0))
    unit = np.where(diagonal > 0, diagonal, 1.0)
    values, vectors = np.linalg.eigh(scaled / np.outer(unit, unit))
    found = []
    for value, vector in zip(values, vectors.T, strict=True):
        if value <= NULL_SHARE * values[-1]:
            direction = (vector / unit)[: len(labels)]
            found.append(_describe(float("inf"), direction / max(float(np.linalg.norm(direction)), 1e-300), labels))
    return tuple(found)


def _describe(sigma_mm: float, vector: FloatArray, labels: Sequence[str]) -> WeakDirection:
    order = [int(index) for index in np.argsort(-np.abs(vector))[:MOST_NAMED] if abs(vector[index]) >= NAMED_SHARE * np.abs(vector).max()]
    return WeakDirection(sigma_mm, tuple(labels[index] for index in order), tuple(float(vector[index]) for index in order))
