"""Standard deviations of a calibration against required limits and against those that the rig's axes allow.

A robot whose poses are uncertain by tenths of a millimetre limits the hand-eye transform however good the images are. So where axes take
part, each figure is stated twice: as it is, and as perfect images and exactly known cameras would leave it; what lies between both is ours.
What the noise of the images alone adds stands beside it: where the reference camera's axis points is known only together with its lens, and
that moves board and part alike.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.cameras.projector import HeadSolution
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.cameras.uncertainty import POSE_NAMES
from measureapp.calibrate.motions.chain import Chain
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.calibrate.motions.hand_eye import HandEyeSolution
from measureapp.calibrate.motions.linear_guide import GuideSolution
from measureapp.calibrate.motions.rotation_axis import AxisSolution
from measureapp.calibrate.motions.slide_noise import suppress_image_noise
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.data.uncertainty import UncertaintyMap

DEGREES = float(np.rad2deg(1.0))
# name -> unit and what is asked of it unless the user asks for something else
ASKED: Mapping[str, tuple[str, float]] = {
    "shape": ("mm", 0.005),
    "projector position": ("mm", 0.1),
    "projector rotation": ("°", 0.02),
    "hand-eye position": ("mm", 0.05),
    "hand-eye rotation": ("°", 0.005),
    "axis direction": ("°", 0.002),
    "axis position": ("mm", 0.005),
    "guide direction": ("°", 0.002),
    "guide scale": ("", 1e-5),
}
# labels of the joint solution's parameters, their factor
IN_RIG: Mapping[str, tuple[tuple[str, ...], float]] = {
    "hand-eye position": (("hand_eye.x_mm", "hand_eye.y_mm", "hand_eye.z_mm"), 1.0),
    "hand-eye rotation": (("hand_eye.rotation_x_rad", "hand_eye.rotation_y_rad", "hand_eye.rotation_z_rad"), DEGREES),
    "axis direction": (("axis.direction_1_rad", "axis.direction_2_rad"), DEGREES),
    "axis position": (("axis.point_1_mm", "axis.point_2_mm"), 1.0),
    "guide direction": (("guide.direction_1_rad", "guide.direction_2_rad"), DEGREES),
    "guide scale": (("guide.scale",), 1.0),
}
MAINLY = 0.7  # of what images and cameras add: half of its square
Asked = Mapping[str, float]  # name of a figure -> what the user asks instead of the usual


@dataclass(frozen=True, slots=True)
class Limit:
    """One figure of a calibration; standard deviations in the direction that is least certain."""

    name: str
    unit: str
    asked: float
    sigma: float
    axes_allow: float | None = None  # with perfect images and cameras; None where no axis takes part, or its part is in no figure
    given_cameras: float | None = None  # with exactly known cameras, where it makes a difference that is stated

    @property
    def beyond(self) -> float:
        """Contribution of images and cameras."""
        return self.sigma if self.axes_allow is None else float(np.sqrt(max(self.sigma**2 - self.axes_allow**2, 0.0)))

    @property
    def by_images(self) -> float | None:
        """Contribution of the image noise alone."""
        if self.given_cameras is None or self.axes_allow is None:
            return None
        return float(np.sqrt(max(self.given_cameras**2 - self.axes_allow**2, 0.0)))

    @property
    def limited_by(self) -> str:
        """What to do where mainly the noise of the images makes it more than requested; empty otherwise."""
        if self.met_beyond or self.by_images is None or self.by_images < MAINLY * self.beyond:
            return ""
        times = (self.by_images / self.asked) ** 2  # noise averages with the square root of the number of views
        return f"; the noise of the corners limits it: {max(times, 1.5):.2g} times as many views, or sharper and larger images of the board"

    @property
    def met(self) -> bool:
        """Whether the figure is within its limit."""
        return self.sigma <= self.asked

    @property
    def met_beyond(self) -> bool:
        """Whether the contribution of images and cameras is within the limit."""
        return self.beyond <= self.asked

    @property
    def sentence(self) -> str:
        """The figure, its limit and contributions in a sentence."""
        unit = f" {self.unit}" if self.unit == "mm" else self.unit
        verdict = "met" if self.met else "exceeded by the rig's axes alone" if self.met_beyond else "more than requested"
        start = f"{self.name} ± {self.sigma:.2g}{unit}, requested {self.asked:.2g}{unit}"
        if self.axes_allow is None:
            return f"{start}: {verdict}"
        alone = "" if self.by_images is None else f" (the images alone {self.by_images:.2g}{unit})"
        return (
            f"{start}; the rig's axes alone allow ± {self.axes_allow:.2g}{unit}, "
            f"images and cameras add {self.beyond:.2g}{unit}{alone}: {verdict}{self.limited_by}"
        )


def camera_limits(uncertainty: UncertaintyMap | None, asked: Asked) -> tuple[Limit, ...]:
    """Return the uncertainty of shape in the working volume; nothing without two cameras that see it."""
    if uncertainty is None or uncertainty.volume is None:
        return ()
    return (_limit("shape", asked, uncertainty.volume.shape_rms_mm),)


def projector_limits(head: HeadSolution, asked: Asked) -> tuple[Limit, ...]:
    """Return the figures of where the projector stands before the reference camera, with what the cameras leave uncertain where that is known."""
    solution = head.solution
    places = {label: index for index, label in enumerate(solution.parameters)}
    rows = [places[f"{PROJECTOR}.{name}"] for name in POSE_NAMES]
    return (
        _limit("projector position", asked, _worst(solution.covariance, rows[3:])),
        _limit("projector rotation", asked, _worst(solution.covariance, rows[:3]) * DEGREES),
    )


def axis_limits(solution: AxisSolution, asked: Asked) -> tuple[Limit, ...]:
    """Return the figures of an axis as the cameras see it, with no robot between."""
    axis = solution.best.axis
    return (
        _limit("axis direction", asked, axis.direction_sigma_rad * DEGREES),
        _limit("axis position", asked, axis.point_sigma_mm),
    )


def guide_limits(solution: GuideSolution, asked: Asked) -> tuple[Limit, ...]:
    """Return the figures of a guide as its residuals tell them; an error of robot and hand-eye that all positions share is in none."""
    guide = solution.guide
    return (
        _limit("guide direction", asked, guide.direction_sigma_rad * DEGREES),
        _limit("guide scale", asked, guide.scale_sigma),
    )


def hand_eye_limits(solution: HandEyeSolution, asked: Asked) -> tuple[Limit, ...]:
    """Return the figures of a hand-eye transform: as it is, and as the robot's own errors allow."""
    allowed = _axes_alone(solution.chain, solution.minimum.state)
    given = solution.minimum.covariance(max(solution.sigma_ratio**2, 1.0))
    return tuple(
        _limit(name, asked, *(_worst(covariance, rows) * factor for covariance in (solution.covariance, allowed, given)))
        for name, rows, factor in (("hand-eye position", [3, 4, 5], 1.0), ("hand-eye rotation", [0, 1, 2], DEGREES))
    )


def rig_limits(solution: RigSolution, asked: Asked) -> tuple[Limit, ...]:
    """Return every figure of the rig that was estimated: as it is, and as its own axes allow."""
    allowed = _axes_alone(solution.chain, solution.state)
    given = solution.joint_given_cameras
    places = {label: index for index, label in enumerate(solution.parameters)}
    return tuple(
        _limit(
            name,
            asked,
            _worst(solution.covariance, own) * factor,
            _worst(allowed, own) * factor,
            _worst(given, own) * factor,
        )
        for name, (labels, factor) in IN_RIG.items()
        if (own := [places[label] for label in labels if label in places])
    )


def _axes_alone(chain: Chain, state: ChainState) -> FloatArray:
    """Return the covariance that perfect images and exactly known cameras would leave; the slide is no straighter for them."""
    perfect = replace(chain, roots=suppress_image_noise(chain.roots, chain.slide), camera_jacobian=None, camera_covariance=None)
    return perfect.curvature(replace(state, camera_changes=np.zeros(0))).covariance()


def _limit(name: str, asked: Asked, sigma: float, axes_allow: float | None = None, given_cameras: float | None = None) -> Limit:
    unit, usual = ASKED[name]
    return Limit(name, unit, asked.get(name, usual), sigma, axes_allow, given_cameras)


def _worst(covariance: FloatArray, rows: list[int]) -> float:
    return float(np.sqrt(max(np.linalg.eigvalsh(covariance[np.ix_(rows, rows)])[-1], 0.0)))
