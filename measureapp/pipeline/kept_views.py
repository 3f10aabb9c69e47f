"""Views of the last results that need not be computed again: what they were computed from is what it was, or their images are gone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from measureapp.data.calibration import CameraArrayCalibration, RigCalibration
from measureapp.data.measurement import Measurement, ViewResult
from measureapp.errors import StorageError
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.axes_check import before_axes_check
from measureapp.project import raw_images
from measureapp.project.calibration.camera_file import cameras_document
from measureapp.project.documents import digest
from measureapp.project.folder import ProjectFolder
from measureapp.project.inputs import fingerprint


@dataclass(frozen=True, slots=True, eq=False)
class KeptViews:
    """Views of the last results that are used again, by their viewpoint."""

    views: Mapping[str, ViewResult]
    unchanged: int  # of which the stored images would give the same cloud again
    placed_anew: bool  # one of these lies elsewhere on the part than it did
    former: Measurement | None = None  # the last results, where all their views are kept


def kept_views(project: ProjectFolder, calibration: RigCalibration, settings: DecodeSettings) -> KeptViews:
    """Return the views whose clouds would come out as they are, placed where the axes say now, and those whose images were dropped.

    The images of a view are compared with their checksums first, unless size and time of their files are those with which they were found
    equal before: where one is damaged, the view is not kept, and computing it says so.
    Damaged results keep nothing, as `process` makes them anew; but where images were dropped they raise StorageError.
    """
    removed, last = views_without_images(project), _former(project)
    former = {**({} if last is None else {view.viewpoint_id: view for view in last.views}), **removed}
    unchanged = {
        name: _placed(view, calibration)
        for name, view in former.items()
        if view.made_from and view.made_from == made_from(project, name, calibration.cameras, settings) and _images_are_whole(project, name)
    }
    moved = any(not np.array_equal(view.part_from_camera.matrix, former[name].part_from_camera.matrix) for name, view in unchanged.items())
    views = {**removed, **unchanged}
    return KeptViews(views, len(unchanged), moved, last if views.keys() == former.keys() else None)


def views_without_images(project: ProjectFolder) -> dict[str, ViewResult]:
    """Return the views of the last results whose images were removed, by their viewpoint; nothing else can be computed of them.

    They stay as they were computed, also where the calibration has changed since. Raises StorageError where results are damaged.
    """
    if project.journal.contents() is None:
        return {}
    removed = {one.viewpoint_id for one in raw_images.list_raw(project.journal) if one.state == "removed"}
    measurement = project.measurement() if removed else None
    return {} if measurement is None else {view.viewpoint_id: view for view in measurement.views if view.viewpoint_id in removed}


def made_from(project: ProjectFolder, viewpoint_id: str, cameras: CameraArrayCalibration, settings: DecodeSettings) -> str:
    """Return a hash of everything from which the cloud of a stored viewpoint is computed; empty where the journal does not know its images.

    These are the images with their patterns and read-back, the cameras (and projector) with all their numbers, the settings of decoding
    with the noise of the cameras, and the program itself. When and from which images the cameras were calibrated changes no point.
    """
    contents = project.journal.contents()
    stack = None if contents is None else contents.files.get(f"stacks/{viewpoint_id}/stack.json")
    if stack is None:
        return ""
    document = cameras_document(cameras)
    for part in (document, document.get("projector") or {}):
        part.pop("provenance", None)
    return digest({"stack": stack.sha256, "cameras": document, "settings": settings.model_dump(mode="json"), "program": fingerprint()})


def _former(project: ProjectFolder) -> Measurement | None:
    """Return the last results; None where there are none, or they cannot be read."""
    try:
        return project.measurement()
    except StorageError:
        return None


def _placed(view: ViewResult, calibration: RigCalibration) -> ViewResult:
    """Return a view as its stored images would give it again, at the place that the axes say."""
    return replace(before_axes_check(view), part_from_camera=calibration.part_from_camera(view.readback), timings_s={})


def _images_are_whole(project: ProjectFolder, viewpoint_id: str) -> bool:
    """Whether all files of a stored viewpoint are there and as they were stored."""
    contents = project.journal.contents()
    if contents is None:
        return False
    names = [name for name, owner in contents.owner.items() if owner == viewpoint_id and name.startswith("stacks/")]
    return all(project.journal.is_unchanged(name, contents.files[name]) for name in names)
