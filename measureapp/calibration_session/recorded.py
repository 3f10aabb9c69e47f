"""Filling a session from recorded images and tables of read-backs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibration_session.observation import CollectedObservation
from measureapp.calibration_session.session import CalibrationSession, ImagesThere
from measureapp.data.fringe import Readback
from measureapp.errors import InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.project.calibration.board_images import BoardImages
from measureapp.project.calibration.board_views import load_all
from measureapp.project.calibration.recorded_boards import RecordedPosition
from measureapp.project.frame_store import checksum
from measureapp.project.fringes.recorded_fringes import RecordedFringes
from measureapp.project.images import read_image
from measureapp.project.tables import read_angles, read_guide, read_poses, require_millimetres


@dataclass(frozen=True, slots=True)
class ReadbackFiles:
    """Tables that belong to recorded images, one line per position in the order of the sorted images; None where there is none."""

    robot_poses: Path | None = None  # base_from_flange: name,x_mm,y_mm,z_mm,qw,qx,qy,qz
    guide_positions: Path | None = None  # name,position_mm
    table_angles: Path | None = None  # position,angle_deg

    def read(self, count: int) -> list[Readback]:
        """Return the read-backs of ``count`` positions. Raises InputError naming a table that does not fit."""
        poses: list[RigidTransform] = []
        names: tuple[str, ...] = ()
        if self.robot_poses is not None:
            table = read_poses(self.robot_poses, "base", "flange")
            require_millimetres(self.robot_poses, table)
            poses, names = list(table.values()), tuple(table)
        slides = {} if self.guide_positions is None else read_guide(self.guide_positions)
        if names and slides and set(names) != set(slides):
            odd = sorted(set(names) ^ set(slides))[0]
            raise InputError(f"The name {odd!r} is not in both {self.robot_poses} and {self.guide_positions}.", "Use the same names.")
        along = [slides[name] for name in names] if names and slides else list(slides.values())
        angles = [] if self.table_angles is None else list(read_angles(self.table_angles).values())
        for path, values in ((self.robot_poses, poses), (self.guide_positions, along), (self.table_angles, angles)):
            if path is not None and len(values) != count:
                raise InputError(f"{path} has {len(values)} lines for {count} board positions.", "Give one line per board position.")
        return [
            Readback(poses[index] if poses else None, along[index] if along else None, angles[index] if angles else None)
            for index in range(count)
        ]


class RecordedView(Protocol):
    """One position of the board as it was recorded."""

    @property
    def name(self) -> str:
        """Its name in messages."""

    def add_to(self, session: CalibrationSession, progress: Progress) -> CollectedObservation:
        """Read it and add it to a session. Raises InputError, DecodeError where it cannot be read."""


@dataclass(frozen=True, slots=True, eq=False)
class RecordedImages:
    """One plain image of each camera."""

    position: RecordedPosition
    readback: Readback

    @property
    def name(self) -> str:
        """Its name in messages."""
        return f"image {self.position.name}"

    def add_to(self, session: CalibrationSession, progress: Progress) -> CollectedObservation:
        """Read the images and detect the board."""
        progress.report(0, 1)
        files = self.position.files
        return session.add({camera: read_image(path) for camera, path in files.items()}, self.readback, _names(files))


@dataclass(frozen=True, slots=True, eq=False)
class RecordedFringeView:
    """Fringes on the board at one position."""

    recorded: RecordedFringes
    number: int

    @property
    def name(self) -> str:
        """Its name in messages, that of its folder."""
        return self.recorded.name(self.number)

    def add_to(self, session: CalibrationSession, progress: Progress) -> CollectedObservation:
        """Read the fringes, detect the board and decode them."""
        names = dict.fromkeys((*self.recorded.cameras, PROJECTOR), self.name)
        return session.add_fringes(self.recorded.read(self.number), names=names, progress=progress)


def readbacks_of(positions: Sequence[RecordedPosition], files: ReadbackFiles, needed: Sequence[str]) -> list[Readback]:
    """Return the axis positions of recorded images: from tables, or as recorded with them.

    Parameters
    ----------
    needed : what every position must have, by the fields of `Readback`

    Raises
    ------
    InputError
        A table cannot be read or does not fit the positions, or something needed is missing.
    """
    recorded = [position.readback or Readback() for position in positions]
    found = recorded if files == ReadbackFiles() else files.read(len(positions))
    missing = list(dict.fromkeys(axis for one in found for axis in one.missing(needed)))
    if missing:
        raise InputError(
            f"The images have no read-back of: {', '.join(missing)}.",
            "Choose a table with one line per position of the board, or the folder in which a project keeps its views of the board.",
        )
    return found


def add_recorded(
    session: CalibrationSession, images: BoardImages, files: ReadbackFiles, progress: Progress | None = None
) -> tuple[CollectedObservation, ...]:
    """Add every board position of recorded images that is not in the session yet; return those added.

    Raises
    ------
    InputError
        An image cannot be read, or the tables do not fit the images.
    """
    progress = progress or NoProgress()
    readbacks = files.read(images.positions)
    known = {image.checksum for one in session.observations for image in one.images.values()}
    added = []
    for position, readback in enumerate(readbacks):
        paths = {camera: images.path(camera, position) for camera in images.cameras}
        progress.report(position, images.positions, f"board in {next(iter(paths.values())).name}")
        pixels = {camera: read_image(path) for camera, path in paths.items()}
        if not any(checksum(image) in known for image in pixels.values()):
            added.append(session.add(pixels, readback, _names(paths)))
    progress.report(1, 1)
    return tuple(added)


def add_views(session: CalibrationSession, folder: Path, progress: Progress | None = None) -> tuple[CollectedObservation, ...]:
    """Add every sighting of the board that a project keeps below ``folder`` and that is not in the session yet; return those added.

    Raises
    ------
    StorageError
        A stored view is damaged.
    """
    progress = progress or NoProgress()
    known = {image.checksum for one in session.observations for image in one.images.values()}
    views = load_all(folder, progress)
    added = []
    for number, view in enumerate(views):
        progress.report(number, len(views), f"board in {view.viewpoint_id}")
        if not any(checksum(image) in known for image in view.images.values()):
            warm = None if view.conditions is None else view.conditions.temperature_c
            added.append(session.add(view.images, view.readback, dict.fromkeys(view.images, view.viewpoint_id), warm))
    progress.report(1, 1)
    return tuple(added)


def add_fringes(
    session: CalibrationSession, recorded: RecordedFringes, progress: Progress | None = None
) -> tuple[CollectedObservation, ...]:
    """Add every board position of recorded fringes that is not in the session yet; return those added.

    Raises
    ------
    InputError, DecodeError
        A manifest or an image cannot be read, or they do not fit each other.
    CalibrationError
        Fringes in one direction only.
    """
    progress = progress or NoProgress()
    count, added = len(recorded.manifests), []
    for number in range(count):
        view = RecordedFringeView(recorded, number)
        part = PartOf(progress, number / count, (number + 1) / count)
        part.report(0, 1, f"fringes of {view.name}")
        with suppress(ImagesThere):
            added.append(view.add_to(session, part))
    progress.report(1, 1)
    return tuple(added)


def _names(paths: Mapping[str, Path]) -> dict[str, str]:
    return {camera: path.name for camera, path in paths.items()}
