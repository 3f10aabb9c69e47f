"""Inputs of `calibrate collect`: settings of a session, sources of images, and the result for comparison."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from measureapp.calibrate.draft.draft import Limits, Setup
from measureapp.calibrate.kinds.table import find_kind
from measureapp.calibrate.motions.axis_noise import expected_noise
from measureapp.calibration_session.accepting import read_result
from measureapp.calibration_session.recorded import ReadbackFiles, add_fringes, add_recorded, add_views
from measureapp.calibration_session.session import CalibrationSession
from measureapp.cli.calibrate.options import BoardChoice
from measureapp.errors import InputError, MeasureError
from measureapp.progress import Progress
from measureapp.project.calibration.board_images import find_board_images
from measureapp.project.calibration.camera_file import read_cameras
from measureapp.project.folder import ProjectFolder
from measureapp.project.fringes.recorded_fringes import fringes_named

if TYPE_CHECKING:
    from measureapp.calibrate.draft.estimate import Calibrated
    from measureapp.calibrate.motions.axis_noise import AxisNoise
    from measureapp.cli.calibrate.collect_options import SessionStart
    from measureapp.data.calibration import HandEye

USABLE_OVER_GOOD = 4.0  # where only one of the two is given


@dataclass(frozen=True, slots=True)
class Sources:
    """Where observations come from."""

    images: tuple[str, ...]
    fringes: tuple[str, ...]
    project: Path | None
    readbacks: ReadbackFiles

    def camera_names(self) -> tuple[str, ...]:
        """Return the cameras that the images, the fringes or the project name. Raises InputError where there are none."""
        if self.fringes:
            return fringes_named(self.fringes).cameras
        if self.images:
            return find_board_images(self.images).cameras
        if self.project is not None:
            rig = ProjectFolder.open(self.project).rig()
            return (rig.reference, *(camera.name for camera in rig.cameras if camera.name != rig.reference))
        raise InputError("A new session needs images.", "Give --images left='folder/left*.png', or --views PROJECT.")


@dataclass(frozen=True, slots=True, eq=False)
class Given:
    """The options that a new session starts with; a session that is continued has its own.

    With a project, the errors of robot and table follow from its rig's data sheets, not from `noise`.
    """

    kind: str
    board: BoardChoice
    cameras: Path | None
    start: SessionStart
    noise: AxisNoise

    def setup(self, sources: Sources) -> Setup:
        """Return the setup of the session. Raises InputError naming the option that is wrong or missing."""
        kind = find_kind(self.kind)
        if kind.uses_fringes and not sources.fringes:
            raise InputError(f"A new session for {kind.words.subject} needs fringes.", "Give --fringes 'folder/*/MANIFEST.toml'.")
        names, start = sources.camera_names(), self.start
        if start.reference is not None and start.reference not in names:
            raise InputError(f"--reference {start.reference!r} is not among the cameras.", "Name one of: " + ", ".join(names) + ".")
        first = start.reference or names[0]
        project = None if sources.project is None else ProjectFolder.open(sources.project)
        rig = None if project is None else project.rig()
        return Setup(
            kind=kind,
            board=self.board.description() if self.board != BoardChoice() or project is None else project.settings.board,
            camera_names=(first, *(name for name in names if name != first)),
            cameras=None if self.cameras is None else read_cameras(self.cameras),
            hand_eye=None if start.hand_eye is None else _hand_eye(start.hand_eye),
            noise=self.noise if rig is None else expected_noise(rig),
            distortion_count=start.distortion,
            standoff_mm=start.standoff_mm if start.standoff_mm is not None or rig is None else rig.standoff_mm,
            serials={} if rig is None else {camera.name: camera.serial for camera in rig.cameras},
            projector_px=fringes_named(sources.fringes).projector_px if kind.uses_fringes else None,
        )


def open_session(folder: Path, given: Given, sources: Sources) -> CalibrationSession:
    """Continue the session in ``folder``, or start it. Raises InputError where the options contradict the session there."""
    find_kind(given.kind)
    if not CalibrationSession.is_in(folder):
        return CalibrationSession.create(folder, given.setup(sources))
    session = CalibrationSession.open(folder)
    setup = session.setup
    if setup.kind.name != given.kind:
        raise InputError(f"{folder} is a session for {setup.kind.name}, not for {given.kind}.", "Name that kind, or another folder.")
    if given.board.board is not None and given.board.description() != setup.board:
        raise InputError(f"The session in {folder} uses a {setup.board.label}.", "Omit the options of the board, or start a new session.")
    return session


def add_sources(session: CalibrationSession, sources: Sources, progress: Progress) -> list[str]:
    """Add what the options name and is not in the session yet; return the ids of the new observations.

    A session that holds nothing is not kept where its first images cannot be used.
    """
    try:
        return _add(session, sources, progress)
    except MeasureError:
        session.discard_empty()
        raise


def _add(session: CalibrationSession, sources: Sources, progress: Progress) -> list[str]:
    added = []
    if sources.fringes:
        added += [one.id for one in add_fringes(session, fringes_named(sources.fringes), progress)]
    if sources.images:
        added += [one.id for one in add_recorded(session, find_board_images(sources.images), sources.readbacks, progress)]
    if sources.project is not None:
        views = ProjectFolder.open(sources.project).path / "calibration" / "views"
        added += [one.id for one in add_views(session, views, progress)]
    return added


def previous_result(path: Path) -> Calibrated:
    """Return the result for comparison: a session is solved, anything else is read. Raises InputError, CalibrationError."""
    if CalibrationSession.is_in(path):
        session = CalibrationSession.open(path)
        return session.setup.kind.result(session.solve())
    return read_result(path)


def _hand_eye(path: Path) -> HandEye:
    from measureapp.cli.calibrate.guide import read_hand_eye

    return read_hand_eye(path)


def limits_of(good_mm: float | None, usable_mm: float | None) -> Limits | None:
    """Return the limits of a verdict given by options; None for the usual ones of its kind. Raises InputError for limits that are none."""
    if good_mm is None and usable_mm is None:
        return None
    usable = usable_mm if usable_mm is not None else USABLE_OVER_GOOD * (good_mm or 0.0)
    good = good_mm if good_mm is not None else usable / USABLE_OVER_GOOD
    if not 0 < good <= usable < float("inf"):
        raise InputError(f"--good-mm {good:g} and --usable-mm {usable:g} are no limits.", "Give lengths above 0, the first no larger.")
    return Limits(good, usable, "as asked")
