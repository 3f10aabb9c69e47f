"""Observations of the board as they are collected: added, taken out, undone, kept on disk after every change, and solved while it goes on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from measureapp.arrays import ImageArray
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR, called
from measureapp.calibrate.rig.joint import approaches_to
from measureapp.calibrate.sightings import FoundBoard, naming_refused
from measureapp.data.fringe import AxisReadback, FringeStack
from measureapp.errors import CalibrationError, InputError
from measureapp.pipeline.board_in_fringes import projector_size_px
from measureapp.pipeline.collecting.looking import Before, Looked, look, look_at_kept, look_in_fringes, tell_parts
from measureapp.pipeline.collecting.observation import READBACK_WORDS, Observation, Readback, lost_images
from measureapp.pipeline.collecting.setup import NEEDED, Setup
from measureapp.pipeline.collecting.solved import Solved
from measureapp.pipeline.collecting.solving import shortfalls_of, solve
from measureapp.pipeline.collecting.store import Act, Action, Store
from measureapp.progress import NoProgress, Progress


class ImagesThere(InputError):
    """Images that are in the collection already."""


class Collection:
    """The observations of one calibration, in a folder of their own.

    Every change is written before the call returns, so that the work can be left at any time and opened again. Not for several
    threads at once. Make one with `create` or `open`.
    """

    def __init__(self, setup: Setup, store: Store, actions: list[Action], done: int, observations: dict[str, Observation]) -> None:
        self.setup = setup
        self._store = store
        self._actions, self._done = actions, done
        self._all = observations
        self._solved: Solved | None = None

    @classmethod
    def create(cls, folder: Path, setup: Setup) -> Collection:
        """Start a collection in a new or empty folder. Raises InputError where something lies there."""
        folder = Path(folder)
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise InputError(f"{folder} is not an empty folder.", "Choose a new folder, or continue the session that lies there.")
        made = cls(setup, Store(folder), [], 0, {})
        made._store.keep_setup(setup)
        made._save()
        return made

    @classmethod
    def open(cls, folder: Path) -> Collection:
        """Continue a collection. Raises InputError where there is none, StorageError where it is damaged."""
        store = Store(folder)
        setup, actions, done, observations = store.read()
        return cls(setup, store, actions, done, observations)

    @staticmethod
    def is_in(folder: Path) -> bool:
        """Whether a collection lies in ``folder``."""
        return Store(folder).exists()

    def discard_empty(self) -> None:
        """Remove the folder where nothing was ever collected; anything else stays."""
        if not self._actions:
            self._store.discard()

    @property
    def folder(self) -> Path:
        """Where it is kept."""
        return self._store.folder

    # what was collected

    @property
    def solved(self) -> Solved | None:
        """The last solution, which may be older than the last change; None before the first."""
        return self._solved

    @property
    def is_solved(self) -> bool:
        """Whether the last solution holds exactly the observations collected now, and all that is seen in them."""
        solved, ids = self._solved, self._usable_ids()
        return solved is not None and solved.of == ids and solved.sightings == self._sightings(ids)

    @property
    def observations(self) -> tuple[Observation, ...]:
        """All observations in the order they were added, those taken out by hand among them."""
        standing = self._standing()
        return tuple(self._judged(self._all[name], kept) for name, kept in standing.items())

    def observation(self, name: str) -> Observation:
        """Return one observation. Raises InputError where there is none of that name."""
        found = next((one for one in self.observations if one.id == name), None)
        if found is None:
            known = ", ".join(self._standing()) or "none yet"
            raise InputError(f"There is no observation {name!r}.", f"There are: {known}.")
        return found

    @property
    def usable(self) -> tuple[Observation, ...]:
        """The observations that enter a solution: not taken out, and the board was found."""
        return tuple(one for one in self.observations if one.standing not in ("removed", "no board"))

    @property
    def counted(self) -> tuple[Observation, ...]:
        """The usable observations without those that the last solution left out."""
        return tuple(one for one in self.usable if one.standing != "rejected")

    def size_px(self, camera: str) -> tuple[int, int] | None:
        """Return width and height of a camera's images, or of the projector's; None before the first."""
        if camera == PROJECTOR and self.setup.projector_px is not None:
            return self.setup.projector_px
        if self.setup.cameras is not None:
            lens = self.setup.cameras.cameras[camera].pinhole
            return lens.width_px, lens.height_px
        return next((one.images[camera].size_px for one in self._all.values() if camera in one.images), None)

    # changes

    def add(
        self,
        images: Mapping[str, ImageArray],
        readback: Readback | AxisReadback | None = None,
        names: Mapping[str, str] | None = None,
        temperature_c: float | None = None,
    ) -> Observation:
        """Look for the board in the images of one position, and keep them.

        An image without a usable board is kept with the reason; the other cameras' images still count.

        Parameters
        ----------
        images : camera -> (H, W), 8 or 16 bit; cameras may be missing
        names : camera -> file it came from
        temperature_c : of the head when they were taken, where it was measured

        Raises
        ------
        InputError
            An unknown camera, an image of another size than those before, or images that are in the collection already.
        CalibrationError
            The read-back of an axis that this calibration needs is missing.
        """
        if self.setup.kind == "projector":
            raise InputError("The projector is calibrated from fringes on the board.", "Give fringes instead of plain images.")
        read = _as_readback(readback)
        self._check(images, read)
        return self._keep(look(images, read, self.setup.board, self._before()), read, names, temperature_c=temperature_c)

    def add_fringes(
        self,
        stack: FringeStack,
        readback: Readback | AxisReadback | None = None,
        names: Mapping[str, str] | None = None,
        progress: Progress | None = None,
    ) -> Observation:
        """Look for the board in the fringe images of one position, look its marks up in the phases, and keep what came of it.

        Kept are the board in even light as every camera sees it and, for people, as the projector would, and what the projector's marks
        were read from; not the fringe images.

        Parameters
        ----------
        stack : fringes of both directions; images of all cameras or of some
        readback : None for that of the stack

        Raises
        ------
        InputError
            The session is not one for the projector, or as `add`; or fringes for a projector of another size.
        CalibrationError
            Fringes in one direction only.
        """
        size = self.setup.projector_px
        if self.setup.kind != "projector" or size is None:
            raise InputError("Fringes calibrate a projector only.", "Give plain images of the board.")
        read = _as_readback(stack.readback if readback is None else readback)
        self._check({camera: images[0, 0] for camera, images in stack.images.items()}, read)
        if projector_size_px(stack) != size:
            width, height = projector_size_px(stack)
            raise InputError(
                f"The fringes of {stack.viewpoint_id} run over {width} × {height} px of the projector, those before over "
                f"{size[0]} × {size[1]} px.",
                "Give fringes of one projector.",
            )
        looked = look_in_fringes(stack, self.setup, size, progress or NoProgress())
        return self._keep(looked, read, names, temperature_c=None if stack.conditions is None else stack.conditions.temperature_c)

    def repeat(self, other: Observation) -> Observation:
        """Look for the board in the images that another collection of the same setup kept, and add what is found under the same name.

        Raises
        ------
        StorageError, InputError
            An image is damaged or gone, or not the one that was kept.
        CalibrationError
            Nothing was kept of the fringes from which the projector's marks could be read again.
        """
        looked = look_at_kept(other, self.setup, self._before())
        names = {camera: image.name for camera, image in other.images.items()}
        return self._keep(looked, other.readback, names, name=other.id, temperature_c=other.temperature_c)

    def look_again(self) -> tuple[str, ...]:
        """Look once more at images of parts of the board that nothing could tell, after more is known; return the observations that gained by it."""
        gained = []
        for one in self.observations:
            unclear = [camera for camera, refusal in one.refused.items() if refusal.cause == "part"]
            if one.standing == "removed" or not unclear:
                continue
            images = {camera: one.images[camera].pixels() for camera in unclear}
            told = tell_parts(images, one.seen, one.readback, self.setup.board, self._before(one.id))
            seen = {camera: found for camera, found in told.items() if isinstance(found, FoundBoard)}
            if seen:
                refused = {camera: refusal for camera, refusal in one.refused.items() if camera not in seen}
                self._all[one.id] = replace(self._all[one.id], seen={**one.seen, **seen}, refused=refused)
                self._store.keep_observation(self._all[one.id])
                gained.append(one.id)
        return tuple(gained)

    def remove(self, name: str) -> None:
        """Take an observation out; it stays in the list and `undo` brings it back. Raises InputError where it is not there."""
        if self.observation(name).standing == "removed":
            raise InputError(f"Observation {name!r} was taken out before.", "Undo brings it back.")
        self._act("remove", name)

    @property
    def can_undo(self) -> bool:
        """Whether there is something to undo."""
        return self._done > 0

    @property
    def can_redo(self) -> bool:
        """Whether something was undone that can be done again."""
        return self._done < len(self._actions)

    def undo(self) -> Action:
        """Take back the last change and return it. Raises InputError where there is none."""
        if not self.can_undo:
            raise InputError("There is nothing to undo.", "Add observations first.")
        self._done -= 1
        self._save()
        return self._actions[self._done]

    def redo(self) -> Action:
        """Do again what was undone last and return it. Raises InputError where there is none."""
        if not self.can_redo:
            raise InputError("There is nothing to redo.", "Only what was undone, and nothing changed since, can be done again.")
        self._done += 1
        self._save()
        return self._actions[self._done - 1]

    # the result

    def shortfalls(self) -> tuple[str, ...]:
        """Say what is still missing for a reliable solution."""
        return shortfalls_of(self.setup, self.usable, self._sizes())

    def solve(self, progress: Progress | None = None, *, afresh: bool = False) -> Solved:
        """Solve what was collected; quicker after the first time, since it starts from the solution before.

        Parameters
        ----------
        afresh : start from nothing, as for a result that is kept

        Raises
        ------
        CalibrationError
            The observations do not determine the result; says what is missing.
        """
        try:
            found = solve(self.setup, self._approached(), self._sizes(), None if afresh else self._solved, progress)
        except CalibrationError as error:
            raise naming_refused(error, lost_images(self.observations)) from error
        self._solved = replace(found, sightings=self._sightings(found.of))
        return self._solved

    def solve_with_parts(self, progress: Progress | None = None, *, afresh: bool = False) -> Solved:
        """Solve, and once more where cameras that are calibrated by it tell each other parts of the board. Raises as `solve`."""
        found = self.solve(progress, afresh=afresh)
        return self.solve(progress, afresh=afresh) if self.look_again() else found

    def snapshot(self) -> Collection:
        """Return a copy that another thread may solve and ask for advice while this one is added to; the copy must not be changed."""
        copy = Collection(self.setup, self._store, self._actions, self._done, dict(self._all))
        copy._solved = self._solved
        return copy

    def adopt(self, solved: Solved | None) -> None:
        """Judge the observations by a solution that a snapshot found; None: there is none."""
        self._solved = solved

    def _before(self, besides: str = "") -> Before:
        """What tells parts of the board: the cameras, known or as they were solved last, and the other observations."""
        solved = None if self._solved is None else self._solved.cameras
        return Before(self.setup.cameras or solved, tuple(one for one in self.usable if one.id != besides))

    def _sightings(self, ids: Sequence[str]) -> int:
        return sum(len(self._all[name].seen) for name in ids)

    def _keep(
        self, looked: Looked, read: Readback, names: Mapping[str, str] | None, *, name: str = "", temperature_c: float | None = None
    ) -> Observation:
        """Write what was looked at, and add it; images that are there already are refused."""
        stored = {camera: self._store.keep_image(pixels, (names or {}).get(camera, "")) for camera, pixels in looked.images.items()}
        self._refuse_twice({camera: image.checksum for camera, image in stored.items()})
        lit = None if looked.lit is None else self._store.keep_lit(*looked.lit)
        observation = Observation(name or self._next_id(), stored, read, looked.seen, looked.refused, temperature_c=temperature_c, lit=lit)
        self._store.keep_observation(observation)
        self._all[observation.id] = observation
        self._act("add", observation.id)
        return self.observation(observation.id)

    def _standing(self) -> dict[str, bool]:
        """Observation -> whether it is kept, in the order they were added."""
        kept: dict[str, bool] = {}
        for action in self._actions[: self._done]:
            kept[action.observation] = action.act == "add"
        return kept

    def _usable_ids(self) -> tuple[str, ...]:
        return tuple(name for name, kept in self._standing().items() if kept and self.setup.is_seen(self._all[name].seen))

    def _judged(self, one: Observation, kept: bool) -> Observation:
        if not kept:
            return replace(one, standing="removed", reason="taken out by hand")
        if not self.setup.is_seen(one.seen):
            return replace(one, standing="no board", reason=_why_refused(one))
        if self._solved is None or one.id not in self._solved.of:
            return replace(one, standing="new", reason=_why_refused(one))
        return self._solved.judged(replace(one, reason=_why_refused(one)))

    def _approached(self) -> tuple[Observation, ...]:
        """The usable observations with the approaches of the robot, those counted that led to no observation that is used."""
        poses = {one.id: pose for one in self.observations if (pose := one.readback.base_from_flange) is not None}
        numbers = dict(zip(poses, approaches_to(tuple(poses.values())), strict=True))
        return tuple(replace(one, approach=numbers.get(one.id)) for one in self.usable)

    def _sizes(self) -> dict[str, tuple[int, int]]:
        sizes = {camera: self.size_px(camera) for camera in self.setup.seeing}
        return {camera: size for camera, size in sizes.items() if size is not None}

    def _check(self, images: Mapping[str, ImageArray], readback: Readback) -> None:
        if not images:
            raise InputError("An observation needs an image.", "Give one of every camera.")
        for camera, pixels in images.items():
            if camera not in self.setup.camera_names:
                raise InputError(f"There is no camera {camera!r} here.", "There are: " + ", ".join(self.setup.camera_names) + ".")
            size, before = (pixels.shape[1], pixels.shape[0]), self.size_px(camera)
            if before is not None and size != before:
                raise InputError(
                    f"The image of camera {camera!r} is {size[0]} × {size[1]} px; {before[0]} × {before[1]} px are expected.",
                    "Give images of one camera at one resolution.",
                )
        missing = [name for name in NEEDED[self.setup.kind] if getattr(readback, name) is None]
        if missing:
            raise CalibrationError(
                "The read-back lacks " + " and ".join(READBACK_WORDS[name] for name in missing) + ".", "Give it with every observation."
            )

    def _refuse_twice(self, checksums: Mapping[str, str]) -> None:
        """Refuse images that are there already: they would count the same noise twice."""
        for name, kept in self._standing().items():
            same = [camera for camera, image in self._all[name].images.items() if checksums.get(camera) == image.checksum]
            if kept and same:
                raise ImagesThere(
                    f"The image of camera {same[0]!r} is the same as in observation {name}.", "Every observation needs images of its own."
                )

    def _next_id(self) -> str:
        return f"{max((int(name) for name in self._all), default=0) + 1:02d}"

    def _act(self, act: Act, name: str) -> None:
        self._actions = [*self._actions[: self._done], Action(act, name)]
        self._done += 1
        self._save()

    def _save(self) -> None:
        self._store.keep_session(self.setup, self._actions, self._done)


def _as_readback(readback: Readback | AxisReadback | None) -> Readback:
    return Readback.of(readback) if isinstance(readback, AxisReadback) else readback or Readback()


def _why_refused(one: Observation) -> str:
    return " ".join(f"{called(camera)}: {refusal.message} {refusal.hint}" for camera, refusal in one.refused.items())
