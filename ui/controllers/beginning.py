"""How a session of a wizard begins: in a new folder, with the rig or with recorded images."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from measureapp.errors import InputError
from ui.controllers import collecting_work as work
from ui.controllers.collecting_nouns import Start
from ui.controllers.rig_connection import VIRTUAL
from ui.controllers.stored_sessions import next_folder, project_on_disk, sessions_folder
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Kind
    from measureapp.calibration_session.recorded import ReadbackFiles, RecordedView
    from measureapp.calibration_session.session import CalibrationSession
    from measureapp.data.rig import RigDescription


def begin_with_rig(kind: Kind, start: Start, session: Session) -> tuple[CalibrationSession, RigDescription]:
    """Return a new session and the rig that takes its images. Raises InputError where no rig is known."""
    from measureapp.project.atomic import write_text

    rig = session.rig
    if rig is None:
        raise InputError("No rig is known yet.", "Wait until it is loaded, or use recorded images.")
    if rig.driver == VIRTUAL and project_on_disk(session) is None:
        rig = rig.at_resolution(start.resolution).model_copy(update={"driver_settings": {**rig.driver_settings, "seed": start.seed}})
    made = _create(kind, start, tuple(camera.name for camera in rig.cameras), rig, session)
    write_text(made.folder / work.RIG_FILE, rig.model_dump_json(indent=2))
    return made, rig


def begin_with_images(kind: Kind, start: Start, folder: Path, session: Session) -> tuple[CalibrationSession, list[RecordedView]]:
    """Return a new session and the recorded views to fill it with.

    Raises
    ------
    InputError
        No images, a table that cannot be read or does not fit them, or axes without positions.
    CalibrationError
        Fringes in one direction only.
    """
    return _with_fringes(kind, start, folder, session) if kind.uses_fringes else _with_plain_images(kind, start, folder, session)


def _with_plain_images(kind: Kind, start: Start, folder: Path, session: Session) -> tuple[CalibrationSession, list[RecordedView]]:
    from measureapp.calibration_session.recorded import RecordedImages, readbacks_of
    from measureapp.project.calibration.recorded_boards import cameras_of, find_recorded

    positions = find_recorded(folder)
    readbacks = readbacks_of(positions, _tables(start), kind.readback_in_rig)
    made = _create(kind, start, cameras_of(positions), None, session)
    return made, [RecordedImages(position, readback) for position, readback in zip(positions, readbacks, strict=True)]


def _with_fringes(kind: Kind, start: Start, folder: Path, session: Session) -> tuple[CalibrationSession, list[RecordedView]]:
    from measureapp.calibration_session.recorded import RecordedFringeView
    from measureapp.project.fringes.recorded_fringes import fringes_in

    recorded = fringes_in(folder)
    made = _create(kind, start, recorded.cameras, None, session, recorded.projector_px)
    return made, [RecordedFringeView(recorded, number) for number in range(len(recorded.manifests))]


def _tables(start: Start) -> ReadbackFiles:
    from measureapp.calibrate.draft.draft import ALL_AXES
    from measureapp.calibration_session.recorded import ReadbackFiles

    return ReadbackFiles(*(start.tables.get(name) for name in ALL_AXES))


def _create(
    kind: Kind,
    start: Start,
    names: tuple[str, ...],
    rig: RigDescription | None,
    session: Session,
    projector_px: tuple[int, int] | None = None,
) -> CalibrationSession:
    """The rig's reference camera comes first, where it is among them."""
    from measureapp.calibrate.draft.draft import Known, Setup
    from measureapp.calibration_session.session import CalibrationSession

    reference = "" if session.rig is None else session.rig.reference
    ordered = tuple(sorted(names, key=lambda name: name != reference))
    setup = Setup.on_rig(kind, start.board, ordered, Known(session.cameras, session.calibration), rig, projector_px)
    return CalibrationSession.create(next_folder(sessions_folder(project_on_disk(session)), kind.name), setup)
