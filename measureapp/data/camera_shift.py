"""What the phases of a view say about cameras that turned since they were calibrated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, read_only


@dataclass(frozen=True, slots=True, eq=False)
class ShiftEvidence:
    """Normal equations of small turns of every camera, from how the phases of all cameras contradict each other; they add up over views.

    The unknowns are the rotation vectors ω of the cameras in their own frames, three for each in the order of ``cameras``.
    """

    cameras: tuple[str, ...]  # the reference first
    samples: int
    information: FloatArray  # (3 n, 3 n), JᵀWJ per rad²
    gradient: FloatArray  # (3 n,), JᵀWr per rad
    misfit: float  # rᵀWr
    freedom: int  # residuals that r holds
    image_px2: FloatArray  # (n, 3, 3): ωᵀ(…)ω is the mean square shift of a camera's image across the fringes
    depth_mm2: FloatArray  # (n, 3, 3): ωᵀ(…)ω is the mean square shift of the points along the reference camera's rays

    def __post_init__(self) -> None:
        count = len(self.cameras)
        object.__setattr__(self, "information", read_only(self.information, np.float64, (3 * count, 3 * count)))
        object.__setattr__(self, "gradient", read_only(self.gradient, np.float64, (3 * count,)))
        object.__setattr__(self, "image_px2", read_only(self.image_px2, np.float64, (count, 3, 3)))
        object.__setattr__(self, "depth_mm2", read_only(self.depth_mm2, np.float64, (count, 3, 3)))


def together(views: Sequence[ShiftEvidence]) -> ShiftEvidence:
    """Return the evidence of several views of the same cameras, at least one; the mean squares are weighted by their samples."""
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
