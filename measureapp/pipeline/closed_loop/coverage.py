"""What a scan has measured of the nominal, sample by sample."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.data.part_pose import PartPose
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.coverage.extent import standing
from measureapp.planning.coverage.head import heads_at
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.samples import SurfaceSamples, sample_surface
from measureapp.planning.coverage.scene import PartScene
from measureapp.planning.coverage.visibility import seen_by
from measureapp.progress import Progress

WIDE = VisibilityLimits(camera_incidence_deg=78.0, projector_incidence_deg=78.0, mirror_deg=0.0)  # what then fails is learnt from the scan
REACH_SPACINGS, REACH_MM = 2.0, 0.5  # distance of a measured point from its sample: spacings of the points, plus the part's deviation
SAME_SIDE = 0.5  # least cosine between the normals of a sample and a measured point
NEIGHBOURS = 4  # measured points looked at for each sample
STANDING_MM = 10.0  # error of the table's height in a rig description
MOST_POINTS = 400_000  # of a cloud, to be searched


@dataclass(frozen=True, slots=True, eq=False)
class MeasuredCoverage:
    """N samples of the nominal on the table (frame `part` of planning: `head.part_from_head`), and what V views measured of them."""

    samples: SurfaceSamples
    scene: PartScene
    viewpoints: tuple[Viewpoint, ...]  # V, those with a cloud
    poses: tuple[RigidTransform, ...]  # V, from the camera to the samples' frame, registered
    measured: BoolArray  # (N,), in the stitched cloud
    sigma_mm: FloatArray  # (N,), of the stitched point; inf where there is none
    grey: FloatArray  # (N,), over saturation, of the nearest stitched point
    visible: BoolArray  # (V, N), predicted
    by_view: BoolArray  # (V, N), measured by this view
    required_mm: float | None  # standard deviation required of a point; None: that it is measured

    @property
    def sufficient(self) -> BoolArray:
        """Whether a sample is measured as well as required, (N,)."""
        return self.measured if self.required_mm is None else self.measured & (self.sigma_mm <= self.required_mm)

    @property
    def predicted(self) -> BoolArray:
        """Whether some view was predicted to see a sample, (N,)."""
        return np.asarray(self.visible.any(axis=0))

    def share(self, which: BoolArray) -> float:
        """Return the share of the surface for which some samples (N,) stand."""
        return float(self.samples.areas_mm2[which].sum() / self.samples.area_mm2)

    def incidence_deg(self, viewpoints: tuple[Viewpoint, ...], rig: RigDescription) -> FloatArray:
        """Return the angle (V, N) between each sample's normal and the direction to the head."""
        return incidence_deg(heads_at(viewpoints, rig), self.samples)


def measure_coverage(
    measurement: Measurement,
    plan: ScanPlan,
    nominal: Mesh,
    rig: RigDescription,
    progress: Progress,
    *,
    samples: int = 4000,
    required_mm: float | None = None,
) -> MeasuredCoverage:
    """Compare a scan with the nominal, placed as its inspection found it, else as the plan states.

    A sample counts as measured where the stitched cloud has a point of the same side within two spacings of its points plus 0.5 mm.

    Parameters
    ----------
    measurement : of the plan; viewpoints without a cloud have measured nothing
    samples : approximate number
    required_mm : standard deviation required of a point; None: that it is measured
    """
    progress.report(0, 3, "samples of the nominal")
    table_from_part, part = _on_table(measurement, nominal, rig, plan.part_pose)
    scene = PartScene.of(part, rig)
    some = sample_surface(scene, samples)
    progress.report(1, 3, "measured samples")
    stitched = measurement.stitched
    reach_mm = REACH_MM + REACH_SPACINGS * stitched.notes.get("spacing_mm", REACH_MM)
    found = _nearest(some, table_from_part.apply(stitched.points_mm), table_from_part.rotate(np.asarray(stitched.normals, float)), reach_mm)
    placed = {placement.viewpoint_id: placement.part_from_camera for placement in stitched.placements if placement.used}
    clouds = {view.viewpoint_id: view.cloud for view in measurement.views if view.viewpoint_id in placed}
    viewpoints = tuple(viewpoint for viewpoint in plan if viewpoint.id in clouds)
    poses = tuple(table_from_part @ placed[viewpoint.id] for viewpoint in viewpoints)
    by_view = np.zeros((len(viewpoints), len(some)), np.bool_)
    for number, viewpoint in enumerate(viewpoints):
        progress.report(1 + number / len(viewpoints), 3, f"measured by {viewpoint.id}")
        pose, cloud = poses[number], clouds[viewpoint.id]
        step = max(1, len(cloud) // MOST_POINTS)
        points, normals = pose.apply(cloud.points_mm[::step]), pose.rotate(np.asarray(cloud.normals[::step], float))
        by_view[number] = _nearest(some, points, normals, reach_mm * np.sqrt(step)).near
    progress.report(2, 3, "visibility")
    visible = seen_by(viewpoints, some, rig, scene, WIDE).seen
    sigma = np.where(found.near, np.asarray(stitched.sigma_mm, float)[found.index], np.inf)
    grey = np.asarray(stitched.grey, float)[found.index]
    return MeasuredCoverage(some, scene, viewpoints, poses, found.near, sigma, grey, visible, by_view, required_mm)


def incidence_deg(part_from_head: FloatArray, samples: SurfaceSamples) -> FloatArray:
    """Return the angle (V, N) between the normals of samples and the direction to heads (V, 4, 4)."""
    angles = np.empty((len(part_from_head), len(samples)))
    for number, pose in enumerate(part_from_head):
        away = pose[:3, 3] - samples.points_mm
        cosine = np.einsum("ni,ni->n", samples.normals, away) / np.maximum(np.linalg.norm(away, axis=1), 1e-9)
        angles[number] = np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))
    return angles


@dataclass(frozen=True, slots=True, eq=False)
class _Nearest:
    near: BoolArray  # (N,), whether a point of the same side is within reach
    index: np.ndarray  # (N,), of that point, else of the nearest one


def _nearest(samples: SurfaceSamples, points_mm: FloatArray, normals: FloatArray, reach_mm: float) -> _Nearest:
    """Return the nearest measured point of each sample that faces the same way."""
    if not len(points_mm):
        return _Nearest(np.zeros(len(samples), np.bool_), np.zeros(len(samples), np.intp))
    count = min(NEIGHBOURS, len(points_mm))
    distance, index = cKDTree(points_mm).query(samples.points_mm, count)
    distance, index = distance.reshape(len(samples), -1), index.reshape(len(samples), -1)
    facing = np.einsum("nki,ni->nk", normals[index], samples.normals) > SAME_SIDE
    good = facing & (distance <= reach_mm)
    first = np.where(good.any(axis=1), good.argmax(axis=1), 0)
    return _Nearest(np.asarray(good.any(axis=1)), np.take_along_axis(index, first[:, None], axis=1)[:, 0])


def _on_table(measurement: Measurement, nominal: Mesh, rig: RigDescription, pose: PartPose | None) -> tuple[RigidTransform, Mesh]:
    """Return the shift from the calibration's frame `part` to that of planning, and the nominal in its place there.

    The calibration does not know the height of the table, the description only to some millimetres: a part that seems to float or sink by
    no more than that stands on it.
    """
    top_mm = measurement.calibration.table_from_guide.apply(np.array(rig.table.centre_in_guide_mm))
    table_from_part = _raised(-float(top_mm[2]))
    if measurement.inspection is None:
        return table_from_part, nominal.seen_from(standing(nominal, pose))
    found = measurement.inspection.alignment.nominal_from_part
    part = nominal.seen_from(table_from_part @ RigidTransform(found.matrix, nominal.frame, "part").inverse())
    low_mm = float(part.vertices_mm[:, 2].min())
    if abs(low_mm) > STANDING_MM:
        return table_from_part, part
    return _raised(-low_mm) @ table_from_part, part.seen_from(_raised(-low_mm))


def _raised(by_mm: float) -> RigidTransform:
    return RigidTransform.from_parts(np.eye(3), [0.0, 0.0, by_mm], "part", "part")
