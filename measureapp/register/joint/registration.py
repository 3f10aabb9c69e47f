"""The joint registration of all views: which overlap, how they lie to each other, and whether the axes allow it."""

from __future__ import annotations

from collections.abc import Collection, Hashable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cloud import RingClosure, ViewPlacement
from measureapp.data.view_errors import CalibrationErrors, ViewErrors, independent
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Progress
from measureapp.register.joint.common_errors import common_errors
from measureapp.register.joint.contradiction import free_correction, quantile
from measureapp.register.joint.form_errors import form_errors
from measureapp.register.joint.groundwork import Groundwork, PlacedCloud, in_parallel
from measureapp.register.joint.pose_errors import JointInfluence, PairInfluence
from measureapp.register.joint.pose_graph import PoseGraphSolution, beside_each_other, following, solve
from measureapp.register.joint.pose_prior import KinematicPrior, about_centres, largest_sigmas, with_cloud_errors
from measureapp.register.joint.ring import largest_gap
from measureapp.register.pairs.icp import LEAST_MATCHES, PairMeasurement, gicp, gicp_model, measure_pair, register_pair
from measureapp.register.pairs.observability import unheld
from measureapp.register.pairs.prepare import PreparedCloud
from measureapp.register.settings import StitchSettings

FINE_SEARCH = 2.0  # in voxels, once the views are close
POOR = 2.0  # a pair whose residual is this many times the usual one is tried again from further away
STILL_MM = 0.003  # a round of the joint estimate that moves no view further is the last; the next would move it by a fraction of that
LEAST_CLOUD_MM = 1e-4  # keeps the covariance of views between which the axes leave nothing open from being singular
GOOD = "good"


@dataclass(frozen=True, slots=True, eq=False)
class View(PlacedCloud):
    """One view on its way through stitching."""

    station: Hashable
    prepared: PreparedCloud


@dataclass(frozen=True, slots=True)
class Contradiction:
    """How far its pairs would move a view, beside how far the axes let expect."""

    moved_mm: float
    turned_deg: float
    excess: float  # times as far as allowed

    @property
    def bound_mm(self) -> float:
        """How far it might have moved in this way."""
        return self.moved_mm / self.excess if self.excess > 0 else 0.0

    @property
    def bound_deg(self) -> float:
        """How far it might have turned in this way."""
        return self.turned_deg / self.excess if self.excess > 0 else 0.0

    @property
    def sentence(self) -> str:
        """What the surfaces say against the axes."""
        return (
            f"its surface lies {self.moved_mm:.2f} mm and {self.turned_deg:.3f}° away from where the axes put it, "
            f"{self.excess:.1f} times as far as they allow"
        )


def _distance_mm(a: RigidTransform, b: RigidTransform, centre_mm: FloatArray) -> float:
    """Return how far two poses put one point of the part, and points as far away as it lies from the cameras, from each other."""
    arm = float(np.linalg.norm(centre_mm - a.translation_mm))
    change = b @ a.inverse()
    return float(np.linalg.norm(change.apply(centre_mm) - centre_mm)) + change.angle_rad * arm


class Registration:
    """The joint registration of all views."""

    def __init__(
        self,
        views: Sequence[View],
        groundwork: Groundwork,
        settings: StitchSettings,
        progress: Progress,
        *,
        prior_covariance: FloatArray | None = None,
        calibration: CalibrationErrors | None = None,
        accepted: Collection[str] = (),
    ) -> None:
        self.views, self.groundwork, self.settings, self.progress, self.accepted = views, groundwork, settings, progress, accepted
        self.calibration = calibration
        self.kinematic = [view.kinematic for view in views]
        self.centres = np.stack([view.kinematic.apply(view.prepared.centroid_mm) for view in views])
        self.radii = np.array([view.prepared.radius_mm for view in views])
        self.given = prior_covariance
        self.voxel = views[0].prepared.voxel_mm
        self._expect(np.full(len(views), LEAST_CLOUD_MM))

    def _expect(self, clouds_mm: FloatArray) -> None:
        """Take what is expected of the poses by the axes, where each cloud errs by ``clouds_mm`` as a whole."""
        axes = self._prior_by_settings() if self.given is None else np.asarray(self.given)
        covariance = with_cloud_errors(axes, self.kinematic, self.centres, self.radii, clouds_mm)
        self.prior = np.asarray(np.linalg.inv(covariance))
        self.by_axes = about_centres(covariance, self.kinematic, self.centres)

    def _errors_of_clouds(self, edges: Sequence[PairMeasurement]) -> FloatArray:
        """Return how far each cloud errs as a whole (mm), by what its pairs show: of each pair's variance one half."""
        usual = float(np.median([edge.smooth_mm for edge in edges] or [0.0]))
        own = [[edge.smooth_mm for edge in edges if i in (edge.target, edge.source)] or [usual] for i in range(len(self.views))]
        return np.maximum([float(np.median(values)) for values in own], LEAST_CLOUD_MM) / np.sqrt(2)

    def _prior_by_settings(self) -> FloatArray:
        chosen = self.settings
        prior = KinematicPrior(
            chosen.pose_sigma_mm, np.radians(chosen.pose_sigma_deg), chosen.table_sigma_mm, np.radians(chosen.table_sigma_deg)
        )
        return prior.covariance([view.station for view in self.views])

    def result(self) -> tuple[list[ViewPlacement], RingClosure | None, ViewErrors]:
        """Register and judge every view, see how well the pairs of those that are used close around the part, and how all views err."""
        pairs = self._overlapping()
        poses = list(self.kinematic)
        contradictions: dict[int, Contradiction] = {}
        if self.settings.fine and pairs:
            poses, contradictions = self._registered(pairs)
        refused = self._refused(contradictions)
        measured = self._measured(poses, pairs)
        fitted = [edge for edge in measured if self.settings.fine and not refused & {edge.target, edge.source}]
        # where the views lie now, not where one more step would take them: what is left is far below their uncertainty
        known = self._solve(poses, fitted)
        ring = largest_gap(poses, fitted, self.centres, self.radii, self.by_axes, [view.cloud.viewpoint_id for view in self.views])
        moved = self._corrections(poses, fitted)
        judged = [self._judged(i, poses[i], moved[i], contradictions.get(i), measured, known) for i in range(len(self.views))]
        return judged, ring, self._errors(poses, fitted, known)

    def _errors(self, poses: Sequence[RigidTransform], edges: Sequence[PairMeasurement], known: PoseGraphSolution) -> ViewErrors:
        """Return how the views err: by pairs and axes, by the calibration, which bends all clouds alike, and by the form of each and of all clouds."""
        by_stitching = independent(known.covariance)
        clouds, sizes = [view.prepared for view in self.views], self._errors_of_clouds(edges)
        influences = in_parallel(lambda edge: PairInfluence.of(edge, clouds[edge.target], clouds[edge.source]), edges)
        joint = JointInfluence(following(poses, self.kinematic, self.prior, edges, self.centres), influences, clouds, poses)
        form, common = form_errors(clouds, sizes, poses, self.centres), common_errors(joint, sizes)
        if self.calibration is None:
            return ViewErrors(tuple(poses), self.centres, by_stitching, np.zeros((len(by_stitching), 0)), None, form, common)
        bends = self.calibration.bends
        moved = joint.by_axes(self.calibration.by_axes) + joint.by_clouds(bends)
        return ViewErrors(tuple(poses), self.centres, by_stitching, moved, bends, form, common)

    def _overlapping(self) -> list[tuple[int, int]]:
        """Return the pairs that share enough surface by the axes alone, the best of every view."""
        shares: dict[tuple[int, int], float] = {}
        for i, j in combinations(range(len(self.views)), 2):
            share = self.groundwork.overlap(self.views[i], self.views[j], self.voxel)
            if share >= self.settings.least_overlap:
                shares[i, j] = share
        best: set[tuple[int, int]] = set()
        for i in range(len(self.views)):
            own = sorted((pair for pair in shares if i in pair), key=lambda pair: (-shares[pair], pair))
            best.update(own[: self.settings.neighbours])
        return sorted(best)

    def _registered(self, pairs: list[tuple[int, int]]) -> tuple[list[RigidTransform], dict[int, Contradiction]]:
        """Return the joint poses, and the views that would move too far (they stay where the axes say, unless they are accepted)."""
        edges = self._pairwise(pairs)
        self._expect(self._errors_of_clouds(edges))
        contradictions = self._contradictions(edges)
        refused = self._refused(contradictions)
        kept = [pair for pair in pairs if not refused & set(pair)]
        used = [edge for edge in edges if not refused & {edge.target, edge.source}]
        poses = list(self._solve(self.kinematic, used).part_from_camera)
        for step in range(self.settings.rounds):
            self.progress.report(0.6 + 0.4 * step / self.settings.rounds, 1, "joint registration")
            before, poses = poses, list(self._solve(poses, self._measured(poses, kept)).part_from_camera)
            if max(_distance_mm(a, b, centre) for a, b, centre in zip(before, poses, self.centres, strict=True)) < STILL_MM:
                break
        return poses, contradictions

    def _contradictions(self, edges: Sequence[PairMeasurement]) -> dict[int, Contradiction]:
        """Set every view free alone and take away the one that exceeds its bound most, until none does."""
        found: dict[int, Contradiction] = {}
        while True:
            left = [edge for edge in edges if not found.keys() & {edge.target, edge.source}]
            excess = {i: one for i in range(len(self.views)) if i not in found and (one := self._freed(i, left)) and one.excess > 1}
            if not excess:
                return found
            worst = max(excess, key=lambda i: (excess[i].excess, -i))
            found[worst] = excess[worst]

    def _freed(self, i: int, edges: Sequence[PairMeasurement]) -> Contradiction | None:
        """Return how far its pairs alone would move a view, and how far it may be moved."""
        loose_mm, loose_rad = self._by_settings()
        sigmas = self.settings.bound_sigmas
        held = sigmas * np.array([loose_mm] * 3 + [loose_rad] * 3)  # no tighter, or a displaced view seems to be less displaced
        free = free_correction(i, self.kinematic, edges, self.centres, self.by_axes, held)
        if free is None:
            return None
        moved, turned = float(np.linalg.norm(free.change[:3])), float(np.linalg.norm(free.change[3:]))
        if self.given is not None:
            excess = free.distance / quantile(sigmas, len(self.views))
        else:
            excess = max(moved / loose_mm, turned / loose_rad) / sigmas
        return Contradiction(moved, float(np.degrees(turned)), excess)

    def _by_settings(self) -> tuple[float, float]:
        """Return one standard deviation of a pose by the settings, mm and rad."""
        chosen = self.settings
        turn = np.radians(np.hypot(chosen.pose_sigma_deg, chosen.table_sigma_deg))
        return float(np.hypot(chosen.pose_sigma_mm, chosen.table_sigma_mm)), float(turn)

    def _refused(self, contradictions: Mapping[int, Contradiction]) -> set[int]:
        return {i for i in contradictions if self.views[i].cloud.viewpoint_id not in self.accepted}

    def _pairwise(self, pairs: list[tuple[int, int]]) -> list[PairMeasurement]:
        def register(pair: tuple[int, int]) -> PairMeasurement:
            target, source = (self.views[i] for i in pair)
            return self.groundwork.registered(target, source, pair, self.voxel, self.settings)

        edges = in_parallel(register, pairs, lambda done: self.progress.report(0.5 * done, len(pairs), "registering pairs of views"))
        usual = float(np.median([edge.residual_mm for edge in edges if edge.found] or [0.0]))
        better = [edge if edge.found and edge.residual_mm <= POOR * usual else self._from_further(edge) for edge in edges]
        return [edge for edge in better if edge.found]

    def _from_further(self, poor: PairMeasurement) -> PairMeasurement:
        """Try again from where GICP leads; the better of the two is kept."""
        i, j = poor.target, poor.source
        a, b = self.views[i].prepared, self.views[j].prepared
        if min(len(a), len(b)) < LEAST_MATCHES:
            return poor
        led = gicp(gicp_model(a), gicp_model(b), self.kinematic[i].inverse() @ self.kinematic[j], self.settings.search_mm)
        found = register_pair(a, b, led, (i, j), self.settings.search_mm)
        return found if found.found and (not poor.found or found.residual_mm < poor.residual_mm) else poor

    def _measured(self, poses: Sequence[RigidTransform], pairs: list[tuple[int, int]]) -> list[PairMeasurement]:
        search = min(self.settings.search_mm, FINE_SEARCH * self.voxel)

        def measured(pair: tuple[int, int]) -> PairMeasurement:
            a, b = (self.views[i].prepared for i in pair)
            between = poses[pair[0]].inverse() @ poses[pair[1]]
            return measure_pair(a, b, between, pair, search)

        return [edge for edge in in_parallel(measured, pairs) if edge.found]

    def _solve(self, start: Sequence[RigidTransform], edges: Sequence[PairMeasurement]) -> PoseGraphSolution:
        return solve(start, self.kinematic, self.prior, edges, self.centres)

    def _corrections(self, poses: Sequence[RigidTransform], edges: Sequence[PairMeasurement]) -> FloatArray:
        """Return how each view moved (N, 6) about its centre beside the others: without what all that hold each other have in common."""
        changes = [pose @ axes.inverse() for pose, axes in zip(poses, self.kinematic, strict=True)]
        moved = np.stack(
            [np.concatenate([change.apply(c) - c, change.rotation_vector]) for change, c in zip(changes, self.centres, strict=True)]
        )
        held = np.unique([i for edge in edges for i in (edge.target, edge.source)]).astype(int)
        if len(held):
            moved[held] = (beside_each_other(self.centres[held]) @ moved[held].ravel()).reshape(-1, 6)
        return moved

    def _judged(
        self,
        i: int,
        pose: RigidTransform,
        moved: FloatArray,
        contradiction: Contradiction | None,
        edges: Sequence[PairMeasurement],
        known: PoseGraphSolution,
    ) -> ViewPlacement:
        view = self.views[i]
        refused = contradiction is not None and view.cloud.viewpoint_id not in self.accepted
        own = [edge for edge in edges if i in (edge.target, edge.source)]
        seen = np.zeros(len(view.prepared), np.bool_)
        for edge in own:
            seen[edge.matched_target if edge.target == i else edge.matched_source] = True
        counts = np.array([len(edge.matched_source) for edge in own], float)
        residual = float(np.sqrt(np.average([edge.residual_mm**2 for edge in own], weights=counts))) if own else 0.0
        free = contradiction or self._freed(i, own)
        sigma_mm, sigma_rad = largest_sigmas(known.of_view(i))
        held = self.settings.fine and own and not refused
        return ViewPlacement(
            viewpoint_id=view.cloud.viewpoint_id,
            part_from_camera=pose,
            kinematic=view.kinematic,
            correction_mm=float(np.linalg.norm(moved[:3])),
            correction_deg=float(np.degrees(np.linalg.norm(moved[3:]))),
            residual_mm=residual,
            overlap=float(seen.mean()) if len(seen) else 0.0,
            verdict=self._verdict(contradiction, refused, bool(own)),
            used=not refused,
            bound_mm=free.bound_mm if free else 0.0,
            bound_deg=free.bound_deg if free else 0.0,
            sigma_mm=sigma_mm,
            sigma_deg=float(np.degrees(sigma_rad)),
            held_by_axes=unheld(known.surface_information[i], self.centres[i], self.radii[i], self.settings.weak_sigma_mm) if held else (),
        )

    def _verdict(self, contradiction: Contradiction | None, refused: bool, overlaps: bool) -> str:
        if contradiction is not None:
            return f"{contradiction.sentence}: {'left out' if refused else 'accepted by hand'}"
        if not overlaps and len(self.views) > 1:
            return "no overlap with another view: stays where the axes say"
        return GOOD
