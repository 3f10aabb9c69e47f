"""Rig descriptions: cameras, projector, axes and their limits, with nominal values as in the data sheets."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, field_validator, model_validator
from scipy.spatial.transform import Rotation

from measureapp.data.cell import CellDescription, NamedBox
from measureapp.data.model import Model
from measureapp.geometry.transform import RigidTransform

Vector = tuple[float, float, float]
Speed = Annotated[float, Field(gt=0)]
Share = Annotated[float, Field(gt=0, le=1)]
JointSpeeds = tuple[Speed, Speed, Speed, Speed, Speed, Speed]
Resolution = Literal["full", "half", "quarter"]
NAME = r"^[A-Za-z0-9_][A-Za-z0-9_.-]{0,63}$"
OTHER_DEVICES = ("projector", "robot", "guide", "table")
RECORDED = "recorded"  # driver of a rig that is a recording: there are no devices
BINNING: dict[Resolution, int] = {"full": 1, "half": 2, "quarter": 4}


class NominalPose(Model):
    """Nominal mounting pose: position and rotation (intrinsic x-y-z Euler angles)."""

    position_mm: Vector
    rotation_deg: Vector

    def transform(self, to_frame: str, from_frame: str) -> RigidTransform:
        """Return the pose as transform to_from."""
        rotation = Rotation.from_euler("XYZ", self.rotation_deg, degrees=True).as_matrix()
        return RigidTransform.from_parts(rotation, self.position_mm, to_frame, from_frame)


class CameraDescription(Model):
    """One camera of the head. Frame `head`: origin midway between the lower cameras, x to the right, y down, z forward."""

    name: str = Field(pattern=NAME, description="also a part of file names")
    model: str
    serial: str
    width_px: int = Field(gt=0)
    height_px: int = Field(gt=0)
    pixel_um: float = Field(gt=0)
    focal_mm: float = Field(gt=0)
    bit_depth: Literal[8, 10, 12, 16] = 8
    head_from_camera: NominalPose

    @property
    def focal_px(self) -> float:
        """Focal length in pixels."""
        return self.focal_mm * 1000.0 / self.pixel_um

    @property
    def saturation(self) -> int:
        """Grey level of a saturated pixel."""
        return int(2**self.bit_depth - 1)


class ProjectorDescription(Model):
    """The projector of the head."""

    name: str
    model: str
    width_px: int = Field(gt=0)
    height_px: int = Field(gt=0)
    focal_px: float = Field(gt=0)
    head_from_projector: NominalPose


class RobotDescription(Model):
    """The six-axis robot; its reach is the distance of the flange from the shoulder."""

    model: str
    model_file: str = Field(
        default="", description="kinematic model: a name in `resources/robots`, or the path of a TOML or URDF file; empty: reach only"
    )
    shoulder_mm: Vector
    min_reach_mm: float
    max_reach_mm: float
    repeatability_mm: float
    absolute_accuracy_mm: float
    absolute_accuracy_deg: float
    joint_speeds_deg_s: JointSpeeds | None = Field(
        default=None, description="largest speeds of the joints; none: those of the kinematic model"
    )
    speed_share: Share | None = Field(default=None, description="of the largest joint speeds, at which a scan drives; none: a usual one")
    speed_mm_s: Speed | None = Field(default=None, description="of the flange; none: a usual one, for arms without a kinematic model")
    speed_deg_s: Speed | None = Field(
        default=None, description="of the flange's reorientation; none: a usual one, for arms without a kinematic model"
    )
    ramp_s: float | None = Field(default=None, ge=0, le=60, description="to accelerate and brake; none: a usual one")
    thermal_drift_mm: float | None = Field(
        default=None, ge=0, description="displacement of the flange since the calibration by warming up, largest; none: not counted"
    )


class GuideDescription(Model):
    """The linear guide that moves the robot along +Y of the guide frame."""

    model: str
    limits_mm: tuple[float, float]
    repeatability_mm: float
    speed_mm_s: Speed | None = Field(default=None, description="at which a scan drives; none: a usual one")
    acceleration_mm_s2: Speed | None = Field(default=None, description="at which a scan drives; none: a usual one")
    straightness_mm: float | None = Field(default=None, ge=0, description="straightness error over the stroke, ±; none: a usual one")
    angular_error_arcsec: float | None = Field(default=None, ge=0, description="pitch, yaw and roll over the stroke, ±; none: usual ones")


class TableDescription(Model):
    """The rotary table under the part, with the nominal position of its top centre in the guide frame."""

    model: str
    diameter_mm: float
    limits_deg: tuple[float, float]
    accuracy_arcsec: float
    repeatability_arcsec: float
    centre_in_guide_mm: Vector
    speed_deg_s: Speed | None = Field(default=None, description="at which a scan drives; none: a usual one")
    acceleration_deg_s2: Speed | None = Field(default=None, description="at which a scan drives; none: a usual one")
    radial_error_mm: float | None = Field(
        default=None, ge=0, description="radial error motion, ± (ISO 230-7), without run-out; none: a usual one"
    )
    axial_error_mm: float | None = Field(default=None, ge=0, description="axial error motion, ±; none: a usual one")
    tilt_error_arcsec: float | None = Field(default=None, ge=0, description="tilt error motion (wobble), ±; none: a usual one")

    @property
    def is_described(self) -> bool:
        """Whether place and size of the table are known; those of a recorded rig often are not."""
        return self.diameter_mm > 0.0


class CalibrationRules(Model):
    """Validity limits of a calibration of this rig: age, temperature, traceable scale."""

    valid_days: float | None = Field(default=90.0, gt=0, description="validity after the date of the calibration; none: no expiry")
    largest_temperature_change_k: float = Field(default=3.0, gt=0, description="change of the head's temperature since the calibration")
    head_expansion_per_k: float = Field(default=23e-6, ge=0, description="thermal expansion of the head's frame; default: aluminium")
    scale_ppm: float = Field(
        default=0.0,
        ge=0,
        description="standard uncertainty of the scale, where the board states no class or certificate; 0: that of its class",
    )
    when_exceeded: Literal["warn", "refuse"] = Field(default="warn", description="refuse: no scan starts with an invalid calibration")


class DriverChoice(Model):
    """A table ``[devices.NAME]``: the plugin that drives one device, and its settings."""

    driver: str = Field(min_length=1, description="ID of the plugin")
    settings: dict[str, object] = Field(default_factory=dict)


class KeepOutBox(NamedBox):
    """A box in the guide frame that neither the measuring head nor a moving link of the robot may enter."""


class ParkPose(Model):
    """Where the axes rest between scans: base_from_flange, guide position and table angle."""

    position_mm: Vector
    quaternion_wxyz: tuple[float, float, float, float]
    guide_mm: float = 0.0
    table_deg: float = 0.0


class MotionRules(Model):
    """How the axes are moved and when a pose counts as reached."""

    position_tolerance_mm: float = Field(default=0.1, gt=0, description="largest difference of read-back and goal, robot and guide")
    angle_tolerance_deg: float = Field(default=0.05, gt=0, description="largest difference of read-back and goal, robot and table")
    settle_s: float = Field(default=0.0, ge=0, le=60, description="wait after the last axis has settled, before images are taken")
    move_timeout_s: float = Field(default=120.0, gt=0, description="longest duration of one move of one axis")
    clearance_mm: float = Field(default=15.0, ge=1, le=200, description="least distance that moving bodies keep from everything else")
    keep_out: tuple[KeepOutBox, ...] = ()
    park: ParkPose | None = None


class HeadRules(Model):
    """How patterns and cameras are synchronised."""

    sequence: Literal["software", "hardware"] = Field(
        default="software", description="software: the program shows a pattern, then triggers; hardware: the projector triggers the cameras"
    )


class RigDescription(Model):
    """Nominal description of all devices. The guide frame is the robot base at guide position 0: x towards the table, z up.

    Either ``driver`` names one plugin that drives the whole rig, or ``devices`` names one for each device: every camera by its name,
    "projector", "robot", "guide" and "table". Version 2 added the speeds of the axes; descriptions of version 1 are read as they are.
    """

    schema_version: Literal[2] = 2
    name: str = Field(min_length=1)
    driver: str = Field(default="", description="ID of the plugin that drives the whole rig")
    driver_settings: dict[str, object] = Field(default_factory=dict)
    devices: dict[str, DriverChoice] = Field(default_factory=dict)
    links: dict[str, dict[str, object]] = Field(default_factory=dict, description="what drivers share: a serial line, a login, a world")
    head: HeadRules = HeadRules()
    motion: MotionRules = MotionRules()
    cell: CellDescription = CellDescription()
    cameras: tuple[CameraDescription, ...] = Field(min_length=1)
    reference: str = Field(description="name of the reference camera")
    projector: ProjectorDescription
    robot: RobotDescription
    guide: GuideDescription
    table: TableDescription
    flange_from_head: NominalPose
    standoff_mm: float = Field(gt=0, le=100_000, description="distance of the measuring volume from the reference camera")
    exposures_us: tuple[Annotated[int, Field(gt=0)], ...] = Field(min_length=1, description="the exposure bracket, long to short")
    calibration_rules: CalibrationRules = CalibrationRules()

    @field_validator("schema_version", mode="before")
    @classmethod
    def _migrate(cls, value: object) -> object:
        return 2 if value == 1 else value  # speeds that are not stated are assumed, as version 1 did

    @model_validator(mode="after")
    def _has_drivers(self) -> RigDescription:
        names = [camera.name for camera in self.cameras]
        twice = {name for name in names if names.count(name) > 1 or name in OTHER_DEVICES}
        if twice:
            raise ValueError(f"the name {min(twice)!r} belongs to two devices")
        if self.reference not in names:
            raise ValueError(f"the reference camera {self.reference!r} is none of the cameras ({', '.join(names)})")
        if bool(self.driver) == bool(self.devices):
            raise ValueError("name either one driver for the whole rig, or a table [devices.NAME] for each device")
        if self.devices and set(self.devices) != {*names, *OTHER_DEVICES}:
            missing = [name for name in (*names, *OTHER_DEVICES) if name not in self.devices]
            strangers = sorted(set(self.devices) - {*names, *OTHER_DEVICES})
            raise ValueError(
                f"a table [devices.NAME] is missing for {', '.join(missing)}" if missing else f"the rig has no device {strangers[0]!r}"
            )
        return self

    @property
    def drivers(self) -> dict[str, str]:
        """The plugin of every device, by the device's name."""
        names = (*(camera.name for camera in self.cameras), *OTHER_DEVICES)
        return {name: self.driver or self.devices[name].driver for name in names}

    def camera(self, name: str) -> CameraDescription:
        """Return the camera called ``name``; raises KeyError."""
        return {camera.name: camera for camera in self.cameras}[name]

    def without_speeds(self) -> RigDescription:
        """Return this rig without what was stated about the speeds of its axes, which change no measurement."""
        robot = dict.fromkeys(("joint_speeds_deg_s", "speed_share", "speed_mm_s", "speed_deg_s", "ramp_s"))
        guide, table = dict.fromkeys(("speed_mm_s", "acceleration_mm_s2")), dict.fromkeys(("speed_deg_s", "acceleration_deg_s2"))
        return self.model_copy(
            update={
                "robot": self.robot.model_copy(update=robot),
                "guide": self.guide.model_copy(update=guide),
                "table": self.table.model_copy(update=table),
            }
        )

    def at_resolution(self, resolution: Resolution) -> RigDescription:
        """Return this rig with its cameras binned to ``resolution``."""
        factor = BINNING[resolution]
        cameras = tuple(
            camera.model_copy(
                update={
                    "width_px": camera.width_px // factor,
                    "height_px": camera.height_px // factor,
                    "pixel_um": camera.pixel_um * factor,
                }
            )
            for camera in self.cameras
        )
        return self.model_copy(update={"cameras": cameras})
