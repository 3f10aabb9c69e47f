"""Import of a recording: checked, then stored as a project that is there as a whole or not at all."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

from measureapp.arrays import ImageArray, read_only
from measureapp.data.board import BoardView
from measureapp.data.fringe import AxisReadback, PatternSet
from measureapp.data.pattern_sets import make_pattern_sets
from measureapp.data.plan import ExposureBracket, FlangePose, ScanPlan, Viewpoint
from measureapp.errors import InputError, MeasureError, StorageError
from measureapp.pipeline.recording.axes import board_view_id, readback_of
from measureapp.pipeline.recording.check import CheckedRecording, check_recording
from measureapp.pipeline.recording.images import check_image
from measureapp.pipeline.recording.motions import moved_axes
from measureapp.pipeline.recording.problems import Problems
from measureapp.pipeline.recording.stages import missing_stages
from measureapp.progress import PartOf, Progress
from measureapp.project.calibration.camera_file import write_cameras
from measureapp.project.calibration.recording_file import KNOWN_CAMERAS, RecordingNote, read_note, write_note
from measureapp.project.folder import DEFAULT_BOARD, ProjectFolder, ProjectSettings
from measureapp.project.folder_lock import lock_folder
from measureapp.project.fringes.manifest import read_manifest
from measureapp.project.images import read_image

BOARD_SHARE = 0.3  # of the progress


@dataclass(frozen=True, slots=True)
class Imported:
    """An imported recording."""

    project: ProjectFolder
    board_views: int
    viewpoints: int
    missing: dict[str, str]  # stage of processing -> why the recording does not suffice for it
    was_there: bool  # the same recording was imported before; nothing was written


def import_recording(path: Path, into: Path, progress: Progress) -> Imported:
    """Make a project of a recording.

    The project is built beside its place and moved there when it is complete. A project of the same recording is left as it is.

    Raises
    ------
    InputError, DecodeError
        The recording cannot be used; or the folder contains something else.
    StorageError
        The project cannot be written, or there is not enough disk space; nothing is left.
    """
    into = Path(into)
    checked = check_recording(Path(path))
    if _is_there(into, checked):
        return _answer(ProjectFolder.open(into), checked, was_there=True)
    with _built_beside(into) as place:
        _write(place, into, checked, progress)
    return _answer(ProjectFolder.open(into), checked, was_there=False)


def _answer(project: ProjectFolder, checked: CheckedRecording, *, was_there: bool) -> Imported:
    recording = checked.recording
    return Imported(project, len(recording.board_view), len(recording.viewpoint), missing_stages(project), was_there)


def _is_there(into: Path, checked: CheckedRecording) -> bool:
    """Whether the folder holds this recording already. Raises InputError where it holds something else."""
    if not into.exists() or (into.is_dir() and not any(into.iterdir())):
        return False
    note = read_note(into) if (into / "project.json").is_file() else None
    if note is None:
        raise InputError(f"{into} is not an empty folder.", "Give a new or an empty folder for the project.")
    if note.digest != checked.digest:
        raise InputError(
            f"{into} contains another recording, or an earlier state of {checked.path.name}.",
            "Import into a new folder, or delete that one first.",
        )
    return True


@contextmanager
def _built_beside(into: Path) -> Iterator[Path]:
    """Provide a folder that becomes ``into`` if the body succeeds, and is removed if it does not."""
    into = into.absolute()
    workshop = into.with_name(f".{into.name}.importing")
    building = workshop / "project"
    try:
        workshop.mkdir(parents=True, exist_ok=True)
        with lock_folder(workshop):
            shutil.rmtree(building, ignore_errors=True)  # of an import that was killed
            try:
                yield building
                if into.exists():
                    into.rmdir()  # it is empty
                building.rename(into)
            finally:
                shutil.rmtree(building, ignore_errors=True)
    except OSError as error:
        raise StorageError(
            f"{into} cannot be written: {error.strerror or error}.", "Check permissions and space, or choose another folder."
        ) from error
    finally:
        if workshop.is_dir() and not building.exists():
            shutil.rmtree(workshop, ignore_errors=True)


def _write(place: Path, into: Path, checked: CheckedRecording, progress: Progress) -> None:
    """Write the whole project into the folder ``place``."""
    name = into.absolute().name
    settings = ProjectSettings(name=name, part=checked.part or name, rig=checked.rig, board=checked.board or DEFAULT_BOARD)
    ProjectFolder(place, settings).frames.require_space(_bytes_needed(checked))
    project = ProjectFolder.create(place, settings)
    _write_board_views(project, checked, PartOf(progress, 0.0, BOARD_SHARE))
    _write_stacks(project, checked, PartOf(progress, BOARD_SHARE, 1.0))
    part = checked.recording.part
    project.save_inspection(*(None if file is None else checked.folder / file for file in (part.program, part.nominal)))
    if checked.cameras is not None:
        write_cameras(place / "calibration" / KNOWN_CAMERAS, checked.cameras)
    write_note(
        place,
        RecordingNote(
            source=checked.path.name,
            digest=checked.digest,
            axes=checked.views.axes,
            in_cell=checked.views.in_cell,
            loose=checked.views.loose,
            cameras_known=checked.cameras is not None,
        ),
    )
    progress.report(1, 1, "imported")


def _bytes_needed(checked: CheckedRecording) -> int:
    pixels = sum(camera.width_px * camera.height_px * (1 if camera.bit_depth == 8 else 2) for camera in checked.rig.cameras)
    return pixels * (len(checked.recording.board_view) + sum(layout.images for layout in checked.layouts.values()))


def _write_board_views(project: ProjectFolder, checked: CheckedRecording, progress: Progress) -> None:
    """Store all views of the board. Raises InputError with all images that cannot be used."""
    views, problems = checked.recording.board_view, Problems(checked.path)
    cameras = {camera.name: camera for camera in checked.rig.cameras}
    for index, view in enumerate(views):
        progress.report(index, len(views), f"board view {index + 1}")
        images: dict[str, ImageArray] = {}
        for camera, named in view.images.items():
            with problems.gathered():
                file = checked.folder / named
                images[camera] = read_only(read_image(file))
                check_image(f"[[board_view]] {index + 1}", file, images[camera], cameras[camera])
        if not problems:
            project.save_board_view(BoardView(board_view_id(index, len(views)), images, readback_of(view)))
    problems.raise_all()


def _write_stacks(project: ProjectFolder, checked: CheckedRecording, progress: Progress) -> None:
    """Store the plan and all fringe images."""
    viewpoints = checked.recording.viewpoint
    if not viewpoints:
        return
    first = checked.layouts[viewpoints[0].id]
    planned = [
        Viewpoint(
            id=one.id,
            flange=one.base_from_flange or FlangePose(position_mm=(0.0, 0.0, 0.0), quaternion_wxyz=(1.0, 0.0, 0.0, 0.0)),
            guide_mm=one.guide_mm or 0.0,
            table_deg=one.table_deg or 0.0,
        )
        for one in viewpoints
    ]
    named = _named(first.patterns, checked)
    bracket = ExposureBracket(exposures_us=first.exposures_us)
    project.save_plan(ScanPlan(name=project.name, viewpoints=tuple(planned), patterns=named, bracket=bracket))
    approaches = _approaches([readback_of(one) for one in viewpoints])
    for index, one in enumerate(viewpoints):
        progress.report(index, len(viewpoints), one.id)
        try:
            stack = read_manifest(checked.folder / one.manifest)
        except MeasureError as error:
            raise type(error)(f"{checked.path}, viewpoint {one.id!r}: {error.message}", error.hint) from error
        project.frames.store(
            replace(
                stack,
                viewpoint_id=one.id,
                patterns=_named(stack.patterns, checked),
                readback=readback_of(one),
                approach=approaches[index] if checked.views.axes else None,
            )
        )
        del stack  # before the next one is read


def _named(patterns: PatternSet, checked: CheckedRecording) -> PatternSet:
    """Return the patterns with the name of the predefined set that they are, or one that states their pitches."""
    projector = checked.rig.projector
    for known in make_pattern_sets(max(projector.width_px, 64), max(projector.height_px, 64)).values():
        if known.groups == patterns.groups and known.shift_sign == patterns.shift_sign:
            return patterns.model_copy(update={"name": known.name})
    pitches = ", ".join(f"{pitch:.4g}" for pitch in dict.fromkeys(patterns.pitches_px))
    return patterns.model_copy(update={"name": f"recorded, {pitches} px"})


def _approaches(readbacks: list[AxisReadback]) -> list[str]:
    """Number the approaches of the robot: neighbouring viewpoints with equal poses of robot and guide share one."""
    numbers = [0]
    for before, after in pairwise(readbacks):
        numbers.append(numbers[-1] + int(bool({"robot", "guide"} & moved_axes([before, after]))))
    return [f"recorded {number}" for number in numbers]
