"""Immutable snapshot of a session, for readers on any thread."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.draft.draft import Draft, Setup, Solved
from measureapp.calibrate.draft.solve import solve
from measureapp.calibrate.rig.joint import number_approaches
from measureapp.calibrate.sightings import explain_by_refused
from measureapp.calibration_session.observation import CollectedObservation, images_without_board
from measureapp.errors import CalibrationError, InputError
from measureapp.progress import Progress


@dataclass(frozen=True, slots=True, eq=False)
class Snapshot:
    """The immutable state of a session."""

    setup: Setup
    folder: Path
    kept: Mapping[str, bool]  # observation -> whether it is not removed, in the order they were added
    stored: Mapping[str, CollectedObservation]  # as detected, without status
    solved: Solved | None = None  # the last solution, which may be older than the last change; None before the first
    can_undo: bool = False
    can_redo: bool = False

    @property
    def observations(self) -> tuple[CollectedObservation, ...]:
        """All observations in the order they were added, removed ones included, with their fit to the last solution."""
        return tuple(self._with_status(self.stored[name], kept) for name, kept in self.kept.items())

    def observation(self, name: str) -> CollectedObservation:
        """Return one observation. Raises InputError where there is none of that name."""
        if name not in self.kept:
            raise InputError(f"There is no observation {name!r}.", f"There are: {', '.join(self.kept) or 'none yet'}.")
        return self._with_status(self.stored[name], self.kept[name])

    @property
    def usable(self) -> tuple[CollectedObservation, ...]:
        """The observations that enter a solution: not removed, and the board was found."""
        return tuple(one for one in self.observations if one.status not in ("removed", "no board"))

    @property
    def draft(self) -> Draft:
        """The draft of the usable observations, with the last solution."""
        return Draft(self.setup, self._number_approaches(), self.sizes_px, self.solved)

    @property
    def is_solved(self) -> bool:
        """Whether the last solution holds exactly the observations collected now, and all their sightings."""
        return self.draft.is_solved

    @property
    def sizes_px(self) -> dict[str, tuple[int, int]]:
        """Camera, or projector -> width and height of its images; one without images is missing."""
        sizes = {camera: self.size_px(camera) for camera in self.setup.seeing}
        return {camera: size for camera, size in sizes.items() if size is not None}

    def size_px(self, camera: str) -> tuple[int, int] | None:
        """Return width and height of a camera's images, or of the projector's; None before the first."""
        if camera == PROJECTOR and self.setup.projector_px is not None:
            return self.setup.projector_px
        if self.setup.cameras is not None:
            lens = self.setup.cameras.cameras[camera].pinhole
            return lens.width_px, lens.height_px
        return next((one.images[camera].size_px for one in self.stored.values() if camera in one.images), None)

    def solve(self, progress: Progress | None = None, *, afresh: bool = False) -> Snapshot:
        """Solve the usable observations, starting from the last solution, and return the session with the new one.

        Parameters
        ----------
        afresh : ignore the last solution, as for a result that is accepted

        Raises
        ------
        CalibrationError
            The observations do not determine the result; the message says what is missing.
        """
        try:
            solved = solve(self.draft, progress, afresh=afresh)
        except CalibrationError as error:
            raise explain_by_refused(error, images_without_board(self.observations)) from error
        return replace(self, solved=solved)

    def without_solution(self) -> Snapshot:
        """Return the session without its solution, which no longer fits."""
        return replace(self, solved=None)

    def _with_status(self, one: CollectedObservation, kept: bool) -> CollectedObservation:
        if not kept:
            return replace(one, status="removed", reason="removed by hand")
        if not self.setup.is_seen(one.seen):
            return replace(one, status="no board", reason=one.refusals)
        if self.solved is None or one.id not in self.solved.of:
            return replace(one, status="new", reason=one.refusals)
        return one.with_fit(self.solved)

    def _number_approaches(self) -> tuple[Observation, ...]:
        """The usable observations with the approaches of the robot, numbered including those without a detected board."""
        poses = {one.id: pose for one in self.observations if (pose := one.readback.base_from_flange) is not None}
        numbers = dict(zip(poses, number_approaches(tuple(poses.values())), strict=True))
        return tuple(replace(one, approach=numbers.get(one.id)) for one in self.usable)
