"""After the first cloud of a scan: does the part stand where the plan assumes it?"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from measureapp.data.calibration import RigCalibration
from measureapp.data.measurement import ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.part_pose import PartPose
from measureapp.data.rig import RigDescription
from measureapp.errors import MeasureError
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.alignment.best_fit import best_fit
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.events import Event, PartElsewhere, ViewReady
from measureapp.pipeline.part_on_table import assumed_pose
from measureapp.pipeline.surroundings import exclude_surroundings
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh

FAR_MM = 8.0  # of half of the points: what a hand and the table's height in a description are off by is less
POINTS, FITTED_POINTS = 3000, 40_000
CONSEQUENCE = "Collisions and coverage were checked for the pose of the plan: stop, and place the part as planned or correct the pose"


def watch_part(
    project: ProjectFolder, calibration: RigCalibration | None, rig: RigDescription, on_event: Callable[[Event], None]
) -> Callable[[Event], None]:
    """Return a receiver that passes all events on, and adds a `PartElsewhere` after the first cloud where the part is not as planned.

    The comparison runs where the cloud was computed, once; where it cannot be made, nothing is said.
    """
    if project.nominal is None or calibration is None:
        return on_event
    nominal, plan, waiting = project.nominal, project.plan(), [True]
    pose = None if plan is None else plan.part_pose

    def receive(event: Event) -> None:
        on_event(event)
        if isinstance(event, ViewReady) and event.view.quality.accepted and waiting:
            waiting.clear()
            try:
                sentence = displacement(event.view, read_mesh(nominal, "nominal"), pose, calibration, rig)
            except MeasureError:
                return
            if sentence:
                on_event(PartElsewhere(event.view.viewpoint_id, sentence))

    return receive


def displacement(view: ViewResult, nominal: Mesh, pose: PartPose | None, calibration: RigCalibration, rig: RigDescription) -> str:
    """State where a part is that is not where its pose says, by the best fit of one view; empty where it is, or where no table is described.

    Raises
    ------
    InspectionError
        From the best fit, where it refuses the size of the cloud.
    """
    if not rig.table.is_described:
        return ""
    surface = NominalSurface(nominal)
    assumed = assumed_pose(nominal, pose, calibration, rig)
    view = exclude_surroundings([view], nominal, pose, calibration, rig)[0][0]
    cloud = view.cloud.seen_from(view.part_from_camera)
    some = assumed.inverse().apply(cloud.points_mm[:: max(1, len(cloud) // POINTS)])
    off_mm = float(np.median(np.abs(signed_distances(some, surface))))
    if off_mm <= FAR_MM:
        return ""
    told = f"The part is not where the plan assumes it ({(pose or PartPose()).words}): half of the points of the first cloud are more than {off_mm:.0f} mm off."
    try:
        fitted = best_fit(MeasuredPoints.of(cloud).thin(FITTED_POINTS), surface)
    except MeasureError:
        return f"{told} {CONSEQUENCE}."
    found = RigidTransform(fitted.nominal_from_part.matrix, "nominal", "part").inverse() @ assumed.inverse()
    shift = float(np.linalg.norm(found.apply(assumed.translation_mm) - assumed.translation_mm))
    turn = float(np.degrees(found.angle_rad))
    return f"{told} By its best fit it is displaced by {shift:.0f} mm and turned by {turn:.0f}°. {CONSEQUENCE}."
