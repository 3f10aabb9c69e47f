"""Fine stitching: all views together, with the kinematic poses as priors, then merged."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from measureapp.data.cloud import PointCloud, StitchedCloud, ViewPlacement
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.register.cloud_quality import point_spacing_mm
from measureapp.register.icp import LEAST_MATCHES, PairMeasurement, gicp, gicp_model, measure_pair, register_pair
from measureapp.register.merge import merge
from measureapp.register.pose_graph import KinematicPrior, PoseGraphSolution, solve
from measureapp.register.prepare import PreparedCloud, occupied_cells, prepare
from measureapp.register.settings import StitchSettings

LEAST_POINTS = 100
VOXEL_PER_SPACING = 2.2
LEAST_VOXEL_MM = 0.7  # finer thinning registers no better, but takes its time
CELL_PER_VOXEL = 5.0
FINE_SEARCH = 2.0  # in voxels, once the views are close
POOR = 2.0  # a pair whose residual is this many times the usual one is tried again from further away
GOOD = "good"


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """One view on its way through stitching."""

    cloud: PointCloud
    kinematic: RigidTransform
    station: Hashable
    prepared: PreparedCloud


def stitch(
    clouds: Sequence[PointCloud],
    kinematic: Sequence[RigidTransform],
    settings: StitchSettings | None = None,
    progress: Progress | None = None,
    *,
    stations: Sequence[Hashable] | None = None,
) -> StitchedCloud:
    """Register all views finely and merge them.

    Overlapping pairs are found by the kinematic poses and registered; then all poses are estimated together with the
    kinematic poses as priors, so that nothing slides where the surface does not hold it. A view that would move
    further than the priors allow is left out and says so. The result does not depend on the order of the views.

    Parameters
    ----------
    clouds : one per view, in frame ``camera``
    kinematic : part_from_camera by the axes, one per cloud
    stations : one label per view, equal for views between which only the table turned (`register.place.stations`);
        these share the robot's error. None: every view stands alone.

    Raises
    ------
    RegistrationError
        No cloud has enough points.
    """
    settings, progress = settings or StitchSettings(), progress or NoProgress()
    if not len(clouds) == len(kinematic) == len(stations or clouds):
        raise RegistrationError(f"{len(clouds)} clouds and {len(kinematic)} poses do not go together.", "Give one pose per cloud.")
    order = sorted(range(len(clouds)), key=lambda i: (clouds[i].viewpoint_id, i))
    chosen = [i for i in order if len(clouds[i]) >= LEAST_POINTS]
    if not chosen:
        raise RegistrationError("No cloud has enough points to be stitched.", f"At least one needs {LEAST_POINTS} points.")
    spacing = float(np.median([point_spacing_mm(np.asarray(clouds[i].points_mm)) for i in chosen]))
    voxel = settings.registration_voxel_mm or max(VOXEL_PER_SPACING * spacing, LEAST_VOXEL_MM)
    views = []
    for done, i in enumerate(chosen):
        progress.report(0.15 * done, len(chosen), "preparing views")
        station = stations[i] if stations is not None else i
        views.append(View(clouds[i], kinematic[i], station, prepare(clouds[i], voxel)))
    placed = _Registration(views, settings, PartOf(progress, 0.15, 0.7)).placements()
    by_cloud = dict(zip(chosen, placed, strict=True))
    placements = tuple(by_cloud.get(i) or _left_out(clouds[i], kinematic[i]) for i in range(len(clouds)))
    return _merged(clouds, placements, settings, spacing, PartOf(progress, 0.7, 1.0))


def _left_out(cloud: PointCloud, kinematic: RigidTransform) -> ViewPlacement:
    reason = f"only {len(cloud)} points: left out"
    return ViewPlacement(cloud.viewpoint_id, kinematic, kinematic, 0.0, 0.0, 0.0, 0.0, reason, False)


def _merged(
    clouds: Sequence[PointCloud], placements: tuple[ViewPlacement, ...], settings: StitchSettings, spacing_mm: float, progress: Progress
) -> StitchedCloud:
    used = [i for i, placement in enumerate(placements) if placement.used]
    if not used:
        raise RegistrationError("No view can be used.", "Check the calibration: every view contradicts the axes.")
    used.sort(key=lambda i: placements[i].viewpoint_id)
    poses = [placements[i].part_from_camera for i in used]
    voxel = settings.merge_voxel_mm or spacing_mm
    merged = merge(
        [clouds[i].seen_from(pose) for i, pose in zip(used, poses, strict=True)],
        [pose.translation_mm for pose in poses],
        voxel,
        views=used,
        island_mm2=settings.island_mm2,
        progress=progress,
    )
    notes = {"spacing_mm": spacing_mm, "merge_voxel_mm": voxel, "views_used": float(len(used))}
    frame = poses[0].to_frame
    return StitchedCloud(merged.points_mm, merged.normals, merged.sigma_mm, merged.grey, merged.view, placements, frame, notes)


class _Registration:
    """The joint registration of all views."""

    def __init__(self, views: Sequence[View], settings: StitchSettings, progress: Progress) -> None:
        self.views, self.settings, self.progress = views, settings, progress
        self.kinematic = [view.kinematic for view in views]
        self.centres = np.stack([view.kinematic.apply(view.prepared.centroid_mm) for view in views])
        prior = KinematicPrior(
            settings.pose_sigma_mm, np.radians(settings.pose_sigma_deg), settings.table_sigma_mm, np.radians(settings.table_sigma_deg)
        )
        self.prior = prior.information([view.station for view in views])
        self.voxel = views[0].prepared.voxel_mm

    def placements(self) -> list[ViewPlacement]:
        """Register and judge every view."""
        pairs = self._overlapping()
        poses = list(self.kinematic)
        refused: set[int] = set()
        if self.settings.fine and pairs:
            poses, refused = self._registered(pairs)
        measured = self._measured(poses, pairs)
        return [self._judged(i, poses[i], i in refused, measured) for i in range(len(self.views))]

    def _overlapping(self) -> list[tuple[int, int]]:
        """Return the pairs that share enough surface by the axes alone, the best of every view."""
        cell = CELL_PER_VOXEL * self.voxel
        cells = []
        for view in self.views:
            points, normals = view.kinematic.apply(view.prepared.points_mm), view.kinematic.rotate(view.prepared.normals)
            cells.append(occupied_cells(view.prepared, points, normals, cell))
        shares: dict[tuple[int, int], float] = {}
        for i, j in combinations(range(len(self.views)), 2):
            common = len(np.intersect1d(cells[i], cells[j], assume_unique=True))
            share = common / max(1, min(len(cells[i]), len(cells[j])))
            if share >= self.settings.least_overlap:
                shares[i, j] = share
        best: set[tuple[int, int]] = set()
        for i in range(len(self.views)):
            own = sorted((pair for pair in shares if i in pair), key=lambda pair: (-shares[pair], pair))
            best.update(own[: self.settings.neighbours])
        return sorted(best)

    def _registered(self, pairs: list[tuple[int, int]]) -> tuple[list[RigidTransform], set[int]]:
        """Return the joint poses and the views refused because they would move too far."""
        edges = self._pairwise(pairs)
        poses = list(self._solve(self.kinematic, edges).part_from_camera)
        for step in range(self.settings.rounds):
            self.progress.report(0.6 + 0.4 * step / self.settings.rounds, 1, "joint registration")
            edges = self._measured(poses, pairs)
            poses = list(self._solve(poses, edges).part_from_camera)
        refused: set[int] = set()
        while (worst := self._worst(poses, refused)) is not None:
            refused.add(worst)
            kept = [pair for pair in pairs if not refused & set(pair)]
            edges = self._measured(poses, kept)
            solved = self._solve([self.kinematic[i] if i in refused else pose for i, pose in enumerate(poses)], edges).part_from_camera
            poses = [poses[i] if i in refused else solved[i] for i in range(len(poses))]
        return poses, refused

    def _pairwise(self, pairs: list[tuple[int, int]]) -> list[PairMeasurement]:
        edges = []
        for done, (i, j) in enumerate(pairs):
            self.progress.report(
                0.5 * done, len(pairs), f"registering {self.views[i].cloud.viewpoint_id}, {self.views[j].cloud.viewpoint_id}"
            )
            start = self.kinematic[i].inverse() @ self.kinematic[j]
            edges.append(register_pair(self.views[i].prepared, self.views[j].prepared, start, (i, j), self.settings.search_mm))
        usual = float(np.median([edge.residual_mm for edge in edges if edge.found] or [0.0]))
        better = [edge if edge.found and edge.residual_mm <= POOR * usual else self._from_further(edge) for edge in edges]
        return [edge for edge in better if edge.found]

    def _from_further(self, poor: PairMeasurement) -> PairMeasurement:
        """Try again from where GICP leads; the better of the two is kept."""
        i, j = poor.target, poor.source
        start = self.kinematic[i].inverse() @ self.kinematic[j]
        a, b = self.views[i].prepared, self.views[j].prepared
        if min(len(a), len(b)) < LEAST_MATCHES:
            return poor
        led = gicp(gicp_model(a), gicp_model(b), start, self.settings.search_mm)
        found = register_pair(a, b, led, (i, j), self.settings.search_mm)
        return found if found.found and (not poor.found or found.residual_mm < poor.residual_mm) else poor

    def _measured(self, poses: Sequence[RigidTransform], pairs: list[tuple[int, int]]) -> list[PairMeasurement]:
        search = min(self.settings.search_mm, FINE_SEARCH * self.voxel)
        edges = [
            measure_pair(self.views[i].prepared, self.views[j].prepared, poses[i].inverse() @ poses[j], (i, j), search) for i, j in pairs
        ]
        return [edge for edge in edges if edge.found]

    def _solve(self, start: Sequence[RigidTransform], edges: Sequence[PairMeasurement]) -> PoseGraphSolution:
        return solve(start, self.kinematic, self.prior, edges, self.centres)

    def _correction(self, i: int, pose: RigidTransform) -> tuple[float, float]:
        """Return how far the view's centre moved (mm) and how far the view turned (degrees)."""
        change = pose @ self.kinematic[i].inverse()
        return float(np.linalg.norm(change.apply(self.centres[i]) - self.centres[i])), float(np.degrees(change.angle_rad))

    def _bounds(self) -> tuple[float, float]:
        chosen = self.settings
        return (
            chosen.bound_sigmas * float(np.hypot(chosen.pose_sigma_mm, chosen.table_sigma_mm)),
            chosen.bound_sigmas * float(np.hypot(chosen.pose_sigma_deg, chosen.table_sigma_deg)),
        )

    def _worst(self, poses: Sequence[RigidTransform], refused: set[int]) -> int | None:
        """Return the view that exceeds its bound most; None when none does."""
        bound_mm, bound_deg = self._bounds()
        excess = {}
        for i in set(range(len(poses))) - refused:
            moved, turned = self._correction(i, poses[i])
            excess[i] = max(moved / bound_mm, turned / bound_deg)
        worst = max(excess, key=lambda i: (excess[i], -i), default=None)
        return worst if worst is not None and excess[worst] > 1 else None

    def _judged(self, i: int, pose: RigidTransform, refused: bool, edges: Sequence[PairMeasurement]) -> ViewPlacement:
        view = self.views[i]
        own = [edge for edge in edges if i in (edge.target, edge.source)]
        seen = np.zeros(len(view.prepared), np.bool_)
        for edge in own:
            seen[edge.matched_target if edge.target == i else edge.matched_source] = True
        overlap = float(seen.mean()) if len(seen) else 0.0
        counts = np.array([len(edge.matched_source) for edge in own], float)
        residual = float(np.sqrt(np.average([edge.residual_mm**2 for edge in own], weights=counts))) if own else 0.0
        moved, turned = self._correction(i, pose)
        bound_mm, bound_deg = self._bounds()
        if refused:
            verdict = f"would have to move {moved:.2f} mm and {turned:.3f}°, more than {bound_mm:.2f} mm or {bound_deg:.3f}°: left out"
        elif not own and len(self.views) > 1:
            verdict = "no overlap with another view: stays where the axes say"
        else:
            verdict = GOOD
        return ViewPlacement(view.cloud.viewpoint_id, pose, view.kinematic, moved, turned, residual, overlap, verdict, not refused)
