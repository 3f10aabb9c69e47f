"""Joint registration of all views: overlapping pairs, pairwise ICP, innovation test, pose graph, and error models."""

from __future__ import annotations

from collections.abc import Collection, Hashable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cloud import LoopClosure, ViewPlacement
from measureapp.data.view_errors import ViewErrors, factor_covariance
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Progress
from measureapp.register.joint.axis_doubt import are_many, doubt_axes
from measureapp.register.joint.form_errors import estimate_form_errors
from measureapp.register.joint.innovation_test import estimate_free_correction, innovation_limit
from measureapp.register.joint.loop_closure import SharedMotions, find_worst_loop
from measureapp.register.joint.pose_graph import PoseGraphSolution, linearise_poses, optimise_pose_graph, relative_motion_projector
from measureapp.register.joint.pose_prior import (
    NO_PRIOR,
    KinematicPrior,
    PosePrior,
    add_cloud_errors,
    carry_to_centres,
    largest_sigmas,
    transform_to_centres,
)
from measureapp.register.joint.pose_sensitivity import JointSensitivity, PairSensitivity
from measureapp.register.joint.registration_cache import PlacedCloud, RegistrationCache, map_in_parallel
from measureapp.register.joint.systematic_errors import estimate_systematic_errors
from measureapp.register.pairs.icp import LEAST_MATCHES, PairMeasurement, align_by_gicp, build_gicp_model, measure_pair, register_pair
from measureapp.register.pairs.observability import find_unconstrained_motions
from measureapp.register.pairs.prepare import PreparedCloud
from measureapp.register.settings import StitchSettings

FINE_SEARCH = 2.0  # in voxels, once the views are close
POOR = 2.0  # a pair whose residual exceeds this multiple of the median is registered again by GICP
CONVERGED_MM = 0.003  # largest motion of a view in the last round of the joint estimate
LEAST_CLOUD_MM = 1e-4  # keeps the covariance of views without kinematic errors regular
GOOD = "good"


@dataclass(frozen=True, slots=True, eq=False)
class PreparedView(PlacedCloud):
    """A placed cloud, prepared for registration."""

    station: Hashable
    prepared: PreparedCloud


@dataclass(frozen=True, slots=True)
class Contradiction:
    """Correction of a view by its pairs, relative to the limit from the kinematic errors."""

    moved_mm: float
    turned_deg: float
    excess: float  # multiple of the limit

    @property
    def bound_mm(self) -> float:
        """The limit of such a correction, translation."""
        return self.moved_mm / self.excess if self.excess > 0 else 0.0

    @property
    def bound_deg(self) -> float:
        """The limit of such a correction, rotation."""
        return self.turned_deg / self.excess if self.excess > 0 else 0.0

    @property
    def sentence(self) -> str:
        """The correction and its limit, in words."""
        return (
            f"its surface lies {self.moved_mm:.2f} mm and {self.turned_deg:.3f}° off its kinematic position, "
            f"{self.excess:.1f} times the limit"
        )


def _pose_difference_mm(a: RigidTransform, b: RigidTransform, centre_mm: FloatArray) -> float:
    """Return the displacement of a point of the part between two poses, plus the lever of the rotation at the camera's distance."""
    arm = float(np.linalg.norm(centre_mm - a.translation_mm))
    change = b @ a.inverse()
    return float(np.linalg.norm(change.apply(centre_mm) - centre_mm)) + change.angle_rad * arm


class Registration:
    """Joint registration of all views."""

    def __init__(
        self,
        views: Sequence[PreparedView],
        cache: RegistrationCache,
        settings: StitchSettings,
        progress: Progress,
        *,
        prior: PosePrior = NO_PRIOR,
        accepted: Collection[str] = (),
    ) -> None:
        self.views, self.cache, self.settings, self.progress, self.accepted = views, cache, settings, progress, accepted
        self.calibration, self.patterns, self.axis_doubt = prior.calibration, prior.patterns, ""
        self.kinematic = [view.kinematic for view in views]
        self.centres = np.stack([view.kinematic.apply(view.prepared.centroid_mm) for view in views])
        self.radii = np.array([view.prepared.radius_mm for view in views])
        self.given_covariance = prior.covariance
        self.voxel = views[0].prepared.voxel_mm
        self._set_prior(np.full(len(views), LEAST_CLOUD_MM))

    def _set_prior(self, clouds_mm: FloatArray) -> None:
        """Set the prior from the kinematic errors and the rigid errors ``clouds_mm`` of each cloud."""
        axes = self._build_prior() if self.given_covariance is None else np.asarray(self.given_covariance)
        covariance = add_cloud_errors(axes, self.kinematic, self.centres, self.radii, clouds_mm)
        self.prior = np.asarray(np.linalg.inv(covariance))
        self.kinematic_covariance = transform_to_centres(covariance, self.kinematic, self.centres)

    def _estimate_cloud_sigmas(self, edges: Sequence[PairMeasurement]) -> FloatArray:
        """Estimate the rigid error of each cloud (mm): half the smooth variance of its pairs."""
        usual = float(np.median([edge.smooth_sigma_mm for edge in edges] or [0.0]))
        own = [[edge.smooth_sigma_mm for edge in edges if i in (edge.target, edge.source)] or [usual] for i in range(len(self.views))]
        return np.maximum([float(np.median(values)) for values in own], LEAST_CLOUD_MM) / np.sqrt(2)

    def _build_prior(self) -> FloatArray:
        chosen = self.settings
        prior = KinematicPrior(
            chosen.pose_sigma_mm, np.radians(chosen.pose_sigma_deg), chosen.table_sigma_mm, np.radians(chosen.table_sigma_deg)
        )
        return prior.covariance([view.station for view in self.views])

    def run(self) -> tuple[list[ViewPlacement], LoopClosure | None, ViewErrors]:
        """Register and assess every view; return the placements, the worst loop closure of the used views, and their error model."""
        pairs = self._find_overlapping_pairs()
        poses = list(self.kinematic)
        contradictions: dict[int, Contradiction] = {}
        if self.settings.fine and pairs:
            poses, contradictions = self._register_jointly(pairs)
        excluded = self._excluded_views(contradictions)
        self.progress.check()
        measured = self._measure_pairs(poses, pairs)
        fitted = [edge for edge in measured if self.settings.fine and not excluded & {edge.target, edge.source}]
        # evaluated at the present poses, without another step: the remaining motion is far below the uncertainty
        known = self._optimise(poses, fitted)
        self.progress.check()
        errors, shared = self._model_errors(poses, fitted, known)
        self.progress.check()
        loop_closure = find_worst_loop(
            poses, fitted, self.centres, self.radii, self.kinematic_covariance, [view.cloud.viewpoint_id for view in self.views], shared
        )
        moved = self._relative_corrections(poses, fitted)
        placements = [self._assess_view(i, poses[i], moved[i], contradictions.get(i), measured, known) for i in range(len(self.views))]
        return placements, loop_closure, errors

    def _model_errors(
        self, poses: Sequence[RigidTransform], edges: Sequence[PairMeasurement], known: PoseGraphSolution
    ) -> tuple[ViewErrors, SharedMotions]:
        """Model the errors of the views (registration, camera calibration, form errors of each cloud, systematic errors of all).

        Also returned is what those that all clouds share do to pairs and poses.
        """
        stitching_motions = factor_covariance(known.covariance)
        clouds, sizes = [view.prepared for view in self.views], self._estimate_cloud_sigmas(edges)
        influences = map_in_parallel(lambda edge: PairSensitivity.of(edge, clouds[edge.target], clouds[edge.source]), edges)
        joint = JointSensitivity(linearise_poses(poses, self.kinematic, self.prior, edges, self.centres), influences, clouds, poses)
        self.progress.check()
        form, systematic = estimate_form_errors(clouds, sizes, poses, self.centres), estimate_systematic_errors(joint, sizes)
        self.progress.check()
        of_pairs, moved, distortion = joint.propagate_to_pairs(systematic), np.zeros((len(stitching_motions), 0)), None
        if self.calibration is not None:
            distortion = self.calibration.distortion
            moved = joint.propagate_kinematic_errors(self.calibration.kinematic_motions) + joint.propagate_cloud_errors(distortion)
            of_pairs = np.concatenate([of_pairs, joint.propagate_to_pairs(distortion)], axis=2)
        errors = ViewErrors(tuple(poses), self.centres, stitching_motions, moved, distortion, form, systematic)
        return errors, SharedMotions(of_pairs, np.hstack([systematic.motions, moved]))

    def _find_overlapping_pairs(self) -> list[tuple[int, int]]:
        """Find the pairs of sufficient overlap at their kinematic positions, the best of every view."""
        shares: dict[tuple[int, int], float] = {}
        for i, j in combinations(range(len(self.views)), 2):
            share = self.cache.overlap(self.views[i], self.views[j], self.voxel)
            if share >= self.settings.least_overlap:
                shares[i, j] = share
        best: set[tuple[int, int]] = set()
        for i in range(len(self.views)):
            own = sorted((pair for pair in shares if i in pair), key=lambda pair: (-shares[pair], pair))
            best.update(own[: self.settings.neighbours])
        return sorted(best)

    def _register_jointly(self, pairs: list[tuple[int, int]]) -> tuple[list[RigidTransform], dict[int, Contradiction]]:
        """Return the joint poses, and the contradicting views (they keep their kinematic positions unless they are accepted)."""
        edges = self._register_pairs(pairs)
        self._set_prior(self._estimate_cloud_sigmas(edges))
        contradictions = self._doubt_axes(edges, self._find_contradictions(edges))
        excluded = self._excluded_views(contradictions)
        kept = [pair for pair in pairs if not excluded & set(pair)]
        used = [edge for edge in edges if not excluded & {edge.target, edge.source}]
        poses = list(self._optimise(self.kinematic, used).part_from_camera)
        for step in range(self.settings.rounds):
            self.progress.report(0.6 + 0.4 * step / self.settings.rounds, 1, "joint registration")
            before, poses = poses, list(self._optimise(poses, self._measure_pairs(poses, kept)).part_from_camera)
            if max(_pose_difference_mm(a, b, centre) for a, b, centre in zip(before, poses, self.centres, strict=True)) < CONVERGED_MM:
                break
        return poses, contradictions

    def _find_contradictions(self, edges: Sequence[PairMeasurement]) -> dict[int, Contradiction]:
        """Test every view; exclude the one with the largest excess, and repeat until no view exceeds its limit."""
        found: dict[int, Contradiction] = {}
        while True:
            left = [edge for edge in edges if not found.keys() & {edge.target, edge.source}]
            excess = {i: one for i in range(len(self.views)) if i not in found and (one := self._test_view(i, left)) and one.excess > 1}
            if not excess:
                return found
            worst = max(excess, key=lambda i: (excess[i].excess, -i))
            found[worst] = excess[worst]

    def _doubt_axes(self, edges: Sequence[PairMeasurement], contradictions: dict[int, Contradiction]) -> dict[int, Contradiction]:
        """Return the contradictions that are left where the axes may depart from their calibration in one pattern, which widens the prior."""
        if self.given_covariance is None:
            return contradictions
        single = set() if are_many(len(contradictions), len(self.views)) else set(contradictions)
        asked = [edge for edge in edges if not single & {edge.target, edge.source}]
        carry = carry_to_centres(self.kinematic, self.centres)
        doubt = doubt_axes(self.patterns, self.kinematic, asked, self.centres, self.kinematic_covariance, carry)
        if doubt is None:
            return contradictions
        self.axis_doubt = doubt.sentence if doubt.is_certain else ""
        self.given_covariance = np.asarray(self.given_covariance) + doubt.covariance
        self._set_prior(self._estimate_cloud_sigmas(edges))
        return self._find_contradictions(edges)

    def _test_view(self, i: int, edges: Sequence[PairMeasurement]) -> Contradiction | None:
        """Innovation test of one view: its correction by its pairs alone, relative to the limit; None without pairs."""
        loose_mm, loose_rad = self._prior_sigmas()
        sigmas = self.settings.bound_sigmas
        held = sigmas * np.array([loose_mm] * 3 + [loose_rad] * 3)  # a tighter prior would reduce the correction of a displaced view
        free = estimate_free_correction(i, self.kinematic, edges, self.centres, self.kinematic_covariance, held)
        if free is None:
            return None
        moved, turned = float(np.linalg.norm(free.change[:3])), float(np.linalg.norm(free.change[3:]))
        if self.given_covariance is not None:
            excess = free.distance / innovation_limit(sigmas, len(self.views))
        else:
            excess = max(moved / loose_mm, turned / loose_rad) / sigmas
        return Contradiction(moved, float(np.degrees(turned)), excess)

    def _prior_sigmas(self) -> tuple[float, float]:
        """Return the standard deviations of a pose from the settings, mm and rad."""
        chosen = self.settings
        turn = np.radians(np.hypot(chosen.pose_sigma_deg, chosen.table_sigma_deg))
        return float(np.hypot(chosen.pose_sigma_mm, chosen.table_sigma_mm)), float(turn)

    def _excluded_views(self, contradictions: Mapping[int, Contradiction]) -> set[int]:
        return {i for i in contradictions if self.views[i].cloud.viewpoint_id not in self.accepted}

    def _register_pairs(self, pairs: list[tuple[int, int]]) -> list[PairMeasurement]:
        def register(pair: tuple[int, int]) -> PairMeasurement:
            target, source = (self.views[i] for i in pair)
            return self.cache.register_pair(target, source, pair, self.voxel, self.settings)

        edges = map_in_parallel(register, pairs, lambda done: self.progress.report(0.5 * done, len(pairs), "registering pairs of views"))
        usual = float(np.median([edge.residual_mm for edge in edges if edge.is_valid] or [0.0]))
        better = [edge if edge.is_valid and edge.residual_mm <= POOR * usual else self._retry_with_gicp(edge) for edge in edges]
        return [edge for edge in better if edge.is_valid]

    def _retry_with_gicp(self, poor: PairMeasurement) -> PairMeasurement:
        """Register a pair again, started by GICP; return the better of both results."""
        i, j = poor.target, poor.source
        a, b = self.views[i].prepared, self.views[j].prepared
        if min(len(a), len(b)) < LEAST_MATCHES:
            return poor
        led = align_by_gicp(
            build_gicp_model(a), build_gicp_model(b), self.kinematic[i].inverse() @ self.kinematic[j], self.settings.search_mm
        )
        found = register_pair(a, b, led, (i, j), self.settings.search_mm)
        return found if found.is_valid and (not poor.is_valid or found.residual_mm < poor.residual_mm) else poor

    def _measure_pairs(self, poses: Sequence[RigidTransform], pairs: list[tuple[int, int]]) -> list[PairMeasurement]:
        search = min(self.settings.search_mm, FINE_SEARCH * self.voxel)

        def measured(pair: tuple[int, int]) -> PairMeasurement:
            a, b = (self.views[i].prepared for i in pair)
            between = poses[pair[0]].inverse() @ poses[pair[1]]
            return measure_pair(a, b, between, pair, search)

        return [edge for edge in map_in_parallel(measured, pairs) if edge.is_valid]

    def _optimise(self, start: Sequence[RigidTransform], edges: Sequence[PairMeasurement]) -> PoseGraphSolution:
        return optimise_pose_graph(start, self.kinematic, self.prior, edges, self.centres)

    def _relative_corrections(self, poses: Sequence[RigidTransform], edges: Sequence[PairMeasurement]) -> FloatArray:
        """Return the correction (N, 6) of each view about its centre, without the common motion of all connected views."""
        changes = [pose @ axes.inverse() for pose, axes in zip(poses, self.kinematic, strict=True)]
        moved = np.stack(
            [np.concatenate([change.apply(c) - c, change.rotation_vector]) for change, c in zip(changes, self.centres, strict=True)]
        )
        held = np.unique([i for edge in edges for i in (edge.target, edge.source)]).astype(int)
        if len(held):
            moved[held] = (relative_motion_projector(self.centres[held]) @ moved[held].ravel()).reshape(-1, 6)
        return moved

    def _assess_view(
        self,
        i: int,
        pose: RigidTransform,
        moved: FloatArray,
        contradiction: Contradiction | None,
        edges: Sequence[PairMeasurement],
        known: PoseGraphSolution,
    ) -> ViewPlacement:
        view = self.views[i]
        excluded = contradiction is not None and view.cloud.viewpoint_id not in self.accepted
        own = [edge for edge in edges if i in (edge.target, edge.source)]
        seen = np.zeros(len(view.prepared), np.bool_)
        for edge in own:
            seen[edge.matched_target if edge.target == i else edge.matched_source] = True
        counts = np.array([len(edge.matched_source) for edge in own], float)
        residual = float(np.sqrt(np.average([edge.residual_mm**2 for edge in own], weights=counts))) if own else 0.0
        free = contradiction or self._test_view(i, own)
        sigma_mm, sigma_rad = largest_sigmas(known.covariance_of(i))
        held = self.settings.fine and own and not excluded
        return ViewPlacement(
            viewpoint_id=view.cloud.viewpoint_id,
            part_from_camera=pose,
            kinematic=view.kinematic,
            correction_mm=float(np.linalg.norm(moved[:3])),
            correction_deg=float(np.degrees(np.linalg.norm(moved[3:]))),
            residual_mm=residual,
            overlap=float(seen.mean()) if len(seen) else 0.0,
            verdict=self._verdict(contradiction, excluded, bool(own)),
            used=not excluded,
            bound_mm=free.bound_mm if free else 0.0,
            bound_deg=free.bound_deg if free else 0.0,
            sigma_mm=sigma_mm,
            sigma_deg=float(np.degrees(sigma_rad)),
            unconstrained_motions=find_unconstrained_motions(
                known.surface_information[i], self.centres[i], self.radii[i], self.settings.weak_sigma_mm
            )
            if held
            else (),
        )

    def _verdict(self, contradiction: Contradiction | None, excluded: bool, overlaps: bool) -> str:
        if contradiction is not None:
            return f"{contradiction.sentence}: excluded" if excluded else f"{contradiction.sentence}: accepted by hand"
        if not overlaps and len(self.views) > 1:
            return "no overlap with another view: kinematic position"
        return GOOD
