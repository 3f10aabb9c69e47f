"""A calibration that is collected in a folder of its own: observations are added, removed, undone and solved while it goes on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from threading import RLock

from measureapp.arrays import ImageArray
from measureapp.calibrate.draft.draft import Draft, Setup, Solved
from measureapp.calibrate.draft.solve import solve_cameras_alone
from measureapp.calibrate.sightings import Sighting
from measureapp.calibration_session.board_in_fringes import projector_size_px
from measureapp.calibration_session.detection import (
    Detection,
    DetectionContext,
    detect,
    detect_in_fringes,
    detect_in_stored,
    identify_parts,
)
from measureapp.calibration_session.observation import CollectedObservation
from measureapp.calibration_session.snapshot import Snapshot
from measureapp.calibration_session.store import Act, Action, Store
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import FringeStack, Readback
from measureapp.errors import CalibrationError, InputError
from measureapp.progress import NoProgress, Progress


class ImagesThere(InputError):
    """Images that are in the session already."""


@dataclass(frozen=True, slots=True, eq=False)
class _State:
    """The state of a session, replaced as a whole: readers see it before or after a change, never in between."""

    actions: tuple[Action, ...] = ()
    done: int = 0  # how many of them are in effect; the rest can be redone
    observations: Mapping[str, CollectedObservation] = field(default_factory=dict)
    solved: Solved | None = None


class CalibrationSession:
    """The observations of one calibration on disk.

    Every change is written before the call returns, so that the work can be left at any time and continued. Any thread may call any
    method: changes wait for each other, and readers work on a `snapshot`. Images are searched for the board before a change begins, so
    that no change waits for a search. Make one with `create` or `open`.
    """

    def __init__(self, setup: Setup, store: Store, state: _State) -> None:
        self.setup = setup
        self._store, self._state, self._writing = store, state, RLock()

    @classmethod
    def create(cls, folder: Path, setup: Setup) -> CalibrationSession:
        """Start a session in a new or empty folder. Raises InputError where the folder holds anything."""
        folder = Path(folder)
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise InputError(f"{folder} is not an empty folder.", "Choose a new folder, or continue the session that is there.")
        made = cls(setup, Store(folder), _State())
        made._store.keep_setup(setup)
        made._save(made._state)
        return made

    @classmethod
    def open(cls, folder: Path) -> CalibrationSession:
        """Continue a session. Raises InputError where there is none, StorageError where it is damaged."""
        store = Store(folder)
        setup, actions, done, observations = store.read()
        return cls(setup, store, _State(tuple(actions), done, observations))

    @staticmethod
    def is_in(folder: Path) -> bool:
        """Whether there is a session in ``folder``."""
        return Store(folder).exists()

    def discard_empty(self) -> None:
        """Delete the folder where nothing was ever collected; anything else stays."""
        if not self._state.actions:
            self._store.discard()

    @property
    def folder(self) -> Path:
        """Where it is stored."""
        return self._store.folder

    # reading

    def snapshot(self) -> Snapshot:
        """Return the session as it is now, for reading on any thread."""
        state, kept = self._state, dict[str, bool]()
        for action in state.actions[: state.done]:
            kept[action.observation] = action.act == "add"
        can_redo = state.done < len(state.actions)
        return Snapshot(self.setup, self.folder, kept, state.observations, state.solved, state.done > 0, can_redo)

    @property
    def draft(self) -> Draft:
        """The draft of the present state, with the last solution."""
        return self.snapshot().draft

    @property
    def observations(self) -> tuple[CollectedObservation, ...]:
        """All observations now, removed ones included."""
        return self.snapshot().observations

    def observation(self, name: str) -> CollectedObservation:
        """Return one observation as it is now. Raises InputError where there is none of that name."""
        return self.snapshot().observation(name)

    @property
    def solved(self) -> Solved | None:
        """The last solution; None before the first."""
        return self._state.solved

    # changes

    def add(
        self,
        images: Mapping[str, ImageArray],
        readback: Readback | None = None,
        names: Mapping[str, str] | None = None,
        temperature_c: float | None = None,
    ) -> CollectedObservation:
        """Detect the board in the images of one position, and store them.

        An image without a usable board is kept with the reason; the other cameras' images still count.

        Parameters
        ----------
        images : camera -> (H, W), 8 or 16 bit; cameras may be missing
        names : camera -> file it came from
        temperature_c : of the head when they were taken, where it was measured

        Raises
        ------
        InputError
            An unknown camera, an image of another size than those before, or images that are in the session already.
        CalibrationError
            The read-back of an axis that this calibration needs is missing.
        """
        if self.setup.kind.uses_fringes:
            raise InputError(
                f"{self.setup.kind.words.subject.capitalize()} is calibrated from fringes on the board.", "Give fringes instead."
            )
        readback = readback or Readback()
        self._check(images, readback)
        return self._keep(detect(images, readback, self.setup.board, self._context()), readback, names, temperature_c=temperature_c)

    def add_fringes(
        self,
        stack: FringeStack,
        readback: Readback | None = None,
        names: Mapping[str, str] | None = None,
        progress: Progress | None = None,
    ) -> CollectedObservation:
        """Detect the board in the fringe images of one position, and read the projector's coordinates of its marks from the phases.

        Stored are the board in even light as every camera sees it, for people also as the projector would, and what the projector's marks
        were read from; not the fringe images.

        Raises
        ------
        InputError
            The session is not one for the projector, or as `add`; or fringes for a projector of another size.
        CalibrationError
            Fringes in one direction only.
        """
        size = self.setup.projector_px
        if not self.setup.kind.uses_fringes or size is None:
            raise InputError("Fringes calibrate a projector only.", "Give plain images of the board.")
        readback = readback or stack.readback or Readback()
        self._check({camera: images[0, 0] for camera, images in stack.images.items()}, readback)
        if projector_size_px(stack) != size:
            width, height = projector_size_px(stack)
            raise InputError(
                f"The fringes of {stack.viewpoint_id} run over {width} × {height} px of the projector, those before over "
                f"{size[0]} × {size[1]} px.",
                "Give fringes of one projector.",
            )
        found = detect_in_fringes(stack, self.setup, size, progress or NoProgress())
        return self._keep(found, readback, names, temperature_c=None if stack.conditions is None else stack.conditions.temperature_c)

    def repeat(self, other: CollectedObservation) -> CollectedObservation:
        """Detect the board in the images that another session of the same setup stored, and add the result under the same name.

        Raises
        ------
        StorageError, InputError
            An image is damaged or gone, or not the one that was stored.
        CalibrationError
            Nothing was stored of the fringes from which the projector's marks could be read again.
        """
        found = detect_in_stored(other, self.setup, self._context())
        names = {camera: image.name for camera, image in other.images.items()}
        return self._keep(found, other.readback, names, name=other.id, temperature_c=other.temperature_c)

    def identify_parts(self, cameras: CameraArrayCalibration | None = None) -> tuple[str, ...]:
        """Examine images of ambiguous parts of the board again, after more is known; return the observations that gained marks.

        Parameters
        ----------
        cameras : as they were just calibrated; default: as last solved, or as known before
        """
        gained = []
        for one in self.observations:
            if not one.unclear:
                continue
            images = {camera: one.images[camera].pixels() for camera in one.unclear}
            context = self._context(one.id)
            context = context if cameras is None else replace(context, cameras=cameras)
            found = identify_parts(images, one.seen, one.readback, self.setup.board, context)
            seen = {camera: marks for camera, marks in found.items() if isinstance(marks, Sighting)}
            if seen:
                refused = {camera: refusal for camera, refusal in one.refused.items() if camera not in seen}
                self._replace(replace(self._state.observations[one.id], seen={**one.seen, **seen}, refused=refused))
                gained.append(one.id)
        return tuple(gained)

    def remove(self, name: str) -> None:
        """Remove an observation; it stays in the list and `undo` restores it. Raises InputError where it is not there."""
        with self._writing:
            if self.observation(name).status == "removed":
                raise InputError(f"Observation {name!r} was removed before.", "Undo restores it.")
            self._act("remove", name)

    def undo(self) -> Action:
        """Undo the last change and return it. Raises InputError where there is none."""
        with self._writing:
            if not self._state.done:
                raise InputError("There is nothing to undo.", "Add observations first.")
            self._save(replace(self._state, done=self._state.done - 1))
            return self._state.actions[self._state.done]

    def redo(self) -> Action:
        """Redo the change that was undone last and return it. Raises InputError where there is none."""
        with self._writing:
            if self._state.done == len(self._state.actions):
                raise InputError("There is nothing to redo.", "Only what was undone, and nothing changed since, can be redone.")
            self._save(replace(self._state, done=self._state.done + 1))
            return self._state.actions[self._state.done - 1]

    # the result

    def solve(self, progress: Progress | None = None, *, afresh: bool = False) -> Solved:
        """Solve what is collected now, as `Snapshot.solve`, and keep the solution. Raises CalibrationError."""
        solved = self.snapshot().solve(progress, afresh=afresh).solved
        assert solved is not None  # else an error was raised
        self.adopt(solved)
        return solved

    def solve_with_parts(self, progress: Progress | None = None, *, afresh: bool = False) -> Solved:
        """Solve with all parts of the board that the cameras, which this calibrates, identify. Raises as `solve`."""
        draft, unclear = self.draft, any(one.unclear for one in self.observations)
        if draft.cameras is None and unclear:
            alone = solve_cameras_alone(draft, progress, afresh=afresh)
            if alone is not None:
                self.identify_parts(alone)
                return self.solve(progress, afresh=afresh)
        found = self.solve(progress, afresh=afresh)
        return self.solve(progress, afresh=afresh) if self.identify_parts() else found

    def adopt(self, solved: Solved | None) -> None:
        """Evaluate the observations by a solution that was found from a snapshot; None: there is none."""
        with self._writing:
            self._state = replace(self._state, solved=solved)

    def _context(self, besides: str = "") -> DetectionContext:
        """The context for identifying parts of the board: cameras, known or as last solved, and the other observations."""
        now = self.snapshot()
        return DetectionContext(now.draft.cameras, tuple(one for one in now.usable if one.id != besides))

    def _keep(
        self, found: Detection, readback: Readback, names: Mapping[str, str] | None, *, name: str = "", temperature_c: float | None = None
    ) -> CollectedObservation:
        """Store a detection and add it; duplicate images are refused."""
        with self._writing:
            stored = {camera: self._store.keep_image(pixels, (names or {}).get(camera, "")) for camera, pixels in found.images.items()}
            self._refuse_twice({camera: image.checksum for camera, image in stored.items()})
            observation = CollectedObservation(
                name or self._next_id(),
                readback,
                seen=found.seen,
                images=stored,
                refused=found.refused,
                temperature_c=temperature_c,
                lit=None if found.lit is None else self._store.keep_lit(*found.lit),
            )
            self._replace(observation)
            self._act("add", observation.id)
            return self.observation(observation.id)

    def _replace(self, observation: CollectedObservation) -> None:
        with self._writing:
            self._store.keep_observation(observation)
            self._state = replace(self._state, observations={**self._state.observations, observation.id: observation})

    def _check(self, images: Mapping[str, ImageArray], readback: Readback) -> None:
        if not images:
            raise InputError("An observation needs an image.", "Give one image per camera.")
        now = self.snapshot()
        for camera, pixels in images.items():
            if camera not in self.setup.camera_names:
                raise InputError(f"There is no camera {camera!r} here.", "There are: " + ", ".join(self.setup.camera_names) + ".")
            size, before = (pixels.shape[1], pixels.shape[0]), now.size_px(camera)
            if before is not None and size != before:
                raise InputError(
                    f"The image of camera {camera!r} is {size[0]} × {size[1]} px; {before[0]} × {before[1]} px are expected.",
                    "Give images of one camera at one resolution.",
                )
        missing = readback.missing(self.setup.kind.readback)
        if missing:
            raise CalibrationError("The read-back lacks " + " and ".join(missing) + ".", "Give it with every observation.")

    def _refuse_twice(self, checksums: Mapping[str, str]) -> None:
        """Refuse images that are there already: they would count the same noise twice."""
        for one in self.observations:
            same = [camera for camera, image in one.images.items() if checksums.get(camera) == image.checksum]
            if one.status != "removed" and same:
                raise ImagesThere(
                    f"The image of camera {same[0]!r} is the same as in observation {one.id}.", "Every observation needs images of its own."
                )

    def _next_id(self) -> str:
        return f"{max((int(name) for name in self._state.observations), default=0) + 1:02d}"

    def _act(self, act: Act, name: str) -> None:
        actions = (*self._state.actions[: self._state.done], Action(act, name))
        self._save(replace(self._state, actions=actions, done=len(actions)))

    def _save(self, state: _State) -> None:
        self._store.keep_session(self.setup, state.actions, state.done)
        self._state = state
