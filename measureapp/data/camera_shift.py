"""Evidence in the phase maps of a view for rotations of the cameras since their calibration."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, read_only


@dataclass(frozen=True, slots=True, eq=False)
class ShiftEvidence:
    """Normal equations for small rotations of every camera, from the phase inconsistencies between the cameras; additive over views.

    The unknowns are the rotation vectors ω of the cameras in their own frames, three for each in the order of ``cameras``.
    """

    cameras: tuple[str, ...]  # the reference first
    samples: int
    information: FloatArray  # (3 n, 3 n), JᵀWJ per rad²
    gradient: FloatArray  # (3 n,), JᵀWr per rad
    misfit: float  # rᵀWr
    freedom: int  # number of residuals in r
    image_px2: FloatArray  # (n, 3, 3): ωᵀ(…)ω is the mean square shift of a camera's image perpendicular to the fringes
    depth_mm2: FloatArray  # (n, 3, 3): ωᵀ(…)ω is the mean square shift of the points along the reference camera's rays

    def __post_init__(self) -> None:
        count = len(self.cameras)
        object.__setattr__(self, "information", read_only(self.information, np.float64, (3 * count, 3 * count)))
        object.__setattr__(self, "gradient", read_only(self.gradient, np.float64, (3 * count,)))
        object.__setattr__(self, "image_px2", read_only(self.image_px2, np.float64, (count, 3, 3)))
        object.__setattr__(self, "depth_mm2", read_only(self.depth_mm2, np.float64, (count, 3, 3)))


def sum_evidence(views: Sequence[ShiftEvidence]) -> ShiftEvidence:
    """Add the normal equations of one or more views of the same cameras; the mean squares are averaged, weighted by samples."""
    weights = np.array([view.samples for view in views], float) / sum(view.samples for view in views)

    def mean(name: str) -> FloatArray:
        return np.asarray(sum(weight * getattr(view, name) for weight, view in zip(weights, views, strict=True)))

    return ShiftEvidence(
        cameras=views[0].cameras,
        samples=sum(view.samples for view in views),
        information=np.sum([view.information for view in views], axis=0),
        gradient=np.sum([view.gradient for view in views], axis=0),
        misfit=sum(view.misfit for view in views),
        freedom=sum(view.freedom for view in views),
        image_px2=mean("image_px2"),
        depth_mm2=mean("depth_mm2"),
    )
