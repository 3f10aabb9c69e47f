"""Calibration, stitched cloud and surface of the last results that need not be computed again, recognised as `kept_views` does clouds.

Each is kept with a hash of everything that it was computed from, the program included; an equal hash computes equal numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import StitchedCloud
from measureapp.data.consistency import Consistency
from measureapp.data.measurement import Measurement, ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.surroundings import SURROUNDINGS
from measureapp.data.view_choices import ViewChoices
from measureapp.errors import StorageError
from measureapp.project.calibration import store
from measureapp.project.documents import digest, readback_document, rig_calibration_document
from measureapp.project.folder import ProjectFolder
from measureapp.project.inputs import fingerprint

BOARD_VIEWS, UNCERTAINTY = "calibration/views", "calibration/rig_uncertainty.npz"


@dataclass(frozen=True, slots=True, eq=False)
class StitchedViews:
    """All clouds as one, with what the checks of the error model say of it."""

    views: Sequence[ViewResult]  # those whose axes contradict the images are not accepted
    stitched: StitchedCloud
    consistency: Consistency
    surroundings: str = ""  # which points of them are not the part's, in a sentence
    mesh: Mesh | None = None  # its surface, where that is kept, too


def calibration_made_from(project: ProjectFolder) -> str:
    """Return a hash of everything from which the rig is calibrated; empty where the journal does not know all images of the board."""
    contents, folder = project.journal.contents(), project.path / BOARD_VIEWS
    if contents is None:
        return ""
    known = {name: state.sha256 for name, state in contents.files.items() if name.startswith(f"{BOARD_VIEWS}/")}
    if not known or {path.relative_to(project.path).as_posix() for path in folder.glob("*/*")} != known.keys():
        return ""
    settings = project.settings.model_dump(mode="json")
    return digest({"images": known, "board": settings["board"], "rig": settings["rig"], "program": fingerprint()})


def kept_calibration(project: ProjectFolder) -> RigCalibration | None:
    """Return the stored calibration where the stored images of the board would give it again; None where they might not.

    Images, calibration and its uncertainty are compared with their checksums first.
    """
    made_from = calibration_made_from(project)
    if not made_from or store.made_from(project.path / "calibration") != made_from:
        return None
    contents = project.journal.contents()
    assert contents is not None  # else there is no hash
    whole = all(project.journal.is_unchanged(name, state) for name, state in contents.files.items() if name.startswith(f"{BOARD_VIEWS}/"))
    try:
        return project.calibration() if whole and project.rig_uncertainty() is not None else None
    except StorageError:
        return None


def stitched_made_from(
    project: ProjectFolder,
    calibration: RigCalibration,
    views: Sequence[ViewResult],
    choices: ViewChoices,
    approaches: Sequence[str] | None,
) -> str:
    """Return a hash of everything from which clouds are stitched and checked; empty where it is not known from what a cloud was computed.

    These are the clouds where the axes place them, the choices made by hand, the calibration with its uncertainty, and what tells the part
    from its surroundings: the nominal, its place in the plan, and the rig.
    """
    contents = project.journal.contents()
    if contents is None or not all(view.made_from for view in views):
        return ""
    uncertainty = contents.files.get(UNCERTAINTY)
    return digest(
        {
            "views": [
                [view.viewpoint_id, view.made_from, view.part_from_camera.matrix.tolist(), readback_document(view.readback)]
                for view in views
            ],
            "calibration": rig_calibration_document(calibration),
            "uncertainty": "" if uncertainty is None else uncertainty.sha256,
            "approaches": approaches,
            "nominal": {name: state.sha256 for name, state in contents.files.items() if name.startswith("inspection/nominal.")},
            "plan": plan.sha256 if (plan := contents.files.get("plan.json")) else "",
            "rig": project.rig().model_dump(mode="json"),
            "choices": choices.model_dump(mode="json"),
            "program": fingerprint(),
        }
    )


def kept_stitched(former: Measurement | None, made_from: str) -> StitchedViews | None:
    """Return the stitched cloud of former results, with their surface, where it was made from the same; None where not."""
    if former is None or not made_from or former.stitched_from != made_from:
        return None
    return StitchedViews(former.views, former.stitched, former.consistency, str(former.settings.get(SURROUNDINGS, "")), former.mesh)
