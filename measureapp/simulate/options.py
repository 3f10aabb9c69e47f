"""Settings of the simulated world; the defaults are the reference rig in a dim room."""

from __future__ import annotations

from pydantic import Field

from measureapp.data.model import Model
from measureapp.simulate.sensor import SensorSettings


class LightSettings(Model):
    """Light levels relative to full scale on a matt surface of albedo 1 facing the projector at standoff, at the reference exposure."""

    reference_exposure_us: int = Field(default=100_000, gt=0)
    projector: float = Field(default=1.4, ge=0, description="white level of the projector")
    ambient: float = Field(default=0.05, ge=0, description="ambient light")
    lamp: float = Field(default=0.85, ge=0, description="head lamp, on while no pattern is shown")
    gamma: float = Field(default=1.02, gt=0, description="response of the projector: light = level^gamma")
    black: float = Field(default=0.003, ge=0, lt=1, description="black level of the projector relative to white")
    defocus_px: float = Field(default=0.8, ge=0, description="blur of the projected image, standard deviation in projector pixels")
    lens_blur_px: float = Field(default=0.7, ge=0, lt=2, description="blur of the camera image, standard deviation in camera pixels")


class RigErrors(Model):
    """Deviations of the rig from its nominal description: rms translations and rotations."""

    camera_shift_mm: float = Field(default=1.0, ge=0)
    camera_turn_deg: float = Field(default=0.3, ge=0)
    hand_eye_shift_mm: float = Field(default=3.0, ge=0)
    hand_eye_turn_deg: float = Field(default=1.0, ge=0)
    table_shift_mm: float = Field(default=3.0, ge=0)
    table_tilt_deg: float = Field(default=0.2, ge=0)
    axes: bool = Field(default=True, description="False: robot, guide and table are perfect")


class WorldOptions(Model):
    """All settings of the simulated world."""

    light: LightSettings = LightSettings()
    sensor: SensorSettings = SensorSettings()
    errors: RigErrors = RigErrors()
    temperature_c: float = Field(default=21.0, description="of the room; the camera housings are warmer by self-heating")
    knocked_deg: dict[str, tuple[float, float, float]] = Field(
        default_factory=dict, description="cameras displaced after calibration: name -> rotation vector in the camera's own frame"
    )
    board_bow_mm: float = Field(default=0.02, description="height of the board's centre above its border")
