"""Checks of a recording before anything is written: everything but the pixels."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from measureapp.data.board import AnyBoard
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.recording import Recording
from measureapp.data.rig import RECORDED, RigDescription
from measureapp.pipeline.recording.axes import MOVED_BY, RecordedViews, find_axes
from measureapp.pipeline.recording.described_rig import rig_of_cameras
from measureapp.pipeline.recording.images import is_deep
from measureapp.pipeline.recording.problems import Problems, list_places
from measureapp.pipeline.recording.stack_layout import StackLayout, check_layout, read_stack_layout
from measureapp.project.calibration.camera_file import read_cameras
from measureapp.project.calibration.certificate_file import with_lengths
from measureapp.project.calibration.recording_file import read_recording
from measureapp.project.geometry.files import read_mesh
from measureapp.project.images import read_image
from measureapp.project.program_file import read_program
from measureapp.project.rig_file import assume_axes, read_rig

HOW_RELATIVE = "Correct the path, which is relative to the recording's folder, or copy the file there."


@dataclass(frozen=True, slots=True, eq=False)
class CheckedRecording:
    """A recording whose parts fit together; the pixels of its images are still to be read."""

    path: Path
    recording: Recording
    rig: RigDescription
    views: RecordedViews
    layouts: Mapping[str, StackLayout]  # viewpoint -> its fringe images
    digest: str  # of the file, all files it names, and the sizes of all images
    board: AnyBoard | None = None
    cameras: CameraArrayCalibration | None = None  # known cameras
    part: str = ""  # name in the inspection program

    @property
    def folder(self) -> Path:
        """The folder to which paths are relative."""
        return self.path.parent


@dataclass(slots=True)
class _Parts:
    """The files of a recording, as far as they could be read."""

    board: AnyBoard | None = None
    cameras: CameraArrayCalibration | None = None
    rig: RigDescription | None = None
    part: str = ""
    layouts: dict[str, StackLayout] = field(default_factory=dict)


def check_recording(path: Path) -> CheckedRecording:
    """Read a recording and all files it names but the images, and check that they exist and fit together.

    Raises
    ------
    InputError, DecodeError
        With all problems found at once; each names file and place.
    """
    path = Path(path)
    recording, problems = read_recording(path), Problems(path)
    missing = {place: path.parent / file for place, file in recording.paths() if not (path.parent / file).is_file()}
    for place, file in missing.items():
        problems.note(f"{place}: {file} does not exist.", HOW_RELATIVE)
    parts = _read_parts(path, recording, problems, set(missing.values()))
    if parts.rig is not None:
        _check_rig(parts.rig, problems)
        _check_known(parts.rig, parts.cameras, problems)
        _check_board_views(recording, parts.rig, problems)
        for viewpoint in recording.viewpoint:
            if viewpoint.id in parts.layouts:
                check_layout(viewpoint.id, parts.layouts[viewpoint.id], parts.rig, problems)
    _check_twice(path.parent, recording, parts.layouts, problems)
    views = find_axes(recording, problems)
    problems.raise_all()
    assert parts.rig is not None  # otherwise there were problems
    rig = assume_axes(parts.rig, [MOVED_BY[axis] for axis in views.axes])
    digest = _digest(path, recording, parts.layouts)
    return CheckedRecording(path, recording, rig, views, parts.layouts, digest, parts.board, parts.cameras, parts.part)


def _read_parts(path: Path, recording: Recording, problems: Problems, missing: set[Path]) -> _Parts:
    """Read all files that exist; those that cannot be read are noted as problems."""
    parts, folder = _Parts(), path.parent

    def there(name: str | None) -> Path | None:
        return None if name is None or folder / name in missing else folder / name

    with problems.gathered():
        parts.cameras = None if (file := there(recording.cameras)) is None else read_cameras(file)
    if recording.board is not None:
        parts.board = recording.board.description()
        with problems.gathered():
            stated = recording.board
            parts.board = with_lengths(parts.board, there(stated.certificate), stated.board_class, stated.temperature)
    with problems.gathered():
        parts.part = "" if (file := there(recording.part.program)) is None else read_program(file).name
    with problems.gathered():
        if (file := there(recording.part.nominal)) is not None:
            read_mesh(file, "nominal")
    for viewpoint in recording.viewpoint:
        with problems.gathered():
            if (file := there(viewpoint.manifest)) is not None:
                parts.layouts[viewpoint.id] = read_stack_layout(file)
    with problems.gathered():
        if recording.rig is not None:
            parts.rig = None if (file := there(recording.rig)) is None else read_rig(file)
        elif parts.cameras is not None:
            parts.rig = _rig_of_cameras(path, parts, parts.cameras)
    return parts


def _rig_of_cameras(path: Path, parts: _Parts, cameras: CameraArrayCalibration) -> RigDescription:
    first = next(iter(parts.layouts.values()), None)
    depth = 8 if first is None or not is_deep(read_image(first.first_images[0][1])) else _bit_depth(first.saturation)
    exposures = (100_000,) if first is None else first.exposures_us
    projector = (1, 1) if first is None else (first.patterns.projector_px, first.patterns.projector_rows or first.patterns.projector_px)
    return rig_of_cameras(f"{path.resolve().parent.name} (recorded)", cameras, depth, projector, exposures)


def _bit_depth(saturation: int | None) -> int:
    """Return the smallest bit depth of images stored with 16 bit that reaches the saturation."""
    return next((depth for depth in (10, 12) if saturation is not None and saturation <= 2**depth), 16)


def _check_rig(rig: RigDescription, problems: Problems) -> None:
    if rig.driver != RECORDED:
        found = f"driver = {rig.driver!r}" if rig.driver else "a driver for each device"
        problems.note(f"the rig {rig.name!r} has {found}.", 'Write driver = "recorded" alone: a recording has no devices.')
    depths = {camera.bit_depth for camera in rig.cameras}
    if len(depths) > 1:
        problems.note(f"the rig's cameras have {' and '.join(map(str, sorted(depths)))} bit.", "Record all cameras with one bit depth.")


def _check_known(rig: RigDescription, cameras: CameraArrayCalibration | None, problems: Problems) -> None:
    """Note where the known cameras are not those of the rig."""
    if cameras is None:
        return
    named, known = {camera.name for camera in rig.cameras}, set(cameras.cameras)
    if named != known or cameras.reference != rig.reference:
        problems.note(
            f"the rig has the cameras {', '.join(sorted(named))} with {rig.reference} as reference, "
            f"cameras.json has {', '.join(sorted(known))} with {cameras.reference}.",
            "Give the calibration of these cameras, with the same reference.",
        )
        return
    for camera in rig.cameras:
        pinhole = cameras.cameras[camera.name].pinhole
        if (pinhole.width_px, pinhole.height_px) != (camera.width_px, camera.height_px):
            problems.note(
                f"camera {camera.name!r} has {camera.width_px} × {camera.height_px} px in the rig, "
                f"{pinhole.width_px} × {pinhole.height_px} px in cameras.json.",
                "Correct the rig, or give the calibration for this resolution.",
            )


def _check_board_views(recording: Recording, rig: RigDescription, problems: Problems) -> None:
    names = [camera.name for camera in rig.cameras]
    unknown: dict[str, list[str]] = {}
    for number, view in enumerate(recording.board_view, 1):
        for name in view.images:
            if name not in names:
                unknown.setdefault(name, []).append(f"[[board_view]] {number}")
    for name, places in unknown.items():
        problems.note(f"{list_places(places)}: the rig has no camera {name!r}.", f"Name its cameras: {', '.join(names)}.")


def _check_twice(folder: Path, recording: Recording, layouts: Mapping[str, StackLayout], problems: Problems) -> None:
    """Note the first image or manifest that is used in two places, by whatever path."""
    places: dict[Path, str] = {}
    for place, file in _images(folder, recording, layouts):
        if file in places:
            problems.note(
                f"{file} is used twice: {places[file]} and {place}.",
                "Use every file once; an image copied in place of another spoils both.",
            )
            return
        places[file] = place


def _images(folder: Path, recording: Recording, layouts: Mapping[str, StackLayout]) -> Iterator[tuple[str, Path]]:
    """Yield place and resolved path of all images of board and part, and of the manifests."""
    for number, view in enumerate(recording.board_view, 1):
        yield from ((f"[[board_view]] {number}, camera {name!r}", (folder / file).resolve()) for name, file in view.images.items())
    for viewpoint in recording.viewpoint:
        yield f"viewpoint {viewpoint.id!r}", (folder / viewpoint.manifest).resolve()
        if viewpoint.id in layouts:
            yield from ((f"viewpoint {viewpoint.id!r}", file.resolve()) for file in layouts[viewpoint.id].files)


def _digest(path: Path, recording: Recording, layouts: Mapping[str, StackLayout]) -> str:
    """Return the SHA-256 of the file and all files it names, and of the names and sizes of the images."""
    found, images = hashlib.sha256(path.read_bytes()), {file for _, file in _images(path.parent, recording, layouts)}
    manifests = {(path.parent / viewpoint.manifest).resolve() for viewpoint in recording.viewpoint}
    named = [(path.parent / file).resolve() for _, file in recording.paths()]
    for file in sorted({file for file in named if file not in images or file in manifests}):
        found.update(file.read_bytes())
    for file in sorted(images - manifests):
        found.update(f"{file.name} {file.stat().st_size}\n".encode())
    return found.hexdigest()
