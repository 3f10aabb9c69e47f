"""Points measured from one viewpoint, and the cloud of all views."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only
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
    pixel: IntArray  # (N, 2) int32, (row, column) in the camera that saw it first; -1 where unknown
    cameras: IntArray  # (N,) uint8, bit i set: seen by the i-th camera; bit 7 (PROJECTOR_BIT): the projector served as a camera
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

    def __len__(self) -> int:
        return len(self.points_mm)

    def seen_from(self, transform: RigidTransform) -> PointCloud:
        """Return the same points in ``transform.to_frame``; raises FrameMismatch."""
        if transform.from_frame != self.frame:
            raise FrameMismatch(
                f"A cloud in frame {self.frame!r} cannot be taken through {transform.to_frame}_from_{transform.from_frame}.",
                "Place the cloud with the transform of its own frame.",
            )
        return replace(self, points_mm=transform.apply(self.points_mm), normals=transform.rotate(self.normals), frame=transform.to_frame)

    def where(self, keep: BoolArray | IntArray) -> PointCloud:
        """Return the points chosen by a mask or by indices."""
        return replace(
            self,
            points_mm=self.points_mm[keep],
            normals=self.normals[keep],
            sigma_mm=self.sigma_mm[keep],
            grey=self.grey[keep],
            pixel=self.pixel[keep],
            cameras=self.cameras[keep],
        )


def joined(clouds: Sequence[PointCloud]) -> PointCloud:
    """Return the points of several clouds of one view and frame, in order; raises FrameMismatch where the frames differ."""
    first = clouds[0]
    for cloud in clouds:
        if cloud.frame != first.frame:
            raise FrameMismatch(f"Clouds in frames {first.frame!r} and {cloud.frame!r} cannot be joined.", "Place them in one frame first.")
    names = ("points_mm", "normals", "sigma_mm", "grey", "pixel", "cameras")
    arrays: dict[str, Any] = {name: np.concatenate([getattr(cloud, name) for cloud in clouds]) for name in names}
    return replace(first, **arrays)


@dataclass(frozen=True, slots=True)
class CloudQuality:
    """What a cloud is worth, by the definitions of the methods sheet (section 8), and whether it may be stitched."""

    points: int
    density_per_mm2: float
    noise_mm: float
    outlier_ratio: float
    completeness: float
    accepted: bool
    reason: str  # empty when accepted
    distortion_mm: float = 0.0  # by how much smooth surface waves beyond its noise


@dataclass(frozen=True, slots=True, eq=False)
class ViewPlacement:
    """Where one view came to lie: its pose by the axes, and what fine stitching changed."""

    viewpoint_id: str
    part_from_camera: RigidTransform  # after fine stitching
    kinematic: RigidTransform  # by the axes alone
    correction_mm: float  # how far the fine stitching moved the view's centroid beside the other views, not together with them
    correction_deg: float
    residual_mm: float  # rms point-to-surface distance to its neighbours after fine stitching
    overlap: float  # share of its points that neighbours have too
    verdict: str  # "good", or the reason why not
    used: bool
    bound_mm: float = 0.0  # furthest correction beside the other views that the axes allow; 0 where nothing was corrected
    bound_deg: float = 0.0
    sigma_mm: float = (
        0.0  # standard deviation of where the view's centroid lies beside the others', in its worst direction; 0 where unknown
    )
    sigma_deg: float = 0.0
    held_by_axes: tuple[str, ...] = ()  # motions that the common surface leaves open


@dataclass(frozen=True, slots=True)
class RingClosure:
    """How well pairs of views close around the part: where the first view comes to lie once it was taken around by pairs."""

    viewpoints: tuple[str, ...]  # in the order around
    gap_mm: float  # rms distance of the first view's points from where they were
    gap_deg: float
    sigma_mm: float  # how large the gap is expected to be, rms

    @property
    def sentence(self) -> str:
        """How well they close, in words."""
        return (
            f"taken around the part over {len(self.viewpoints)} views by their pairs, the first view comes back {self.gap_mm:.3f} mm "
            f"and {self.gap_deg:.4f}° off; {self.sigma_mm:.3f} mm are to be expected"
        )


@dataclass(frozen=True, slots=True, eq=False)
class StitchedCloud:
    """The merged points of all views, in the part's frame."""

    points_mm: FloatArray  # (N, 3) float64
    normals: FloatArray  # (N, 3) float32
    sigma_mm: FloatArray  # (N,) float32
    grey: FloatArray  # (N,) float32, 0…1
    view: IntArray  # (N,) int16, index into `placements` of the view that weighs most in the point
    placements: tuple[ViewPlacement, ...]
    frame: str = "part"
    notes: Mapping[str, float] = field(default_factory=dict)
    ring: RingClosure | None = None  # the one that closes worst; None where no pairs lead around the part
    view_names: tuple[str, ...] = ()  # what `view` counts; those of the placements where these are known
    drawn_view: IntArray | None = None  # (N,) int16, a view drawn for each point as often as it weighs in it; None where not known
    errors: ViewErrors | None = None  # of the views that `view` counts; None where not known

    def __post_init__(self) -> None:
        count = len(self.points_mm)
        object.__setattr__(self, "points_mm", read_only(self.points_mm, np.float64, (count, 3)))
        object.__setattr__(self, "normals", read_only(self.normals, np.float32, (count, 3)))
        object.__setattr__(self, "sigma_mm", read_only(self.sigma_mm, np.float32, (count,)))
        object.__setattr__(self, "grey", read_only(self.grey, np.float32, (count,)))
        object.__setattr__(self, "view", read_only(self.view, np.int16, (count,)))
        if self.drawn_view is not None:
            object.__setattr__(self, "drawn_view", read_only(self.drawn_view, np.int16, (count,)))
        if self.placements:
            object.__setattr__(self, "view_names", tuple(placement.viewpoint_id for placement in self.placements))

    def __len__(self) -> int:
        return len(self.points_mm)

    def where(self, keep: BoolArray | IntArray) -> StitchedCloud:
        """Return the points chosen by a mask or by indices; the views keep their numbers and names."""
        names = ("points_mm", "normals", "sigma_mm", "grey", "view", "drawn_view")
        arrays: dict[str, Any] = {name: values[keep] for name in names if (values := getattr(self, name)) is not None}
        return replace(self, **arrays)
