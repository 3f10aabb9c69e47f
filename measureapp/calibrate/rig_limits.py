"""How the uncertainty of a calibrated rig compares with what is asked, and with what its own axes allow.

A robot whose poses are uncertain by tenths of a millimetre limits the hand-eye transform however good the images are. So each figure is
stated twice: as it is, and as perfect images and exactly known cameras would leave it; what lies between both is ours. The slide's own
straightness counts with the images, in whose covariance the joint calibration has it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.joint_solution import RigSolution

PERFECT = 100.0  # times the information of the images; their part of the covariance falls by its square


@dataclass(frozen=True, slots=True)
class RigLimit:
    """One figure of a calibrated rig; standard deviations in the direction that is least certain."""

    name: str
    unit: str
    asked: float
    sigma: float
    axes_allow: float  # with perfect images and cameras

    @property
    def beyond(self) -> float:
        """What images and cameras add."""
        return float(np.sqrt(max(self.sigma**2 - self.axes_allow**2, 0.0)))

    @property
    def met(self) -> bool:
        """Whether the figure as it is stays within what is asked."""
        return self.sigma <= self.asked

    @property
    def met_beyond(self) -> bool:
        """Whether what images and cameras add stays within what is asked."""
        return self.beyond <= self.asked

    @property
    def sentence(self) -> str:
        """Both in words."""
        unit = f" {self.unit}" if self.unit == "mm" else self.unit
        verdict = "as asked" if self.met else "as asked but for the rig's axes" if self.met_beyond else "more than asked"
        return (
            f"{self.name} ± {self.sigma:.2g}{unit}, asked {self.asked:.2g}{unit}; the rig's axes alone allow ± {self.axes_allow:.2g}{unit}, "
            f"images and cameras add {self.beyond:.2g}{unit}: {verdict}"
        )


DEGREES = float(np.rad2deg(1.0))
# name, unit, asked, labels of the parameters, their factor
ASKED = (
    ("hand-eye position", "mm", 0.05, ("hand_eye.x_mm", "hand_eye.y_mm", "hand_eye.z_mm"), 1.0),
    (
        "hand-eye rotation",
        "°",
        0.005,
        ("hand_eye.rotation_x_rad", "hand_eye.rotation_y_rad", "hand_eye.rotation_z_rad"),
        DEGREES,
    ),
    ("axis direction", "°", 0.002, ("axis.direction_1_rad", "axis.direction_2_rad"), DEGREES),
    ("axis position", "mm", 0.005, ("axis.point_1_mm", "axis.point_2_mm"), 1.0),
    ("guide direction", "°", 0.002, ("guide.direction_1_rad", "guide.direction_2_rad"), DEGREES),
    ("guide scale", "", 1e-5, ("guide.scale",), 1.0),
)


def rig_limits(solution: RigSolution) -> tuple[RigLimit, ...]:
    """Return every figure of the rig that was estimated: as it is, and as its own axes allow."""
    perfect = replace(solution.chain, roots=solution.chain.roots * PERFECT, by_cameras=None, camera_covariance=None)
    state = replace(solution.state, camera_changes=np.zeros(0))
    count = len(solution.parameters)
    allowed = perfect.curvature(state).covariance()[:count, :count]
    places = {label: index for index, label in enumerate(solution.parameters)}
    return tuple(
        RigLimit(name, unit, asked, _worst(solution.covariance, own) * factor, _worst(allowed, own) * factor)
        for name, unit, asked, labels, factor in ASKED
        if (own := [places[label] for label in labels if label in places])
    )


def _worst(covariance: FloatArray, rows: list[int]) -> float:
    return float(np.sqrt(max(np.linalg.eigvalsh(covariance[np.ix_(rows, rows)])[-1], 0.0)))
