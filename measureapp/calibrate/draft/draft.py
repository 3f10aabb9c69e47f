"""Data types of a draft of a calibration: kind, setup, solution, and the draft itself."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal

from measureapp.calibrate.boards.find import require_unambiguous
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.cameras.camera import FIXED_COEFFICIENTS
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.cameras.validation import CrossValidation
from measureapp.calibrate.draft.advice import Ghost, Notes
from measureapp.calibrate.draft.comparison import Comparison
from measureapp.calibrate.draft.estimate import Calibrated, Estimate
from measureapp.calibrate.motions.axis_noise import AxisNoise, expected_noise
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, HandEye, RigCalibration
from measureapp.data.plan import Motion
from measureapp.data.rig import RigDescription
from measureapp.errors import InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Progress

Needs = Literal["", "cameras", "rig"]
ALL_AXES = ("base_from_flange", "guide_mm", "table_rad")


@dataclass(frozen=True, slots=True)
class Words:
    """Texts about a kind of calibration."""

    subject: str  # what is calibrated, as part of a sentence
    title: str
    action: str  # on a button
    tip: str
    purpose: str  # what it determines and how, in a sentence or two
    step: str  # name of the step in which views are collected
    hints: tuple[str, ...]  # what makes good views
    recorded: str = "Recorded images"
    folder: str = "A folder with images such as left01.png, right01.png: images with the same number show the same position of the board."


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits of the expanded uncertainty (k = 2) for "good" and "usable", with the reason."""

    good_mm: float
    usable_mm: float
    why: str


@dataclass(frozen=True, slots=True, eq=False)
class Known:
    """What is calibrated already; the cameras are those of the rig where there is one."""

    cameras: CameraArrayCalibration | None = None
    rig: RigCalibration | None = None


@dataclass(frozen=True, slots=True)
class Effect:
    """The covariance of a solution propagated to the part."""

    expanded_mm: float  # k = 2
    sentence: str  # with the number, without a verdict
    cameras_mm: float = 0.0  # k = 2, contribution of cameras that were calibrated before
    robot_mm: float = 0.0  # k = 2, in addition, where the result is used from other robot poses than those of its observations


@dataclass(frozen=True, slots=True, eq=False)
class Solved:
    """A solution and how the observations fit it."""

    solution: Any  # of the kind: `CameraArraySolution`, `AxisSolution`, …
    of: tuple[str, ...]  # observations that entered
    used: tuple[str, ...]  # those that stayed, in the order of the solution's own arrays
    board: BoardDescription  # with its bow, where that was estimated
    cameras: CameraArrayCalibration  # known before, or calibrated here
    places: Mapping[str, RigidTransform]  # observation -> observed camera_from_board, in the reference camera's frame
    camera_solution: CameraArraySolution | None = None  # where cameras, or the projector as one of them, are part of the result
    residuals_px: Mapping[str, Mapping[str, float]] = field(default_factory=dict)  # observation -> camera -> rms
    residuals_mm: Mapping[str, float] = field(default_factory=dict)  # observation -> rms over the marks, where axes are calibrated
    sightings: int = 0  # of single cameras, in all observations that entered
    reasons: Mapping[str, str] = field(default_factory=dict)  # observation -> what was rejected of it, and why

    @property
    def rejected(self) -> dict[str, str]:
        """Observations rejected as a whole, with the reason."""
        return {name: self.reasons.get(name, "") for name in self.of if name not in self.used}


@dataclass(frozen=True, slots=True, eq=False)
class Setup:
    """Everything that is known before the first observation.

    Raises
    ------
    InputError
        The cameras or the hand-eye transform that this kind needs are missing, or names do not fit.
    CalibrationError
        The board is symmetric under half a turn, where that matters.
    """

    kind: Kind
    board: BoardDescription
    camera_names: tuple[str, ...]  # the reference first
    cameras: CameraArrayCalibration | None = None  # None: they are part of the result
    hand_eye: HandEye | None = None
    noise: AxisNoise = field(default_factory=AxisNoise)
    distortion_count: int = 5
    standoff_mm: float | None = None  # working distance of measurements; None: that of the board
    length_mm: float = 300.0  # for which the verdict on cameras is given
    serials: Mapping[str, str] = field(default_factory=dict)  # camera -> serial number
    projector_px: tuple[int, int] | None = None  # width and height of the projector's image, where it is calibrated

    def __post_init__(self) -> None:
        subject = self.kind.words.subject
        if not self.camera_names or len(set(self.camera_names)) < len(self.camera_names):
            raise InputError("Every camera needs a name of its own.", "Name the cameras once each, the reference first.")
        if self.distortion_count not in FIXED_COEFFICIENTS:
            raise InputError(f"{self.distortion_count} distortion coefficients are not offered.", "Choose 4, 5 or 8.")
        if len(self.camera_names) > 1 or self.kind.readback or not self.calibrates_cameras:
            require_unambiguous(self.board, subject)
        if self.cameras is None and not self.calibrates_cameras:
            raise InputError(f"To calibrate {subject}, calibrated cameras are needed.", "Calibrate the cameras first.")
        unknown = [name for name in self.camera_names if self.cameras is not None and name not in self.cameras.cameras]
        if unknown and self.cameras is not None:
            raise InputError(f"Camera {unknown[0]!r} is not calibrated.", "There are: " + ", ".join(self.cameras.cameras) + ".")
        self.kind.check(self)

    @classmethod
    def on_rig(
        cls,
        kind: Kind,
        board: BoardDescription,
        names: tuple[str, ...],
        known: Known,
        rig: RigDescription | None,
        projector_px: tuple[int, int] | None = None,
    ) -> Setup:
        """Return what a calibration of this kind starts from on a rig, or without one from recorded images.

        Parameters
        ----------
        names : of the cameras, the reference first
        known : what is calibrated already; only what the kind does not estimate itself is used
        projector_px : size of the projector's image; None for that of the rig
        """
        return cls(
            kind=kind,
            board=board,
            camera_names=names,
            cameras=known.cameras if kind.needs else None,
            hand_eye=known.rig.hand_eye if kind.uses_hand_eye and known.rig is not None else None,
            noise=AxisNoise() if rig is None else expected_noise(rig),
            standoff_mm=None if rig is None else rig.standoff_mm,
            serials={} if rig is None else {camera.name: camera.serial for camera in rig.cameras},
            projector_px=projector_px if rig is None else (rig.projector.width_px, rig.projector.height_px),
        )

    @property
    def reference(self) -> str:
        """The camera in whose frame the result is given."""
        return self.camera_names[0] if self.cameras is None else self.cameras.reference

    @property
    def lenses(self) -> tuple[str, ...]:
        """Whose lens and pose are part of the result: cameras, or the projector."""
        return self.kind.lenses(self)

    @property
    def calibrates_cameras(self) -> bool:
        """Whether the cameras are part of the result."""
        return set(self.camera_names) <= set(self.lenses)

    @property
    def seeing(self) -> tuple[str, ...]:
        """Who detects the board: the cameras, and before them the projector where it is calibrated."""
        return (PROJECTOR, *self.camera_names) if self.kind.uses_fringes else self.camera_names

    def is_seen(self, by: Collection[str]) -> bool:
        """Whether a position counts in which these detected the board."""
        return PROJECTOR in by if self.kind.uses_fringes else bool(by)


@dataclass(frozen=True, slots=True, eq=False)
class Draft:
    """Setup, observations and last solution of a calibration; immutable, so that any thread may solve it or request guidance."""

    setup: Setup
    observations: tuple[Observation, ...]  # those to use: in each of them the board was detected
    sizes_px: Mapping[str, tuple[int, int]]  # camera or projector -> (width, height), of those with images
    solved: Solved | None = None  # the last solution, which may be older than the observations

    @property
    def kind(self) -> Kind:
        """What is calibrated."""
        return self.setup.kind

    @property
    def is_solved(self) -> bool:
        """Whether the last solution holds exactly these observations, and all that was detected in them."""
        solved, ids = self.solved, tuple(one.id for one in self.observations)
        return solved is not None and solved.of == ids and solved.sightings == self.sightings

    @property
    def sightings(self) -> int:
        """How many images show the board."""
        return sum(len(one.seen) for one in self.observations)

    @property
    def counted(self) -> tuple[Observation, ...]:
        """The observations without those that the last solution rejected."""
        rejected = () if self.solved is None else self.solved.rejected
        return tuple(one for one in self.observations if one.id not in rejected)

    @property
    def cameras(self) -> CameraArrayCalibration | None:
        """The cameras as last solved, or as known before; None where neither."""
        return self.setup.cameras if self.solved is None else self.solved.cameras

    @property
    def shortfalls(self) -> tuple[str, ...]:
        """What is still missing for a reliable solution."""
        if not self.observations:
            return (f"No observation shows the {self.setup.board.label} yet.",)
        return self.kind.shortfalls(self)


class Kind(ABC):
    """One kind of calibration: inputs, solver, effect of its result on the part, and guidance."""

    name: ClassVar[str]
    words: ClassVar[Words]
    limits: ClassVar[Limits]
    needs: ClassVar[Needs] = "cameras"  # what has to be calibrated before; "" where the cameras are part of the result
    readback: ClassVar[tuple[str, ...]] = ()  # axes whose position every observation must have (fields of `Readback`)
    readback_in_rig: ClassVar[tuple[str, ...]] = ()  # those it must have for the result to become part of a rig's calibration
    motions: ClassVar[tuple[Motion, ...]] = ("robot",)  # what moves between the views that a rig takes for it
    guide_at_zero: ClassVar[bool] = False  # the robot's base has to stay where it is
    uses_fringes: ClassVar[bool] = False  # the board is observed under fringes
    uses_hand_eye: ClassVar[bool] = False
    file: ClassVar[str] = ""  # in which its result is stored; "": in the files of a whole rig

    def lenses(self, setup: Setup) -> tuple[str, ...]:  # noqa: ARG002 - a default
        """Return whose lens and pose are part of the result."""
        return ()

    def check(self, setup: Setup) -> None:  # noqa: B027 - most kinds need nothing more
        """Refuse a setup that lacks what only this kind needs. Raises InputError."""

    @abstractmethod
    def solve(self, draft: Draft, progress: Progress) -> Solved:
        """Solve what was collected; the last solution of the draft is the start, where it has one. Raises CalibrationError."""

    def solve_cameras_alone(self, draft: Draft, progress: Progress) -> CameraArrayCalibration | None:  # noqa: ARG002 - a default
        """Calibrate the cameras without what else is solved, to identify further parts of the board; None where there is nothing else.

        Raises
        ------
        CalibrationError
            The observations do not determine the cameras.
        """
        return None

    @abstractmethod
    def shortfalls(self, draft: Draft) -> tuple[str, ...]:
        """Say what the observations still lack."""

    @abstractmethod
    def advise(self, draft: Draft, notes: Notes) -> Ghost | None:
        """Note what to observe next, and return where the board should appear then. Raises CalibrationError."""

    @abstractmethod
    def result(self, solved: Solved) -> Calibrated:
        """Return the calibration that a solution gives."""

    def method(self, result: Any) -> str:
        """Return by which method a result was determined."""
        return str(result.provenance.method)

    @abstractmethod
    def estimates(self, result: Any) -> Sequence[Estimate]:
        """Return the values of a result in a fixed order; equal names mean equal quantities."""

    @abstractmethod
    def effect(self, draft: Draft, solved: Solved) -> Effect:
        """Return what the covariance of a solution means on the part. Raises CalibrationError where that cannot be determined."""

    @abstractmethod
    def previous(self, known: Known) -> Calibrated | None:
        """Return what the result of this kind replaces in what is calibrated already."""

    @abstractmethod
    def compare(self, previous: Any, draft: Draft, solved: Solved) -> Comparison | None:
        """Compare a solution with an earlier result; None where that is a result of another kind. Raises CalibrationError."""

    def outdates(self, known: Known) -> Sequence[str]:  # noqa: ARG002 - a default
        """Return what has to be calibrated again once the result is accepted, in sentences."""
        return ()

    @abstractmethod
    def merge(self, draft: Draft, solved: Solved, known: Known) -> Known:
        """Return what is calibrated once the result is accepted. Raises CalibrationError where the result does not fit the rest."""

    def shown(self, known: Known, result: Known) -> Sequence[Estimate]:  # noqa: ARG002 - a default
        """Return the values of this kind in what is ``known``, as a table shows them beside those of a ``result``."""
        found = self.previous(known)
        return () if found is None else self.estimates(found)

    def compare_merged(self, draft: Draft, solved: Solved, known: Known, result: Known) -> Comparison | None:  # noqa: ARG002 - a default
        """Compare a solution with what it replaces; None where it replaces nothing. Raises CalibrationError."""
        previous = self.previous(known)
        return None if previous is None else self.compare(previous, draft, solved)

    def cross_validate(self, draft: Draft, solved: Solved, progress: Progress | None) -> CrossValidation | None:  # noqa: ARG002 - a default
        """Test the stated uncertainty with held-back views; None where the kind has no such test. Raises CalibrationError."""
        return None

    def warnings(self, solved: Solved) -> Sequence[str]:
        """Return the warnings of a solution, in addition to its covariance."""
        return tuple(solved.solution.warnings)
