"""Points measured from one viewpoint, and the cloud of all views."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, give_up_pages, read_only
from measureapp.data.view_errors import ViewErrors
from measureapp.errors import FrameMismatch
from measureapp.geometry.transform import RigidTransform

PROJECTOR_BIT = 128  # in PointCloud.cameras


@dataclass(frozen=True, slots=True, eq=False)
class PointCloud:
    """Points measured from one viewpoint, in one named frame; never changed after creation."""

    points_mm: FloatArray  # (N, 3) float64
    normals: FloatArray  # (N, 3) float32, unit, towards the sensor
    sigma_mm: FloatArray  # (N,) float32, predicted standard deviation along the viewing ray
    grey: FloatArray  # (N,) float32, 0…1
    pixel: IntArray  # (N, 2) int32, (row, column) in the first camera that measured it; -1 where unknown
    cameras: IntArray  # (N,) uint8, bit i: measured by the i-th camera; bit 7 (PROJECTOR_BIT): by the projector as a camera
    frame: str  # "camera", "part", …
    viewpoint_id: str

    def __post_init__(self) -> None:
        count = len(self.points_mm)
        object.__setattr__(self, "points_mm", read_only(self.points_mm, np.float64, (count, 3)))
        object.__setattr__(self, "normals", read_only(self.normals, np.float32, (count, 3)))
        object.__setattr__(self, "sigma_mm", read_only(self.sigma_mm, np.float32, (count,)))
        object.__setattr__(self, "grey", read_only(self.grey, np.float32, (count,)))
        object.__setattr__(self, "pixel", read_only(self.pixel, np.int32, (count, 2)))
        object.__setattr__(self, "cameras", read_only(self.cameras, np.uint8, (count,)))

    @classmethod
    def empty(cls, frame: str, viewpoint_id: str) -> PointCloud:
        """Return a cloud without points."""
        none, single = np.empty((0, 3)), np.empty(0)
        return cls(none, none, single, single, np.empty((0, 2), np.int32), np.empty(0, np.uint8), frame, viewpoint_id)

    def __len__(self) -> int:
        return len(self.points_mm)

    def give_up_pages(self) -> None:
        """Take a cloud that is mapped from a file out of memory until it is used again; any other stays as it is."""
        give_up_pages(self.points_mm, self.normals, self.sigma_mm, self.grey, self.pixel, self.cameras)

    def seen_from(self, transform: RigidTransform) -> PointCloud:
        """Return the same points in ``transform.to_frame``; raises FrameMismatch."""
        if transform.from_frame != self.frame:
            raise FrameMismatch(
                f"A cloud in frame {self.frame!r} cannot be transformed by {transform.to_frame}_from_{transform.from_frame}.",
                "Use a transform from the frame of the cloud.",
            )
        return replace(self, points_mm=transform.apply(self.points_mm), normals=transform.rotate(self.normals), frame=transform.to_frame)

    def where(self, keep: BoolArray | IntArray | slice) -> PointCloud:
        """Return the points chosen by a mask, by indices or by a slice."""
        return replace(
            self,
            points_mm=self.points_mm[keep],
            normals=self.normals[keep],
            sigma_mm=self.sigma_mm[keep],
            grey=self.grey[keep],
            pixel=self.pixel[keep],
            cameras=self.cameras[keep],
        )


def concatenate_clouds(clouds: Sequence[PointCloud]) -> PointCloud:
    """Concatenate clouds of one view and frame; raises FrameMismatch if the frames differ."""
    first = clouds[0]
    for cloud in clouds:
        if cloud.frame != first.frame:
            raise FrameMismatch(
                f"Clouds in frames {first.frame!r} and {cloud.frame!r} cannot be merged.", "Transform them to one frame first."
            )
    names = ("points_mm", "normals", "sigma_mm", "grey", "pixel", "cameras")
    arrays: dict[str, Any] = {name: np.concatenate([getattr(cloud, name) for cloud in clouds]) for name in names}
    return replace(first, **arrays)


@dataclass(frozen=True, slots=True)
class CloudQuality:
    """Quality of a cloud by the definitions of the methods sheet (section 8), and whether it is accepted for registration."""

    points: int
    density_per_mm2: float
    noise_mm: float
    outlier_ratio: float
    completeness: float
    accepted: bool
    reason: str  # empty when accepted
    distortion_mm: float = 0.0  # waves of smooth surface beyond the noise


@dataclass(frozen=True, slots=True, eq=False)
class ViewPlacement:
    """Pose of one view: kinematic, and after registration."""

    viewpoint_id: str
    part_from_camera: RigidTransform  # after registration
    kinematic: RigidTransform  # kinematic pose part_from_camera
    correction_mm: float  # displacement of the view's centroid by registration, without the common motion of all views
    correction_deg: float
    residual_mm: float  # rms point-to-plane distance from its neighbours after registration
    overlap: float  # share of its points with corresponding points in other views
    verdict: str  # "good", or the reason why not
    used: bool
    bound_mm: float = 0.0  # limit of the correction from the kinematic uncertainty; 0 where nothing was corrected
    bound_deg: float = 0.0
    sigma_mm: float = 0.0  # standard deviation of the view's centroid relative to the other views, in its worst direction; 0 where unknown
    sigma_deg: float = 0.0
    unconstrained_motions: tuple[str, ...] = ()  # motions that the common surface does not determine


@dataclass(frozen=True, slots=True)
class LoopClosure:
    """Loop closure of the pairs around the part."""

    viewpoints: tuple[str, ...]  # in order around the part
    gap_mm: float  # rms displacement of the first view's points after one loop
    gap_deg: float
    sigma_mm: float  # expected gap, rms
    freedom: float = 3.0  # degrees of freedom of the scaled chi-square that the squared gap follows; of files without it: as a translation
    loops: int = 1  # of which this is the least probable

    @property
    def sentence(self) -> str:
        """The loop closure in words."""
        return (
            f"loop closure over {len(self.viewpoints)} views around the part: {self.gap_mm:.3f} mm and {self.gap_deg:.4f}° "
            f"(expected: {self.sigma_mm:.3f} mm)"
        )


@dataclass(frozen=True, slots=True, eq=False)
class StitchedCloud:
    """The merged points of all views, in the part's frame."""

    points_mm: FloatArray  # (N, 3) float64
    normals: FloatArray  # (N, 3) float32
    sigma_mm: FloatArray  # (N,) float32
    grey: FloatArray  # (N,) float32, 0…1
    view: IntArray  # (N,) int16, index into `placements` of the view of greatest weight
    placements: tuple[ViewPlacement, ...]
    frame: str = "part"
    notes: Mapping[str, float] = field(default_factory=dict)
    loop_closure: LoopClosure | None = None  # of the worst loop; None without a loop around the part
    view_names: tuple[str, ...] = ()  # names of the views that `view` numbers; those of the placements if known
    sampled_view: IntArray | None = None  # (N,) int16, one view per point, sampled with probability proportional to its weight
    errors: ViewErrors | None = None  # of the views that `view` numbers; None where not known
    axis_doubt: str = ""  # a sentence, where many views contradict the calibrated axes in one pattern

    def __post_init__(self) -> None:
        count = len(self.points_mm)
        object.__setattr__(self, "points_mm", read_only(self.points_mm, np.float64, (count, 3)))
        object.__setattr__(self, "normals", read_only(self.normals, np.float32, (count, 3)))
        object.__setattr__(self, "sigma_mm", read_only(self.sigma_mm, np.float32, (count,)))
        object.__setattr__(self, "grey", read_only(self.grey, np.float32, (count,)))
        object.__setattr__(self, "view", read_only(self.view, np.int16, (count,)))
        if self.sampled_view is not None:
            object.__setattr__(self, "sampled_view", read_only(self.sampled_view, np.int16, (count,)))
        if self.placements:
            object.__setattr__(self, "view_names", tuple(placement.viewpoint_id for placement in self.placements))

    def __len__(self) -> int:
        return len(self.points_mm)

    def where(self, keep: BoolArray | IntArray) -> StitchedCloud:
        """Return the points chosen by a mask or by indices; the views keep their numbers and names."""
        names = ("points_mm", "normals", "sigma_mm", "grey", "view", "sampled_view")
        arrays: dict[str, Any] = {name: values[keep] for name in names if (values := getattr(self, name)) is not None}
        return replace(self, **arrays)
