"""The rig that a prediction is made for: its description, its calibration, and how its clouds err."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty
from measureapp.data.calibration import RigCalibration
from measureapp.data.rig import RigDescription
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.settings import DecodeSettings


@dataclass(frozen=True, slots=True, eq=False)
class RigModel:
    """A calibrated rig, or a typical calibration of it."""

    description: RigDescription
    calibration: RigCalibration
    uncertainty: RigUncertainty | None  # None: the calibration states none
    source: str  # where the calibration is from, in words
    noise: Mapping[str, CameraNoise] = field(default_factory=dict)  # measured noise of cameras
    form_mm: float = 0.0  # standard deviation of the smooth errors of a cloud beyond noise and calibration

    @property
    def decode_settings(self) -> DecodeSettings:
        """The settings that images of this rig are decoded with."""
        return DecodeSettings(camera_noise=dict(self.noise))
