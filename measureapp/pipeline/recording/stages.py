"""Which stages of processing a recording suffices for, and what it lacks for the others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

from measureapp.calibrate.cameras.camera import LEAST_VIEWS
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import AxisReadback
from measureapp.errors import InputError, StorageError
from measureapp.pipeline.recording.motions import (
    BoardReadback,
    axis_views,
    determines_rig,
    guide_views,
    hand_eye_views,
    moved_axes,
)
from measureapp.project.calibration import board_views
from measureapp.project.calibration.camera_file import read_cameras
from measureapp.project.calibration.recording_file import KNOWN_CAMERAS, NOTE, RecordingNote, read_note
from measureapp.project.folder import ProjectFolder

NAMES = {"hand_eye": "hand-eye", "guide": "the guide", "axis": "the table's axis"}
LINKS = ("hand_eye", "guide", "axis")
MOVED_BY = {"hand_eye": "robot", "guide": "guide", "axis": "table"}
READ = {"hand_eye": ("base_from_flange", "robot poses"), "guide": ("guide_mm", "guide positions"), "axis": ("table_deg", "table angles")}
NEEDED = {
    "hand_eye": "three board views from robot poses that differ by rotations, with the board at rest",
    "guide": "three board views along the guide, with the board at rest",
    "axis": "three board views at different table angles, with robot and guide at rest",
}


@dataclass(frozen=True, slots=True, eq=False)
class Recorded:
    """The contents of an imported project, without images."""

    note: RecordingNote
    camera_names: tuple[str, ...]
    known: CameraArrayCalibration | None
    board: tuple[BoardReadback, ...]  # views whose board stands on the table or in the cell
    board_views: int  # all of them, those without read-backs included
    viewpoints: tuple[AxisReadback, ...]

    @property
    def links(self) -> dict[str, list[BoardReadback]]:
        """Views from which each link of the rig can be solved; all views on the table for a joint solution."""
        on_table = [view for view in self.board if view.on_table]
        if determines_rig(on_table):
            return {name: on_table if name != "guide" or self.guide_moves(on_table) else [] for name in LINKS}
        return self.groups

    @property
    def groups(self) -> dict[str, list[BoardReadback]]:
        """Views from which each link can be solved on its own."""
        return {"hand_eye": hand_eye_views(self.board), "guide": guide_views(self.board), "axis": axis_views(self.board)}

    @staticmethod
    def guide_moves(views: Sequence[BoardReadback]) -> bool:
        """Whether the guide moves between these views."""
        return "guide" in moved_axes([view.axes for view in views])

    @property
    def needed(self) -> tuple[str, ...]:
        """Links of the rig without which the viewpoints cannot be placed relative to each other."""
        if len(self.viewpoints) < 2:
            return ()
        moved = moved_axes(self.viewpoints)
        if "table" in moved:  # the axis was seen from one pose of the cameras, the part perhaps from another
            moved |= moved_axes([*self.viewpoints, *(view.axes for view in self.links["axis"])]) & {"robot", "guide"}
        links = [link for link in LINKS if MOVED_BY[link] in moved]
        return ("hand_eye", *links) if "guide" in links and "hand_eye" not in links and self.robot_moves else tuple(links)

    @property
    def robot_moves(self) -> bool:
        """Whether the robot moves at all; where it does not, the cameras stand still in the base frame."""
        return "robot" in moved_axes([*self.viewpoints, *(view.axes for view in self.board)])

    @property
    def have_poses(self) -> bool:
        """Whether the viewpoints have read-backs, or there is only one."""
        return bool(self.note.axes) or len(self.viewpoints) < 2


def is_recording(project: ProjectFolder) -> bool:
    """Whether the project was imported from a recording."""
    return read_note(project.path) is not None


def recorded(project: ProjectFolder) -> Recorded:
    """Return what an imported project contains. Raises InputError when it was not imported, StorageError when it is damaged."""
    views = project.path / "calibration" / "views"
    project.journal.check(project.path / NOTE, project.path / "calibration" / KNOWN_CAMERAS, *views.glob("*/view.json"))
    note = read_note(project.path)
    if note is None:
        raise InputError(f"{project.path} was not imported from a recording.", "Import one with `measureapp import`.")
    stored = board_views.load_readbacks(views)
    standing = [BoardReadback(name, readback, name not in note.in_cell) for name, (_, readback) in stored.items() if name not in note.loose]
    names = [camera.name for camera in project.rig().cameras]
    known = read_cameras(project.path / "calibration" / KNOWN_CAMERAS) if note.cameras_known else None
    readbacks = []
    for viewpoint_id in project.stored_viewpoints():
        with suppress(StorageError):  # a damaged stack is reported where its images are used
            readbacks.append(project.frames.readback(viewpoint_id))
    return Recorded(note, tuple(names), known, tuple(standing), len(stored), tuple(readbacks))


def missing_stages(project: ProjectFolder) -> dict[str, str]:
    """Return stage -> what the recording lacks for it, in a sentence; empty if it suffices for the whole job."""
    found = recorded(project)
    missing: dict[str, str] = {}
    if found.known is None and found.board_views < LEAST_VIEWS:
        missing["cameras"] = f"There are {found.board_views} board views and no cameras.json; the cameras need {LEAST_VIEWS} board views."
    missing |= _missing_links(found)
    if not found.viewpoints:
        missing["clouds"] = "There are no viewpoints."
    elif "cameras" in missing:
        missing["clouds"] = "The cameras are neither known nor can they be calibrated."
    elif len(found.camera_names) == 1 and (found.known is None or found.known.projector is None):
        missing["clouds"] = "A single camera needs a calibrated projector; give a cameras.json with one, or a second camera."
    stitch = missing.get("clouds") or why_not_placed(found)
    if stitch:
        missing["stitch"] = stitch
    if stitch or project.program is None:
        missing["dimensions"] = stitch or "There is no inspection program."
    return missing


def _missing_links(found: Recorded) -> dict[str, str]:
    missing, views = {}, found.links
    for link in LINKS:
        field, words = READ[link]
        if field not in found.note.axes:
            missing[link] = f"There are no {words}."
        elif not views[link]:
            missing[link] = f"It needs {NEEDED[link]}."
        elif link == "guide" and found.robot_moves and not views["hand_eye"]:
            missing[link] = "It needs hand-eye first, because the robot moves."
    return missing


def why_not_placed(found: Recorded, links: Mapping[str, object] | None = None) -> str:
    """Return why the viewpoints cannot be placed relative to each other; empty if they can.

    Parameters
    ----------
    links : the links that were solved; None: those that could be tried
    """
    if not found.have_poses:
        return "The viewpoints have no read-backs, so each cloud stays in its camera frame."
    there = found.links if links is None else links
    lacking = [link for link in found.needed if not there.get(link)]
    if not lacking:
        return ""
    moving = _list([MOVED_BY[link] for link in lacking])
    words = _list([NAMES[link] for link in lacking])
    return f"Not calibrated: {words}. The {moving} may move between the viewpoints, so each cloud stays in its camera frame."


def _list(words: Sequence[str]) -> str:
    """Return words as part of a sentence: a, b and c."""
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))
