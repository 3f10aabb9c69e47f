"""Views whose raw images were dropped on purpose: their clouds are those of the last results."""

from __future__ import annotations

from measureapp.data.measurement import ViewResult
from measureapp.project import raw_images
from measureapp.project.folder import ProjectFolder


def views_without_images(project: ProjectFolder) -> dict[str, ViewResult]:
    """Return the views of the last results whose images were removed, by their viewpoint; nothing else can be computed of them.

    They stay as they were computed, also where the calibration has changed since. Raises StorageError where results are damaged.
    """
    if project.journal.contents() is None:
        return {}
    removed = {one.viewpoint_id for one in raw_images.list_raw(project.journal) if one.state == "removed"}
    measurement = project.measurement() if removed else None
    return {} if measurement is None else {view.viewpoint_id: view for view in measurement.views if view.viewpoint_id in removed}
