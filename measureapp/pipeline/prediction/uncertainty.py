"""Predicted uncertainty of every dimension, by the code that states it after a scan."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from measureapp.data.cloud import StitchedCloud
from measureapp.data.dimension import Dimension
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.measurement import ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.errors import PlanError
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.programming.nominals import with_designed_standards
from measureapp.pipeline.assemble import inspection_settings, pose_prior, stitch_settings
from measureapp.pipeline.prediction.drawn_errors import with_drawn_errors
from measureapp.pipeline.prediction.views import Exposing, PredictedScene
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.register.joint.registration_cache import RegistrationCache
from measureapp.register.stitch import stitch

VIEWS_SHARE = 0.6  # of the progress


@dataclass(frozen=True, slots=True, eq=False)
class Job:
    """What is to be measured: the program, and the nominal that its points are predicted on."""

    program: InspectionProgram
    nominal: Mesh


@dataclass(frozen=True, slots=True, eq=False)
class Prediction:
    """The predicted result of a scan."""

    views: tuple[ViewResult, ...]  # those that see something of the part
    stitched: StitchedCloud
    dimensions: tuple[Dimension, ...]
    features: tuple[Feature, ...]  # in the nominal's frame
    source: str  # where the rig's calibration is from, in words

    def uncertainty(self, name: str) -> float | None:
        """Return U (k = 2) of a dimension; None where it is not measured."""
        return next((one.uncertainty for one in self.dimensions if one.name == name), None)


def predict_uncertainty(plan: ScanPlan, scene: PredictedScene, job: Job, progress: Progress | None = None) -> Prediction:
    """Predict U of every dimension of a scan that was not taken yet.

    Points are predicted on the nominal with their noise, registered with the covariance of the rig's calibration as a scan's are, and
    inspected; the values are the nominal's, only their uncertainty is a result.

    Raises
    ------
    PlanError
        No viewpoint sees the part.
    MeasureError
        From registration and inspection, as after a scan.
    """
    progress = progress or NoProgress()
    views = predict_views(plan, scene, PartOf(progress, 0.0, VIEWS_SHARE))
    return evaluate(with_drawn_errors(views, scene.rig), scene, job, PartOf(progress, VIEWS_SHARE, 1.0))


def predict_views(plan: ScanPlan, scene: PredictedScene, progress: Progress) -> tuple[ViewResult, ...]:
    """Predict the views of a plan, without those that see nothing of the part. Raises PlanError when none does."""
    exposing = exposing_of(plan)
    views = []
    for number, viewpoint in enumerate(plan):
        progress.report(number, len(plan), f"predicting {viewpoint.id}")
        view = scene.predict(viewpoint, exposing(viewpoint))
        if view is not None and view.quality.accepted:
            views.append(view)
    progress.report(1, 1, "views predicted")
    if not views:
        raise PlanError(
            f"No viewpoint of the plan {plan.name} gives a usable cloud of this part.", "Check where the part stands, and the exposures."
        )
    return tuple(views)


def exposing_of(plan: ScanPlan) -> Callable[[Viewpoint], Exposing]:
    """Return the patterns and exposures of every viewpoint."""
    longest_us = max(plan.exposures_of(viewpoint)[0] for viewpoint in plan)
    return lambda viewpoint: Exposing(plan.patterns, plan.exposures_of(viewpoint), longest_us)


def evaluate(
    views: Sequence[ViewResult], scene: PredictedScene, job: Job, progress: Progress | None = None, cache: RegistrationCache | None = None
) -> Prediction:
    """Register and inspect predicted views as those of a scan."""
    progress, rig = progress or NoProgress(), scene.rig
    stitched = stitch(
        [view.cloud for view in views],
        [view.part_from_camera for view in views],
        stitch_settings(rig.calibration, views),
        PartOf(progress, 0.0, 0.7),
        prior=pose_prior(rig.uncertainty, views),
        registration_cache=cache,
    )
    settings = inspection_settings(rig.calibration, rig.description, views)
    found = inspect(stitched, with_designed_standards(job.program), job.nominal, settings, PartOf(progress, 0.7, 1.0))
    return Prediction(tuple(views), stitched, found.dimensions, found.features, rig.source)
