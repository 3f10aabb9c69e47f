"""Explanation of holes in a view, computed from its images, for a pixel, a region or the whole view."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from measureapp.arrays import IntArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import FringeStack
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import CalibrationError, InputError, ReconstructError
from measureapp.fringe.decode import decode
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.noise import decode_settings_of
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.reconstruct.projector.with_projector import reconstruct_alone
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.settings import ReconstructSettings
from measureapp.reconstruct.why import POINT, HoleReason, line_of, shares_of_region, shares_of_view, why

SEEN_BY_ANOTHER = "seen by another"
NO_HOLES = (POINT, SEEN_BY_ANOTHER)  # states of pixels whose surface is measured


def _word(state: PixelState | PointState) -> str:
    return state.name.lower().replace("_", " ")


OF_DECODING = tuple(_word(state) for state in PixelState if state != PixelState.VALID)
OF_RECONSTRUCTION = tuple(_word(state) for state in PointState if state not in (PointState.VALID, PointState.NO_PHASE))
REASONS = (POINT, *OF_DECODING, *OF_RECONSTRUCTION)  # indexed by `ExplainedView.codes`


@dataclass(frozen=True, slots=True)
class Number:
    """A quantity that decided about a pixel, with its limits; None: no such limit."""

    what: str
    value: float
    unit: str
    least: float | None = None
    most: float | None = None


@dataclass(frozen=True, slots=True)
class PixelAnswer:
    """Explanation of one pixel."""

    camera: str
    row: int
    column: int
    found: HoleReason
    numbers: tuple[Number, ...]


@dataclass(frozen=True, slots=True)
class RegionAnswer:
    """Explanation of the pixels of a region, its end not included."""

    camera: str
    box: tuple[int, int, int, int]  # row, column, row, column
    pixels: int
    shares: Mapping[str, float]  # fraction of every reason that occurs, the largest first; of sum 1
    example: PixelAnswer | None  # a pixel of the most frequent loss; None without losses


@dataclass(frozen=True, slots=True, eq=False)
class ExplainedView:
    """A decoded and reconstructed view, with explanations of its pixels."""

    viewpoint_id: str
    exposures_us: tuple[int, ...]  # from long to short
    phase_maps: Mapping[str, PhaseMap]
    made: Reconstruction
    calibrated: tuple[str, ...]  # all cameras of the calibration, in the order of the cloud's camera bits
    decode_settings: DecodeSettings = field(default_factory=DecodeSettings)
    reconstruct_settings: ReconstructSettings = field(default_factory=ReconstructSettings)

    @property
    def cameras(self) -> tuple[str, ...]:
        """Cameras with explanations, the reference camera first."""
        return tuple(self.made.states)

    def shares(self) -> dict[str, dict[str, float]]:
        """Return the fraction of pixels of every reason, by camera; those of a camera sum to 1."""
        return shares_of_view(self.phase_maps, self.made)

    def pixel(self, camera: str, row: int, column: int) -> PixelAnswer:
        """Explain a pixel. Raises ReconstructError when the view has no such camera or pixel."""
        found = why(self.phase_maps, self.made, camera, row, column, self.reconstruct_settings)
        numbers = self._numbers(self.phase_maps[camera], row, column)
        return PixelAnswer(camera, row, column, found, numbers + (self._of_point(camera, row, column) if found.stage == POINT else ()))

    def region(self, camera: str, box: tuple[int, int, int, int]) -> RegionAnswer:
        """Explain the pixels of a region (row, column, row, column), its end not included.

        Raises
        ------
        ReconstructError
            No such camera, or a region that is empty or extends beyond its image.
        """
        codes = self.codes(camera)
        top, left, bottom, right = box
        if not (0 <= top < bottom <= codes.shape[0] and 0 <= left < right <= codes.shape[1]):
            raise ReconstructError(
                f"The region {top},{left},{bottom},{right} is not inside the images of camera {camera!r}.",
                f"Give ROW,COLUMN,ROW,COLUMN of two corners within {codes.shape[0]} rows and {codes.shape[1]} columns.",
            )
        shares = shares_of_region(self.phase_maps, self.made, camera, box)
        lost = next((reason for reason in shares if reason not in NO_HOLES), None)
        example = None if lost is None else self.pixel(camera, *_middle(codes, REASONS.index(lost), box))
        return RegionAnswer(camera, box, (bottom - top) * (right - left), shares, example)

    def example(self, camera: str, reason: str) -> tuple[int, int]:
        """Return row and column of a pixel with this reason, which must occur: the median one in reading order."""
        codes = self.codes(camera)
        return _middle(codes, REASONS.index(reason), (0, 0, codes.shape[0], codes.shape[1]))

    def codes(self, camera: str) -> IntArray:
        """Return the state of every pixel, (H, W) uint8, as an index of `REASONS`. Raises ReconstructError for another camera."""
        if camera not in self.made.states:
            raise ReconstructError(f"The view has no camera {camera!r}.", "Name one of: " + ", ".join(self.cameras) + ".")
        of_phase, of_point = _tables()
        fate = self.made.states[camera]
        return np.where(fate == PointState.NO_PHASE, of_phase[self.phase_maps[camera].state], of_point[fate])

    def _of_point(self, camera: str, row: int, column: int) -> tuple[Number, ...]:
        """Return the uncertainty of the point of a pixel; a point belongs to the image of the first of its cameras."""
        cloud, bit = self.made.cloud, 1 << self.calibrated.index(camera)
        (places,) = np.nonzero((cloud.pixel == (row, column)).all(axis=1) & (cloud.cameras & (2 * bit - 1) == bit))
        if len(places) == 0:
            return ()
        sigma, seen = float(cloud.sigma_mm[places[0]]), int(cloud.cameras[places[0]]).bit_count()
        return (Number("point σ", sigma, "mm", most=self.made.max_sigma_mm.get(camera)), Number("cameras", float(seen), ""))

    def _numbers(self, phase_map: PhaseMap, row: int, column: int) -> tuple[Number, ...]:
        """Return the quantities of decoding, with their limits."""
        settings = self.decode_settings
        numbers = [Number("grey level", float(phase_map.grey[row, column]), "")]
        taken = int(phase_map.exposure_index[row, column])
        if taken >= 0:
            numbers.append(Number("exposure", float(self.exposures_us[taken]), "µs"))
        faintest, least = settings.faint_modulation_grey(phase_map.saturation), settings.min_modulation_grey(phase_map.saturation)
        modulation, has_phase = float(phase_map.modulation[row, column]), phase_map.state[row, column] == PixelState.VALID
        # below the least neighbours or several exposures may settle the order; below the faintest only several exposures compensate
        missed = faintest if modulation < faintest else least
        limit = None if has_phase and modulation < missed else missed
        numbers.append(Number("modulation", modulation, "grey levels", least=limit))
        for seen in (phase_map, phase_map.orthogonal):
            if seen is not None and seen.state[row, column] == PixelState.VALID:
                numbers += self._of_phase(seen, row, column, "" if seen is phase_map else " across")
        return tuple(numbers)

    def _of_phase(self, phase_map: PhaseMap, row: int, column: int, which: str) -> tuple[Number, ...]:
        """Return the quantities of the fringes of one direction."""
        return (
            Number("phase noise" + which, float(phase_map.sigma_rad[row, column]), "rad", most=self.decode_settings.max_sigma_rad),
            Number("signal to noise" + which, float(phase_map.snr[row, column]), ""),
            Number(f"projector {line_of(phase_map)}", phase_map.column_at(row, column), "px"),
        )


def explain_stack(
    stack: FringeStack,
    cameras: CameraArrayCalibration | None,
    decode_settings: DecodeSettings | None = None,
    progress: Progress | None = None,
) -> ExplainedView:
    """Decode and reconstruct recorded images, and keep the state of every pixel.

    Images of a single camera are triangulated with the projector if it is calibrated; otherwise only their decoding is explained.

    Parameters
    ----------
    cameras : the calibration; None only for images of a single camera

    Raises
    ------
    DecodeError, ReconstructError
        The images do not determine the phase, or are of other cameras than the calibration.
    CalibrationError
        Images of several cameras without a calibration.
    """
    progress, settings = progress or NoProgress(), decode_settings or DecodeSettings()
    maps = decode(stack, settings, PartOf(progress, 0.0, 0.5))
    names = tuple(maps) if cameras is None else cameras.names
    if len(maps) == 1:
        made = reconstruct_alone(next(iter(maps.values())), cameras)
    elif cameras is None:
        raise CalibrationError(f"The calibration of {' and '.join(maps)} is needed to match their images.", "Name their cameras.json.")
    else:
        made = reconstruct(maps, cameras, None, PartOf(progress, 0.5, 1.0))
    return ExplainedView(stack.viewpoint_id, stack.exposures_us, maps, made, names, settings)


def explain_view(project: ProjectFolder, viewpoint_id: str, progress: Progress | None = None) -> ExplainedView:
    """Recompute a stored view of a project.

    Raises
    ------
    InputError
        No images of this view are stored.
    CalibrationError
        The project is not calibrated.
    DecodeError, ReconstructError, StorageError
        From the stages, or images that are damaged.
    """
    stored = project.stored_viewpoints()
    if viewpoint_id not in stored:
        hint = f"Name one of: {', '.join(stored)}." if stored else "Scan the part first: measureapp scan."
        raise InputError(f"{project.path} contains no images of view {viewpoint_id!r}.", hint)
    calibration = project.calibration()
    if calibration is None:
        raise CalibrationError(
            f"{project.path} has no calibration, which is needed for points.", "Calibrate first: measureapp process PROJECT."
        )
    return explain_stack(project.frames.load(viewpoint_id), calibration.cameras, decode_settings_of(project), progress)


def _tables() -> tuple[IntArray, IntArray]:
    """Return the indices in `REASONS` of every PixelState and every PointState."""
    of_phase = np.array([REASONS.index(POINT if state == PixelState.VALID else _word(state)) for state in PixelState], np.uint8)
    of_point = np.zeros(len(PointState), np.uint8)
    for state in PointState:
        if state not in (PointState.VALID, PointState.NO_PHASE):
            of_point[state] = REASONS.index(_word(state))
    return of_phase, of_point


def _middle(codes: IntArray, code: int, box: tuple[int, int, int, int]) -> tuple[int, int]:
    """Return the median pixel, in reading order, of those with this code in the region."""
    top, left, bottom, right = box
    rows, columns = np.nonzero(codes[top:bottom, left:right] == code)
    place = len(rows) // 2
    return top + int(rows[place]), left + int(columns[place])
