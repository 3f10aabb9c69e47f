"""From the phase maps of all cameras to one point cloud in the reference camera's frame."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import combinations
from math import degrees

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.cloud import PointCloud
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.progress import NoProgress, Progress
from measureapp.reconstruct import kernels
from measureapp.reconstruct.blur import correct_blur
from measureapp.reconstruct.cleaning.clean import clean_grid, count_rejections
from measureapp.reconstruct.cleaning.depth_grid import DepthGrid, Lens
from measureapp.reconstruct.cleaning.gather import Grey, gather, make_cloud_arrays
from measureapp.reconstruct.cleaning.uncertainty_limit import uncertainty_limit_mm
from measureapp.reconstruct.discontinuities import exclude_discontinuities
from measureapp.reconstruct.kernels.structures import LANES
from measureapp.reconstruct.kernels.table import MIN_SINE
from measureapp.reconstruct.matching.cross_check import check_orthogonal, keep_new
from measureapp.reconstruct.matching.figures import PairFigures, evaluate_pair
from measureapp.reconstruct.matching.match import CameraSet, DepthMap, match_camera, sample_step
from measureapp.reconstruct.matching.tables import fringe_sine, pair_sides, pair_tables
from measureapp.reconstruct.part_blur import with_blur_of_part
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectification.rectified_grid import resample_on_grid
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings


@dataclass(frozen=True, slots=True, eq=False)
class Reconstruction:
    """A cloud in frame ``camera``, with the figures of its camera pairs and the state of every pixel."""

    cloud: PointCloud
    pairs: tuple[PairFigures, ...]
    rejected: Mapping[str, int]  # reason -> count
    states: Mapping[str, IntArray]  # camera -> (H, W) uint8 of PointState, of every pixel of its image
    max_sigma_mm: Mapping[str, float] = field(default_factory=dict)  # camera -> standard deviation above which its points were left out
    blur_px: Mapping[str, float] = field(default_factory=dict)  # camera -> blur of its image of the part


def reconstruct(
    phase_maps: Mapping[str, PhaseMap],
    cameras: CameraArrayCalibration,
    settings: ReconstructSettings | None = None,
    progress: Progress | None = None,
    rectifier: Rectifier | None = None,
    memory: BufferPool | None = None,
) -> Reconstruction:
    """Match all pairs of cameras and intersect their rays.

    Every pixel of the reference camera gets at most one point: the least-squares solution of all cameras that see its phase there.
    Pixels of the next camera follow where no camera before it sees the surface, and so on.

    Parameters
    ----------
    phase_maps : one per camera of the calibration; cameras without a map are not used
    cameras : calibration of the images' cameras
    settings : None for the defaults
    progress : reports every camera; where the task can be cancelled
    rectifier : of this calibration, to share its maps between calls; None creates one
    memory : of all results, the cloud included, reused by later calls; None allocates new memory

    Raises
    ------
    ReconstructError
        Fewer than two cameras, or images of another size, pitch or camera than calibrated, or fringes along all epipolar lines.
    """
    settings = settings or ReconstructSettings()
    progress = progress or NoProgress()
    rectifier = rectifier or Rectifier(cameras)
    memory = memory or BufferPool()
    names = _usable_names(phase_maps, cameras)
    rectified = settings.grid == "rectified" or (settings.grid == "auto" and len(names) == 2)
    seeing = with_blur_of_part({name: phase_maps[name] for name in names}, cameras)
    inner = exclude_discontinuities(phase_maps, seeing, memory)
    phase_maps = correct_blur(inner, seeing, settings.max_phase_step_rad, memory, interpolated=names if rectified else names[1:])
    by_grid = _reconstruct_rectified if rectified else _reconstruct
    made = by_grid(names, phase_maps, rectifier, settings, progress, memory)
    return replace(made, blur_px={name: seeing.cameras[name].blur_px for name in names})


def _reconstruct_rectified(
    names: tuple[str, ...],
    phase_maps: Mapping[str, PhaseMap],
    rectifier: Rectifier,
    settings: ReconstructSettings,
    progress: Progress,
    memory: BufferPool,
) -> Reconstruction:
    """Reconstruct two cameras with the first one's phase resampled on the rectified grid; pixels are those of the real image."""
    if len(names) != 2:
        raise ReconstructError(f"A rectified grid needs two cameras, not {len(names)}.", "Choose the grid of the images.")
    grid, rectified = rectifier.rectified(names[0], names[1])
    maps = dict(phase_maps) | {names[0]: resample_on_grid(phase_maps[names[0]], grid, settings.max_phase_step_rad)}
    made = _reconstruct(names, maps, rectified, settings, progress, memory)
    native = np.rint(grid.native[made.cloud.pixel[:, 0], made.cloud.pixel[:, 1]]).astype(np.int32)
    states = dict(made.states) | {names[0]: _native_state(made.states[names[0]], grid.native, phase_maps[names[0]])}
    return replace(made, cloud=replace(made.cloud, pixel=native[:, ::-1]), states=states)


def _native_state(state: IntArray, native: FloatArray, phase_map: PhaseMap) -> IntArray:
    """Transfer the states of rectified pixels to the pixels of the image; at one place, a pixel with a point takes precedence."""
    height, width = phase_map.state.shape
    result = np.where(phase_map.state == 0, PointState.UNMATCHED, PointState.NO_PHASE).astype(np.uint8)
    x, y = np.moveaxis(np.rint(native).astype(np.int32), -1, 0)
    known = (x >= 0) & (y >= 0) & (x < width) & (y < height) & (state != PointState.NO_PHASE)
    for chosen in (known & (state != PointState.VALID), known & (state == PointState.VALID)):
        result[y[chosen], x[chosen]] = state[chosen]
    result[phase_map.state != 0] = PointState.NO_PHASE
    result[phase_map.state == PointState.RIM] = PointState.RIM
    return np.asarray(read_only(result))


def _reconstruct(
    names: tuple[str, ...],
    phase_maps: Mapping[str, PhaseMap],
    rectifier: Rectifier,
    settings: ReconstructSettings,
    progress: Progress,
    memory: BufferPool,
) -> Reconstruction:
    phases = {name: PhaseView.of(phase_maps[name], settings.max_phase_step_rad, memory) for name in names}
    work = _Work(names, phase_maps, CameraSet(phases, rectifier, settings, memory))
    for number, name in enumerate(names[:-1]):
        progress.report(number, len(names) - 1, f"matching {name}")
        work.match(number)
    work.finish_last()
    progress.report(1, 1, "reconstructed")
    return Reconstruction(
        work.make_cloud(),
        work.evaluate_pairs(),
        count_rejections(*(work.states[name] for name in names[:-1])),
        {name: read_only(work.states[name]) for name in names},
        work.max_sigma_mm,
    )


class _Work:
    """One viewpoint: the cameras one after the other, each for what those before it have not measured."""

    def __init__(self, names: tuple[str, ...], phase_maps: Mapping[str, PhaseMap], camera_set: CameraSet) -> None:
        self.names, self.phase_maps, self.camera_set = names, phase_maps, camera_set
        self.observing = dict(camera_set.phases)  # phases that check points of later cameras; without pixels that two others contradict
        maps = {name: each for name in names if (each := phase_maps[name].orthogonal) is not None}
        self.orthogonal = {name: self._phase_view(each) for name, each in maps.items()}
        self.orthogonal_shifts: dict[tuple[str, str], FloatArray] = {}
        self.skipped = self._pairs_along_fringes()
        self.used = {name: camera_set.memory.empty(camera_set.phases[name].phase.shape, np.uint8) for name in names}
        for used in self.used.values():
            used.fill(0)
        self.states: dict[str, IntArray] = {}
        self.grids: dict[str, tuple[DepthGrid, tuple[str, ...]]] = {}
        self.max_sigma_mm: dict[str, float] = {}
        self.matched: dict[tuple[str, str], int] = {}
        self.shifts: dict[tuple[str, str], list[FloatArray]] = {}

    def _phase_view(self, phase_map: PhaseMap) -> PhaseView:
        return PhaseView.of(phase_map, self.camera_set.settings.max_phase_step_rad, self.camera_set.memory)

    def _pairs_along_fringes(self) -> dict[tuple[str, str], str]:
        """Return the pairs whose epipolar lines run along the fringes, so that the phase does not determine the place on a line."""
        pairs = tuple(combinations(self.names, 2))
        sides = [pair_sides(*pair, dict(self.camera_set.phases), self.camera_set.rectifier) for pair in pairs]
        sines = in_bands(lambda number, _: fringe_sine(sides[number]), len(pairs), len(pairs))
        skipped = {
            pair: f"epipolar lines {degrees(np.arcsin(sine)):.0f}° from the direction of the fringes"
            for pair, sine in zip(pairs, sines, strict=True)
            if sine < MIN_SINE
        }
        if skipped and len(skipped) == len(pairs):
            pair, reason = next(iter(skipped.items()))
            raise ReconstructError(
                f"Fringes of this direction cannot match the cameras {' and '.join(pair)}: {reason}.",
                "Project fringes of the other direction, or both.",
            )
        return skipped

    def match(self, number: int) -> None:
        """Match the ``number``-th camera with those after it, and clean its points."""
        name, camera_set = self.names[number], self.camera_set
        skip = self._mark_used(name, 0, PointState.VALID)
        others = tuple(other for other in self.names[number + 1 :] if (name, other) not in self.skipped)
        if not others or skip.all():
            self.states[name] = np.where(skip == 0, np.uint8(PointState.UNMATCHED), skip)
            return
        tables = pair_tables(name, others, dict(camera_set.phases), self.phase_maps[name], camera_set.rectifier, camera_set.memory)
        depth_map = match_camera(name, others, camera_set, tables, skip, self.used)
        for place, other in enumerate(others):
            self.matched[name, other] = depth_map.matched[place]
            self.shifts[name, other] = [depth_map.shifts[place]]
        check = check_orthogonal(name, others, depth_map, camera_set, self.orthogonal, skip, self.used)
        self.orthogonal_shifts |= {(name, other): shifts for other, shifts in check.shifts.items()}
        if check.set_aside.any():
            seen = self.phase_maps[name]
            state = np.where(check.set_aside, np.uint8(PixelState.OUT_OF_RANGE), seen.state)
            self.observing[name] = self._phase_view(replace(seen, state=state))
        self._keep_new(number, others, depth_map, skip)
        self.states[name] = depth_map.state
        self.grids[name] = (self._clean(name, others, depth_map), others)

    def _clean(self, name: str, others: tuple[str, ...], depth_map: DepthMap) -> DepthGrid:
        rectifier, cameras = self.camera_set.rectifier, self.camera_set.rectifier.cameras.cameras
        camera_from_reference = cameras[name].reference_from_camera.inverse()
        centres = [camera_from_reference.apply(cameras[other].reference_from_camera.translation_mm) for other in others]
        lens = Lens(rectifier.rays(name), rectifier.ray_jacobian(name), 1.0 / float(cameras[name].pinhole.matrix[0, 0]))
        arrays = (depth_map.depth_mm, depth_map.sigma_mm, depth_map.others, depth_map.state)
        settings = self.camera_set.settings
        limit = uncertainty_limit_mm(depth_map.sigma_mm, self.phase_maps[name].sigma_rad, settings)
        self.max_sigma_mm[name] = limit
        return clean_grid(*arrays, lens, centres, settings.model_copy(update={"max_sigma_mm": limit}), self.camera_set.memory)

    def _mark_used(self, name: str, sampled: int, otherwise: PointState) -> IntArray:
        """Return the state of pixels that have no phase or take part in points already, ``otherwise`` for all others."""
        state, used = self.camera_set.phases[name].state, self.used[name]
        marked, every = self.camera_set.memory.empty(used.shape, np.uint8), sample_step(used.shape)
        numbers = (every, np.uint8(sampled), np.uint8(otherwise))
        in_bands(lambda start, stop: kernels.mark_used(state, used, *numbers, start, stop, marked), len(marked))
        return marked

    def _keep_new(self, number: int, others: tuple[str, ...], depth_map: DepthMap, skip: IntArray) -> None:
        """Keep only points whose surroundings no earlier camera has a phase of, or which are occluded from it."""
        name = self.names[number]
        for earlier in self.names[:number]:
            measured = self.grids[earlier][0] if earlier in self.grids else None
            shifts = keep_new(name, earlier, depth_map, self.camera_set, self.observing[earlier], skip, measured)
            if len(others) == 1:  # points of one pair alone: what the earlier camera sees tests that pair
                self.shifts[name, others[0]].append(shifts)

    def finish_last(self) -> None:
        """Determine the states of the last camera, whose pixels only take part in points of others."""
        name = self.names[-1]
        self.states[name] = self._mark_used(name, 1, PointState.UNMATCHED)

    def make_cloud(self) -> PointCloud:
        """Gather the points of all cameras in the reference camera's frame."""
        cameras, first = self.camera_set.rectifier.cameras, 0
        cloud = make_cloud_arrays(int(sum(grid.per_row.sum() for grid, _ in self.grids.values())), self.camera_set.memory)
        for name, (grid, others) in self.grids.items():
            seen = self.phase_maps[name]
            bits = tuple(1 << cameras.names.index(each) for each in (name, *others))
            pose = np.array(cameras.cameras[name].reference_from_camera.matrix)
            gather(grid, first, Grey(seen.grey, seen.saturation), bits, pose, cloud)
            first += int(grid.per_row.sum())
        return PointCloud(*cloud, frame="camera", viewpoint_id=self.phase_maps[self.names[0]].viewpoint_id)

    def evaluate_pairs(self) -> tuple[PairFigures, ...]:
        """Evaluate how well the cameras of all pairs fit together."""
        pairs = tuple(combinations(self.names, 2))
        return tuple(in_bands(lambda number, _: self._evaluate_pair(pairs[number]), len(pairs), len(pairs)))

    def _evaluate_pair(self, pair: tuple[str, str]) -> PairFigures:
        if pair in self.skipped:
            return PairFigures(pair, 0, None, skipped=self.skipped[pair])
        return evaluate_pair(pair, self.matched.get(pair, 0), self.shifts.get(pair, []), self.orthogonal_shifts.get(pair))


def _usable_names(phase_maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration) -> tuple[str, ...]:
    strangers = [name for name in phase_maps if name not in cameras.cameras]
    if strangers:
        raise ReconstructError(
            f"Camera {strangers[0]!r} is not in the calibration of {', '.join(cameras.names)}.",
            "Use the calibration of the cameras that took the images.",
        )
    names = tuple(name for name in cameras.names if name in phase_maps)
    if len(names) < 2:
        raise ReconstructError(f"{len(names)} calibrated camera has images; points need two.", "Add the images of a second camera.")
    for name in names:
        pinhole = cameras.cameras[name].pinhole
        height, width = phase_maps[name].phase_rad.shape
        if (width, height) != (pinhole.width_px, pinhole.height_px):
            raise ReconstructError(
                f"Camera {name!r} is calibrated for {pinhole.width_px} × {pinhole.height_px} px, its images have {width} × {height} px.",
                "Use the calibration of the camera and resolution that took the images.",
            )
        if width < LANES:
            raise ReconstructError(
                f"The images of camera {name!r} have {width} columns; at least {LANES} are needed.", "Use larger images."
            )
    kinds = {(phase_maps[name].pitch_px, phase_maps[name].projector_px) for name in names}
    if len(kinds) > 1:
        raise ReconstructError("The phase maps of the cameras are of different pitches.", "Decode the images of one pattern set.")
    return names
