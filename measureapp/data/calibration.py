"""Results of calibrations: immutable solutions of the rig's geometry with their standard deviations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.data.axis_motions import AxisMotions
from measureapp.data.certificate import BoardLengths
from measureapp.data.conditions import LensSetting
from measureapp.data.fringe import AxisReadback
from measureapp.errors import CalibrationError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about

NO_VARIANCE = 1e-12  # eigenvalue relative to the largest, below which it is rounding
SAME_STATION_MM, SAME_STATION_RAD = 0.01, 2e-5


@dataclass(frozen=True, slots=True)
class Provenance:
    """Provenance of a calibration: date, method, inputs and conditions."""

    created: str = ""  # ISO 8601
    method: str = ""
    inputs: Mapping[str, str] = field(default_factory=dict)  # file or image -> checksum, device -> serial number
    temperature_c: float | None = None  # of the room or the head, if it was measured
    valid_days: float | None = None  # after `created`; None: no expiry date
    arguments: tuple[str, ...] = ()  # of the command that made it, if any
    folder: str = ""  # working folder of that command, relative to the calibration's folder; `inputs` are relative to it


@dataclass(frozen=True, slots=True, eq=False)
class CameraCalibration:
    """Intrinsics and pose of one camera; `reference_from_camera` maps its frame (named after it) to the reference camera's ("camera")."""

    name: str
    pinhole: PinholeCamera
    reference_from_camera: RigidTransform
    standard_deviations: Mapping[str, float] = field(default_factory=dict)
    rms_px: float = 0.0
    serial: str = ""
    lens: LensSetting = field(default_factory=LensSetting)  # during the calibration, if the camera reports it
    blur_px: float = 0.0  # standard deviation of the image blur, from the edges of the board; 0 if unknown


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorCalibration:
    """The projector as an inverse camera: pixel (0, 0) of its image is the centre of the top-left projector pixel.

    `reference_from_projector` maps the projector's frame (named after it) to the reference camera's ("camera").
    """

    pinhole: PinholeCamera
    reference_from_projector: RigidTransform
    name: str = "projector"
    standard_deviations: Mapping[str, float] = field(default_factory=dict)
    provenance: Provenance = field(default_factory=Provenance)
    rms_px: float = 0.0  # reprojection error of the marks, in projector pixels; 0 if not stated


@dataclass(frozen=True, slots=True, eq=False)
class LabelledCovariance:
    """Covariance matrix of calibration parameters with a label per row: "left.fx", …, "right.x_mm", …; lengths in mm, angles in rad."""

    parameters: tuple[str, ...]
    covariance: FloatArray  # (C, C), symmetric

    def __post_init__(self) -> None:
        object.__setattr__(self, "covariance", read_only(self.covariance, np.float64, (len(self.parameters),) * 2))

    @property
    def root(self) -> FloatArray:
        """Square root (C, K) of the covariance, S with S Sᵀ = C: each column is an independent one-σ change of the parameters."""
        scale = np.sqrt(np.maximum(np.diag(self.covariance), 0))
        scale = np.where(scale > 0, scale, 1.0)
        values, vectors = np.linalg.eigh(self.covariance / np.outer(scale, scale))
        kept = values > NO_VARIANCE * max(float(values[-1]), 0.0)
        return np.asarray(scale[:, None] * vectors[:, kept] * np.sqrt(values[kept]))

    def rows_of(self, labels: Sequence[str]) -> FloatArray:
        """Return the covariance (L, L) of the parameters ``labels``, in this order; zero for unknown ones."""
        place = {label: index for index, label in enumerate(self.parameters)}
        there = [index for index, label in enumerate(labels) if label in place]
        chosen = [place[labels[index]] for index in there]
        result = np.zeros((len(labels), len(labels)))
        result[np.ix_(there, there)] = self.covariance[np.ix_(chosen, chosen)]
        return result


@dataclass(frozen=True, slots=True, eq=False)
class CameraArrayCalibration:
    """All cameras of the head, and its projector if it is calibrated, in the reference camera's frame `camera`."""

    reference: str
    cameras: Mapping[str, CameraCalibration]
    pair_rms_px: Mapping[str, float] = field(default_factory=dict)  # "left-right" -> rms
    provenance: Provenance = field(default_factory=Provenance)
    projector: ProjectorCalibration | None = None
    covariance: LabelledCovariance | None = None  # of cameras and projector; None if unknown
    lengths: BoardLengths | None = None  # of the board that gave the scale; None: nobody stated them
    marks_rms_mm: float = 0.0  # displacement of the board's marks, where it was estimated with the cameras

    def __post_init__(self) -> None:
        if self.reference not in self.cameras:
            raise CalibrationError(
                f"The reference camera {self.reference!r} is not among the calibrated cameras.",
                "Name one of: " + ", ".join(self.cameras) + ".",
            )

    @property
    def names(self) -> tuple[str, ...]:
        """Camera names, the reference first."""
        return (self.reference, *(name for name in self.cameras if name != self.reference))


@dataclass(frozen=True, slots=True, eq=False)
class RotationAxis:
    """An axis of rotation: a point on it and its unit direction, right-handed for increasing table angles."""

    point_mm: FloatArray  # (3,)
    direction: FloatArray  # (3,), unit
    frame: str
    point_sigma_mm: float = 0.0
    direction_sigma_rad: float = 0.0
    residual_mm: float = 0.0

    def __post_init__(self) -> None:
        direction = np.asarray(self.direction, float)
        object.__setattr__(self, "point_mm", read_only(self.point_mm, np.float64, (3,)))
        object.__setattr__(self, "direction", read_only(direction / np.linalg.norm(direction), np.float64, (3,)))

    def turned(self, angle_rad: float) -> RigidTransform:
        """Return the rotation about the axis by ``angle_rad``: x' = R(x − c) + c, both in `frame`."""
        rotation = rotation_about(self.direction, angle_rad)
        return RigidTransform.from_parts(rotation, self.point_mm - rotation @ self.point_mm, self.frame, self.frame)


@dataclass(frozen=True, slots=True, eq=False)
class HandEye:
    """Hand-eye calibration: the pose of the reference camera on the robot flange."""

    flange_from_camera: RigidTransform
    rotation_sigma_rad: float = 0.0
    translation_sigma_mm: float = 0.0
    residual_mm: float = 0.0
    residual_rad: float = 0.0
    method: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class LinearGuide:
    """Linear guide: unit direction of travel in the base frame and scale, true millimetres per displayed millimetre."""

    direction: FloatArray  # (3,), unit, in the base frame (whose axes the guide frame shares)
    scale: float
    direction_sigma_rad: float = 0.0
    scale_sigma: float = 0.0
    straightness_mm: float = 0.0

    def __post_init__(self) -> None:
        direction = np.asarray(self.direction, float)
        object.__setattr__(self, "direction", read_only(direction / np.linalg.norm(direction), np.float64, (3,)))

    def guide_from_base(self, position_mm: float) -> RigidTransform:
        """Return the pose of the robot base at the displayed ``position_mm``; the base at position 0 is the guide frame."""
        return RigidTransform.from_parts(np.eye(3), self.direction * self.scale * position_mm, "guide", "base")


@dataclass(frozen=True, slots=True, eq=False)
class RobotStation:
    """A pose of the robot whose error was measured.

    The pose error of a robot is some tenths of a millimetre but repeats within hundredths, so that it can be corrected once measured.
    """

    read: RigidTransform  # base_from_flange as the controller reports it
    true: RigidTransform  # base_from_flange as measured with the board

    def is_at(self, base_from_flange: RigidTransform) -> bool:
        """Whether a reported pose is this station."""
        gap = self.read.inverse() @ base_from_flange
        return bool(np.linalg.norm(gap.translation_mm) < SAME_STATION_MM and gap.angle_rad < SAME_STATION_RAD)


@dataclass(frozen=True, slots=True, eq=False)
class RigCalibration:
    """Calibration of the whole rig. The z axis of the part frame is the table's axis; the part frame turns with the table."""

    cameras: CameraArrayCalibration
    hand_eye: HandEye
    guide: LinearGuide
    axis: RotationAxis  # in the guide frame
    provenance: Provenance = field(default_factory=Provenance)
    stations: tuple[RobotStation, ...] = ()
    view_gaps_mm: float | None = None  # by which it separates views of one part before registration, rms, k = 2; None: not known
    motions: AxisMotions | None = None  # error motions of table and guide; None: not estimated

    def __post_init__(self) -> None:
        if self.axis.frame != "guide":
            raise CalibrationError(
                f"The rotation axis is given in frame {self.axis.frame!r}, not in the guide frame.", "Transform it to the guide frame."
            )

    def station(self, readback: AxisReadback) -> RobotStation | None:
        """Return the measured station of this read-back, if it is one."""
        return next((station for station in self.stations if station.is_at(readback.base_from_flange)), None)

    def guide_from_camera(self, readback: AxisReadback) -> RigidTransform:
        """Return the pose of the reference camera in the guide frame by forward kinematics; at a station, corrected for the robot's error."""
        station = self.station(readback)
        base_from_flange = readback.base_from_flange if station is None else station.true
        guide_from_base = self.guide.guide_from_base(readback.guide_mm)
        if self.motions is not None:
            guide_from_base = guide_from_base @ self.motions.guide_motion(readback.guide_mm)
        return guide_from_base @ base_from_flange @ self.hand_eye.flange_from_camera

    @property
    def table_from_guide(self) -> RigidTransform:
        """The fixed table frame: z = axis, origin = orthogonal projection of the guide's origin onto the axis, x nearest to the guide's x."""
        z = self.axis.direction
        x = np.array([1.0, 0.0, 0.0]) - z[0] * z
        x /= np.linalg.norm(x)
        rotation = np.column_stack([x, np.cross(z, x), z])
        origin = self.axis.point_mm - z * float(z @ self.axis.point_mm)
        return RigidTransform.from_parts(rotation, origin, "guide", "table").inverse()

    def part_from_camera(self, readback: AxisReadback) -> RigidTransform:
        """Return the kinematic position of the viewpoint: part ← table ← guide ← base ← flange ← camera, with all axes as read back.

        The error motions of table and guide are corrected, as far as they are known.
        """
        part_from_table = RigidTransform.from_parts(rotation_about([0, 0, 1], -readback.table_rad), np.zeros(3), "part", "table")
        guide_from_camera = self.guide_from_camera(readback)
        if self.motions is not None:
            guide_from_camera = self.motions.table_motion(readback.table_rad).inverse() @ guide_from_camera
        return part_from_table @ self.table_from_guide @ guide_from_camera
