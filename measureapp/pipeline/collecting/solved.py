"""A solution of a collection, and how each observation fits it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.cameras.projector import HeadSolution
from measureapp.calibrate.motions.hand_eye import HandEyeSolution
from measureapp.calibrate.motions.linear_guide import GuideSolution
from measureapp.calibrate.motions.rotation_axis import AxisSolution
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.sightings import rms
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.collecting.observation import Observation

Solution = CameraArraySolution | HeadSolution | AxisSolution | HandEyeSolution | GuideSolution | RigSolution


@dataclass(frozen=True, slots=True, eq=False)
class Solved:
    """A solution and how the observations fit it."""

    solution: Solution
    of: tuple[str, ...]  # observations that entered
    used: tuple[str, ...]  # those that stayed, in the order of the solution's own arrays
    board: BoardDescription  # with its bow, where that was estimated
    cameras: CameraArrayCalibration  # known before, or calibrated here
    places: Mapping[str, RigidTransform]  # observation -> where the board was seen, camera_from_board in the reference camera's frame
    camera_solution: CameraArraySolution | None = None  # where cameras, or the projector as one of them, are part of the result
    residuals_px: Mapping[str, Mapping[str, float]] = field(default_factory=dict)  # observation -> camera -> rms
    residuals_mm: Mapping[str, float] = field(default_factory=dict)  # observation -> rms over the marks, where axes are calibrated
    sightings: int = 0  # of single cameras, in all observations that entered
    reasons: Mapping[str, str] = field(default_factory=dict)  # observation -> what was left out of it, and why

    @property
    def rejected(self) -> dict[str, str]:
        """Observations left out whole, with the reason."""
        return {name: self.reasons.get(name, "") for name in self.of if name not in self.used}

    def judged(self, observation: Observation) -> Observation:
        """Return an observation with how it fits."""
        name = observation.id
        return replace(
            observation,
            standing="used" if name in self.used else "rejected",
            reason=sentences(self.reasons.get(name, ""), observation.reason),
            residuals_px=self.residuals_px.get(name, {}),
            residual_mm=self.residuals_mm.get(name),
        )


def sentences(*parts: str) -> str:
    """Return what there is of several remarks as sentences one after the other."""
    whole = (part[0].upper() + part[1:] for part in parts if part)
    return " ".join(part if part.endswith(".") else f"{part}." for part in whole)


def misfit_px(
    place: RigidTransform, observation: Observation, cameras: CameraArrayCalibration, board: BoardDescription
) -> dict[str, float]:
    """Return camera -> rms distance between the marks it saw and where they would be with the board at ``place`` (camera_from_board)."""
    result = {}
    for name, found in observation.seen.items():
        camera = cameras.cameras[name]
        points = camera.reference_from_camera.inverse().apply(place.apply(board.marks_mm(found.ids)))
        result[name] = rms(camera.pinhole.project(points) - found.corners_px)
    return result


def misfit_mm(place: RigidTransform, seen: RigidTransform, board: BoardDescription) -> float:
    """Return the rms distance of the board's marks between ``place`` and where it was seen."""
    marks = board.corners_mm
    return rms(place.apply(marks) - seen.apply(marks))
