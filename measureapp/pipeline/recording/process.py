"""Processing of an imported recording: the whole job where it suffices, else what it does suffice for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.data.measurement import ViewResult
from measureapp.errors import CalibrationError, ReconstructError, RegistrationError
from measureapp.language.languages import ENGLISH
from measureapp.pipeline.assemble import assemble
from measureapp.pipeline.documents import view_figures
from measureapp.pipeline.events import CalibrationReady, Event, ViewReady
from measureapp.pipeline.measure import compute_clouds
from measureapp.pipeline.recording.learn import Learnt, learn, stationary_rig
from measureapp.pipeline.recording.stages import missing_stages, recorded, why_not_placed
from measureapp.pipeline.run import Outcome, finish
from measureapp.pipeline.validity import check_stored_images
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.atomic import remove, write_json
from measureapp.project.calibration.camera_file import cameras_document, write_cameras
from measureapp.project.calibration.store import CAMERAS, RIG
from measureapp.project.documents import link_document
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import write_cloud
from measureapp.project.results import cloud_path

OnEvent = Callable[[Event], None]
LINKS_FILE = "links.json"  # links of the rig that were calibrated where they do not make a whole rig


@dataclass(frozen=True, slots=True, eq=False)
class RecordingOutcome:
    """Results of processing a recording as far as it suffices."""

    document: dict[str, Any]
    whole: Outcome | None  # None: the recording does not suffice for a measurement
    missing: Mapping[str, str]  # stage -> what the recording lacks for it
    failed: Mapping[str, str]  # stage -> why it did not succeed although its images are there


def process_recording(project: ProjectFolder, on_event: OnEvent, progress: Progress, language: str = ENGLISH) -> RecordingOutcome:
    """Calibrate from the board views, compute the clouds, and measure the part with a report, each as far as the recording suffices for it.

    Raises
    ------
    InputError
        The project was not imported from a recording.
    CalibrationError
        The cameras are neither known nor can they be calibrated.
    ReconstructError
        No viewpoint gives a cloud.
    """
    watch = Stopwatch()
    with project.lock():
        missing, found = missing_stages(project), recorded(project)
        if "cameras" in missing:
            raise CalibrationError(missing["cameras"], "Add board views or a cameras.json to the recording, and import it again.")
        with watch.stage("calibration"):
            learnt = learn(project, PartOf(progress, 0.0, 0.2))
            files = _save_calibration(project, learnt)
        failed = dict(learnt.failed)
        views: tuple[ViewResult, ...] = ()
        if "clouds" not in missing:
            views = _clouds(project, learnt, on_event, PartOf(progress, 0.2, 0.7), watch)
            if len(views) < len(found.viewpoints):
                failed["clouds"] = f"{len(found.viewpoints) - len(views)} of {len(found.viewpoints)} viewpoints give no cloud."
        whole = None
        if learnt.rig is not None and views:
            try:
                measurement = assemble(project, learnt.rig, views, on_event, PartOf(progress, 0.7, 0.95), watch)
                whole = finish(project, measurement, watch, language, PartOf(progress, 0.95, 1.0))
            except RegistrationError as error:
                failed["stitch"] = str(error)
        elif failed and "stitch" not in missing:
            failed["stitch"] = why_not_placed(found, learnt.links)
        document = whole.document if whole is not None else _partial_document(project, learnt, views, watch, files)
    return RecordingOutcome({**document, "missing": missing, "failed": failed}, whole, missing, failed)


def _save_calibration(project: ProjectFolder, learnt: Learnt) -> dict[str, Path]:
    """Store the rig, or what there is of it; return the files."""
    folder = project.path / "calibration"
    if learnt.rig is not None:
        project.save_calibration(learnt.rig, learnt.uncertainty)
        return {"cameras": folder / CAMERAS, "rig": folder / RIG}
    remove(folder / RIG)  # of other cameras
    write_cameras(folder / CAMERAS, learnt.cameras)
    if not learnt.links:
        return {"cameras": folder / CAMERAS}
    write_json(folder / LINKS_FILE, {"schema_version": 1, **{name: link_document(link) for name, link in learnt.links.items()}})
    return {"cameras": folder / CAMERAS, "links": folder / LINKS_FILE}


def _clouds(project: ProjectFolder, learnt: Learnt, on_event: OnEvent, progress: Progress, watch: Stopwatch) -> tuple[ViewResult, ...]:
    """Compute and write the clouds of all viewpoints in their camera frames. Raises ReconstructError when there is none."""

    def without_places(event: Event) -> None:
        if not isinstance(event, ViewReady):  # its place on the part is not known
            on_event(event)

    if learnt.rig is not None:
        on_event(CalibrationReady(learnt.rig))
        check_stored_images(project, learnt.rig)
    placed = learnt.rig is not None
    rig = learnt.rig or stationary_rig(learnt.cameras)
    views = compute_clouds(project, rig, on_event if placed else without_places, progress, watch)
    if not views:
        raise ReconstructError("No viewpoint gives a cloud; the reasons are stated above.", "Check the images and their manifests.")
    with watch.stage("saving"):
        for view in views:
            write_cloud(cloud_path(project.results, view.viewpoint_id), view.cloud)
    return views


def _partial_document(
    project: ProjectFolder, learnt: Learnt, views: tuple[ViewResult, ...], watch: Stopwatch, files: Mapping[str, Path]
) -> dict[str, Any]:
    """Return what `process` answers without a measurement, with the fields of a whole one."""
    cameras = {name: {"rms_px": one.rms_px, "serial": one.serial} for name, one in learnt.cameras.cameras.items()}
    links = {name: link_document(link) for name, link in learnt.links.items()}
    document = cameras_document(learnt.cameras)
    for name, camera in cameras.items():
        camera |= {
            field: document["cameras"][name][field] for field in ("matrix", "distortion", "reference_from_camera", "standard_deviations")
        }
    return {
        "calibration": {"cameras": cameras, "pair_rms_px": dict(learnt.cameras.pair_rms_px), **links},
        "views": [
            {
                "name": view.viewpoint_id,
                "points": len(view.cloud),
                "depth_mm": dict(zip(("p1", "p50", "p99"), np.percentile(view.cloud.points_mm[:, 2], [1, 50, 99]).tolist(), strict=True)),
                "frame": view.cloud.frame,
                "verdict": view.quality.reason or "good",
                **view_figures(view),
                "file": str(cloud_path(project.results, view.viewpoint_id)),
            }
            for view in views
        ],
        "stitch": None,
        "dimensions": [],
        "timings": {name: round(value, 3) for name, value in watch.seconds.items()},
        "files": {"project": str(project.path), **{name: str(file) for name, file in files.items()}},
    }
