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
    axes: bool = Field(default=True, description="no: robot, guide and table are perfect")


class SensorEffects(Model):
    """What the pixels of a camera do beside noise."""

    gain_spread: float = Field(
        default=0.0, ge=0, lt=0.2, description="photo response non-uniformity, relative standard deviation (EMVA 1288)"
    )
    dark_spread_e: float = Field(default=0.0, ge=0, description="dark signal non-uniformity in electrons, standard deviation (EMVA 1288)")
    curvature: float = Field(default=0.0, ge=0, lt=0.2, description="largest deviation of the response from a straight line, of full scale")
    hot_ppm: float = Field(default=0.0, ge=0, lt=1e5, description="pixels per million with a high dark signal, up to full scale")


class LensEffects(Model):
    """What camera lenses do beyond a pinhole with radial and tangential distortion and one blur."""

    residual_px: float = Field(default=0.0, ge=0, description="distortion that the lens model lacks, rms per axis at full resolution")
    glare: float = Field(default=0.0, ge=0, lt=1, description="share of the light that is scattered over the image")
    corner_blur_px: float = Field(default=0.0, ge=0, description="additional blur in the corners, standard deviation at full resolution")
    defocus_px: float = Field(default=0.0, ge=0, description="additional blur 100 mm from the plane in focus, likewise")
    part_blur_px: float = Field(default=0.0, ge=0, description="additional blur of the part, not of the board, likewise")
    coma_px: float = Field(
        default=0.0, ge=0, description="displacement at the image's edge 80 mm from focus, against which no distortion at one depth helps"
    )


class ProjectorEffects(Model):
    """What a projector does beside its response curve and blur."""

    level_spread: float = Field(default=0.0, ge=0, description="light from one image to the next, relative standard deviation")
    vignetting: float = Field(default=0.0, ge=0, lt=1, description="loss of light in the corners")
    drift_px: float = Field(default=0.0, ge=0, description="displacement of the image until the projector is warm, at full resolution")
    bit_planes: float = Field(
        default=0.0, ge=0, le=1, description="1: frames exposed in part show their most significant bit planes only; 0: all levels are even"
    )
    frame_us: int = Field(default=16_667, gt=0, description="duration of a frame of the projector")
    shake_px: float = Field(
        default=0.0, ge=0, description="vibration: displacement of each image across the fringes, standard deviation at full resolution"
    )


class TimingEffects(Model):
    """Exposures that reach into the next image of a sequence."""

    rolling_share: float = Field(
        default=0.0, ge=0, lt=1, description="share of the exposure that falls on the next image, in the last row of a rolling shutter"
    )
    late_us: float = Field(default=0.0, ge=0, description="delay of each camera's trigger, standard deviation; never early")


class AxisEffects(Model):
    """Error motions of table and guide, and what warmth does to the robot."""

    table_radial_mm: float = Field(default=0.0, ge=0, description="radial error motion of the table, half its range")
    table_axial_mm: float = Field(default=0.0, ge=0, description="axial error motion of the table, half its range")
    table_tilt_arcsec: float = Field(default=0.0, ge=0, description="tilt error motion of the table, half its range")
    guide_angle_arcsec: float = Field(default=0.0, ge=0, description="pitch, yaw and roll of the slide, half their range over the stroke")
    guide_straightness_mm: float = Field(default=0.0, ge=0, description="further straightness error of the guide, half its range")
    robot_growth_mm: float = Field(default=0.0, ge=0, description="displacement of the flange until the robot is warm")
    table_backlash_arcsec: float = Field(default=0.0, ge=0, description="play of the table between both directions of turning")
    guide_backlash_mm: float = Field(default=0.0, ge=0, description="play of the slide between both directions of travel")
    robot_backlash_mm: float = Field(default=0.0, ge=0, description="play of the flange along each axis between both directions of travel")
    settling_mm: float = Field(default=0.0, ge=0, description="creep of the flange after every move, in a random direction")
    settling_s: float = Field(default=5.0, gt=0, description="time constant of this creep")


class WarmthEffects(Model):
    """Temperatures that change or that differ from the room's, with expansion of steel where no other is stated."""

    camera_drift_px: float = Field(
        default=0.0, ge=0, description="displacement of the principal point until the cameras are warm, full resolution"
    )
    focal_drift: float = Field(default=0.0, ge=0, description="relative change of the focal length until the cameras are warm")
    minutes: float = Field(default=60.0, gt=0, description="time constant of warming up")
    warm_share: float = Field(default=0.0, ge=0, le=1, description="share of the way to the warm state when the world begins")
    seconds_per_image: float = Field(default=0.3, gt=0, description="by which the clock of the warm-up moves with every image of the head")
    part_excess_k: float = Field(default=0.0, ge=0, description="by how much the part is warmer than 20 °C; expansion 11.5 ppm/K")
    board_excess_k: float = Field(default=0.0, ge=0, description="by how much the board is warmer than 20 °C; expansion 9 ppm/K")


class BoardEffects(Model):
    """Errors of the print of a calibration board beside its bow."""

    scale_ppm: float = Field(default=0.0, ge=0, description="error of scale, drawn for x and y with half of it in common")
    local_mm: float = Field(default=0.0, ge=0, description="local displacements of the print, rms per axis")


class PartEffects(Model):
    """How a part differs from its drawing, and what light does on and under its surface."""

    form_mm: float = Field(default=0.0, ge=0, description="smooth deviation of the surface from its nominal, rms along the normal")
    penetration_mm: float = Field(default=0.0, ge=0, description="mean depth at which light is scattered back below the surface")
    bounce: float = Field(default=0.0, ge=0, le=2, description="strength of light reflected once between surfaces; 1: as the albedo has it")
    fixture: bool = Field(default=False, description="the table's top and three clamps are in the picture")


class WorldOptions(Model):
    """All settings of the simulated world; without its effects it is the rig that the program's model describes exactly."""

    light: LightSettings = LightSettings()
    sensor: SensorSettings = SensorSettings()
    errors: RigErrors = RigErrors()
    temperature_c: float = Field(default=21.0, description="of the room; the camera housings are warmer by self-heating")
    knocked_deg: dict[str, tuple[float, float, float]] = Field(
        default_factory=dict, description="cameras displaced after calibration: name and rotation vector in the camera's own frame"
    )
    board_bow_mm: float = Field(default=0.02, description="height of the board's centre above its border")
    ambient_flicker: float = Field(
        default=0.0, ge=0, lt=1, description="change of the ambient light from image to image, standard deviation"
    )
    pixels: SensorEffects = SensorEffects()
    lenses: LensEffects = LensEffects()
    projector: ProjectorEffects = ProjectorEffects()
    timing: TimingEffects = TimingEffects()
    motions: AxisEffects = AxisEffects()
    warmth: WarmthEffects = WarmthEffects()
    board: BoardEffects = BoardEffects()
    part: PartEffects = PartEffects()
