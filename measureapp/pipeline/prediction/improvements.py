"""What would halve a predicted uncertainty: a repeated viewpoint, one beside it, or longer exposures; tried one by one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.dimension import Dimension
from measureapp.data.measurement import ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.plan import ExposureBracket, ScanPlan, Viewpoint
from measureapp.data.scan_cost import viewpoint_time_s
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.prediction.drawn_errors import displace, draw_error
from measureapp.pipeline.prediction.uncertainty import Job, Prediction, evaluate, exposing_of, predict_views
from measureapp.pipeline.prediction.views import PredictedScene, table_top_mm
from measureapp.planning.coverage.samples import SurfaceSamples
from measureapp.planning.coverage.scene import PartScene
from measureapp.planning.coverage.visibility import seen_by
from measureapp.planning.next_views import between_angles, repeats
from measureapp.planning.travel import travel_times_s
from measureapp.progress import PartOf, Progress
from measureapp.project.geometry.robot_file import arm_of
from measureapp.register.joint.registration_cache import RegistrationCache

HALF = 0.5
LONGER = 2  # factor of all exposures
FIXED = ("calibration", "scale")  # contributions that no viewpoint and no exposure reduces
MOST_TRIED = 3  # of repeats, and of viewpoints between others
BOX_MM, FEATURE_SAMPLES = 1.0, 1500  # around a feature; of all features
LEAST_GAIN = 0.02  # of U: less is within what noise alone changes


@dataclass(frozen=True, slots=True, eq=False)
class Trial:
    """One change of the plan with what it is predicted to give."""

    change: str  # in words
    seconds: float  # added to the scan
    viewpoint: Viewpoint | None  # added; None: other exposures
    uncertainties: dict[str, float]  # dimension -> U (k = 2)


@dataclass(frozen=True, slots=True, eq=False)
class Advice:
    """The trials, and the answer for every dimension."""

    trials: tuple[Trial, ...]
    sentences: tuple[str, ...]  # one per measured dimension

    def document(self) -> dict[str, Any]:
        """Return the trials and sentences for JSON."""
        trials = [
            {
                "change": trial.change,
                "seconds": trial.seconds,
                "uncertainty": dict(trial.uncertainties),
                "viewpoint": None if trial.viewpoint is None else trial.viewpoint.model_dump(mode="json", exclude_none=True),
            }
            for trial in self.trials
        ]
        return {"trials": trials, "advice": list(self.sentences)}


@dataclass(frozen=True, slots=True, eq=False)
class _Added:
    """A viewpoint that is to be tried, with its predicted view."""

    words: str
    viewpoint: Viewpoint
    view: ViewResult


def advise(plan: ScanPlan, scene: PredictedScene, job: Job, base: Prediction, progress: Progress) -> Advice:
    """Predict U again with each of a few changes of the plan, and state for every dimension what would halve it.

    Tried are repeats of viewpoints, viewpoints between neighbouring angles of the table, and all exposures twice as long; all with the same
    error of the calibration. Where calibration and scale alone exceed half of U, no change can halve it, and their part is stated instead.

    Raises
    ------
    MeasureError
        From registration and inspection.
    Cancelled
        From ``progress``.
    """
    unchanged = predict_views(plan, scene, PartOf(progress, 0.0, 0.2))
    added = _added(plan, scene, base, PartOf(progress, 0.2, 0.3))
    drawn = draw_error(unchanged, scene.rig)
    displaced = displace((*unchanged, *(one.view for one in added)), scene.rig, drawn)
    own, new = displaced[: len(unchanged)], displaced[len(unchanged) :]
    trials: list[Trial] = []
    with RegistrationCache() as cache:
        now = evaluate(own, scene, job, cache=cache)
        for number, (one, view) in enumerate(zip(added, new, strict=True)):
            progress.report(0.3 + 0.5 * number / len(added), 1, f"trying {one.words}")
            found = evaluate((*own, view), scene, job, cache=cache)
            trials.append(Trial(one.words, _seconds(plan, one.viewpoint, scene), one.viewpoint, _known(found)))
    trials.append(_try_exposures(plan, scene, job, drawn, PartOf(progress, 0.8, 1.0)))
    progress.report(1, 1, "improvements predicted")
    return Advice(tuple(trials), tuple(answer_for(one, trials) for one in now.dimensions if one.uncertainty))


def _known(found: Prediction) -> dict[str, float]:
    return {one.name: one.uncertainty for one in found.dimensions if one.uncertainty is not None}


def _try_exposures(plan: ScanPlan, scene: PredictedScene, job: Job, drawn: FloatArray | None, progress: Progress) -> Trial:
    longer = _with_longer_exposures(plan)
    brighter = scene.with_brightness(LONGER)  # the light of the part refers to the longest exposure of the plan, which is now longer
    views = displace(predict_views(longer, brighter, progress), scene.rig, drawn)
    seconds = _at_viewpoints_s(longer, scene) - _at_viewpoints_s(plan, scene)
    return Trial(f"all exposures {LONGER} times as long", seconds, None, _known(evaluate(views, scene, job)))


def answer_for(dimension: Dimension, trials: Sequence[Trial]) -> str:
    """State what would halve U of a dimension, or why nothing can, or what gains most for its time."""
    assert dimension.uncertainty  # of a measured dimension
    now = dimension.uncertainty
    fixed = float(np.linalg.norm([dimension.budget.get(name, 0.0) for name in FIXED]))
    gains = [(trial, now - trial.uncertainties.get(dimension.name, now)) for trial in trials]
    helping = [(trial, gain) for trial, gain in gains if gain > LEAST_GAIN * now]
    if fixed > HALF * now:
        words = f"{dimension.name}: no viewpoint or exposure can halve U; the calibration alone gives {fixed / now:.0%} of it"
        return f"{words}. {_most(helping, dimension)}" if helping else f"{words}."
    halving = [(trial, gain) for trial, gain in helping if now - gain <= HALF * now]
    if halving:
        return f"{dimension.name}: {_most(halving, dimension)}"
    if helping:
        return f"{dimension.name}: none of the changes tried halves U. {_most(helping, dimension)}"
    name, size = dimension.rank_contributions()[0]
    return f"{dimension.name}: none of the changes tried reduces U; its largest contribution is {name}, {(size / now) ** 2:.0%}."


def _most(helping: Sequence[tuple[Trial, float]], dimension: Dimension) -> str:
    trial, gain = max(helping, key=lambda one: one[1] / max(one[0].seconds, 1.0))
    assert dimension.uncertainty
    left = dimension.uncertainty - gain
    return f"Most for its time: {trial.change}, U = {left:.4f} {dimension.unit} instead of {dimension.uncertainty:.4f}, for {trial.seconds:.0f} s."


def _added(plan: ScanPlan, scene: PredictedScene, base: Prediction, progress: Progress) -> list[_Added]:
    """Return the viewpoints to be tried: of repeats and of new ones those that tell most about the measured features."""
    exposing, found = exposing_of(plan), list[_Added]()
    wanted = {
        "repeating": repeats(tuple(plan)),
        "adding": between_angles(tuple(plan), scene.rig.description, arm_of(scene.rig.description)),
    }
    for number, (words, some) in enumerate(wanted.items()):
        progress.report(number, len(wanted), "viewpoints to be tried")
        for viewpoint in _most_informative(some, plan, scene, base)[:MOST_TRIED]:
            view = scene.predict(viewpoint, exposing(viewpoint))
            if view is not None and view.quality.accepted:
                again = f"repeating {viewpoint.id.removesuffix('-again')}"
                new = f"adding a viewpoint at table {viewpoint.table_deg:g}°, {_station(viewpoint)}"
                found.append(_Added(again if words == "repeating" else new, viewpoint, view))
    return found


def _most_informative(viewpoints: Sequence[Viewpoint], plan: ScanPlan, scene: PredictedScene, base: Prediction) -> list[Viewpoint]:
    """Return viewpoints by the information they add on the features, relative to what the plan has of them; the most first."""
    if not viewpoints:
        return []
    rig = scene.rig.description
    shift = RigidTransform.from_parts(np.eye(3), [0.0, 0.0, -table_top_mm(scene.rig)], "part", "part")
    surface = scene.surface
    mesh = Mesh(surface.vertices_mm, surface.triangles, "nominal").seen_from(shift @ scene.part_from_nominal)
    samples = _feature_samples(base, scene, shift)
    part = PartScene.of(mesh, rig)
    known, new = (
        np.nan_to_num(1.0 / np.square(seen_by(some, samples, rig, part).sigma_mm.astype(float)))
        for some in (tuple(plan), tuple(viewpoints))
    )
    usual = float(np.median(new[new > 0])) if (new > 0).any() else 1.0
    gains = (new / (known.sum(axis=0) + usual)).sum(axis=1)
    return [viewpoints[number] for number in np.argsort(-gains, kind="stable")]


def _feature_samples(base: Prediction, scene: PredictedScene, shift: RigidTransform) -> SurfaceSamples:
    """Return points of the measured features in the frame `part` of planning; of the whole part where there are no features."""
    stitched = base.stitched
    points = scene.part_from_nominal.inverse().apply(stitched.points_mm)
    inside = np.zeros(len(points), np.bool_)
    for feature in base.features:
        if feature.boundary_mm is not None:
            around = np.asarray(feature.boundary_mm)
            inside |= np.all((points >= around.min(axis=0) - BOX_MM) & (points <= around.max(axis=0) + BOX_MM), axis=1)
    chosen = np.flatnonzero(inside) if inside.any() else np.arange(len(points))
    chosen = chosen[:: max(1, len(chosen) // FEATURE_SAMPLES)]
    normals = shift.rotate(np.asarray(stitched.normals[chosen], float))
    return SurfaceSamples(shift.apply(stitched.points_mm[chosen]), normals, np.ones(len(chosen)))


def _station(viewpoint: Viewpoint) -> str:
    x, y, z = viewpoint.flange.position_mm
    return f"flange at ({x:.0f}, {y:.0f}, {z:.0f}) mm"


def _with_longer_exposures(plan: ScanPlan) -> ScanPlan:
    """Return the plan with every exposure longer; the shortest is kept as well, for bright places."""

    def longer(exposures_us: Sequence[int]) -> tuple[int, ...]:
        return tuple(sorted({*(LONGER * exposure for exposure in exposures_us), exposures_us[-1]}, reverse=True))

    viewpoints = tuple(
        viewpoint if viewpoint.exposures_us is None else viewpoint.model_copy(update={"exposures_us": longer(viewpoint.exposures_us)})
        for viewpoint in plan
    )
    bracket = ExposureBracket(exposures_us=longer(plan.bracket.exposures_us))
    return plan.model_copy(update={"viewpoints": viewpoints, "groups": (), "bracket": bracket})


def _seconds(plan: ScanPlan, viewpoint: Viewpoint, scene: PredictedScene) -> float:
    """Return the time that a viewpoint adds: its images, and the shortest move from another one."""
    rig = scene.rig.description
    moves = travel_times_s((viewpoint, *plan), rig, arm_of(rig))[1:, 0]
    return viewpoint_time_s(plan, viewpoint, rig) + float(moves.min())


def _at_viewpoints_s(plan: ScanPlan, scene: PredictedScene) -> float:
    return sum(viewpoint_time_s(plan, viewpoint, scene.rig.description) for viewpoint in plan)
