"""From the phase maps of all cameras to one point cloud in the reference camera's frame."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import combinations
from math import degrees

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.cloud import PointCloud
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.progress import NoProgress, Progress
from measureapp.reconstruct import kernels
from measureapp.reconstruct.blur import without_blur
from measureapp.reconstruct.cleaning.clean import cleaned, rejections
from measureapp.reconstruct.cleaning.depth_grid import DepthGrid, Lens
from measureapp.reconstruct.cleaning.gather import PointArrays, gather
from measureapp.reconstruct.matching.coverage import check_across, keep_new
from measureapp.reconstruct.matching.figures import PairFigures, pair_figures
from measureapp.reconstruct.matching.match import DepthMap, match_view, sample_step
from measureapp.reconstruct.matching.tables import LEAST_SINE, fringe_sine, pair_sides, pair_tables
from measureapp.reconstruct.phase_view import PhaseView
from measureapp.reconstruct.rectification.rectified_grid import on_rectified_grid
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.reconstruct.rims import without_rims
from measureapp.reconstruct.settings import ReconstructSettings


@dataclass(frozen=True, slots=True, eq=False)
class Reconstruction:
    """A cloud in frame ``camera`` and how it came about."""

    cloud: PointCloud
    pairs: tuple[PairFigures, ...]
    rejected: Mapping[str, int]  # reason -> count
    fates: Mapping[str, IntArray]  # camera -> (H, W) uint8 of PointState, what became of every pixel of its image


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
    phase_maps : one per camera of the calibration; cameras without a map are left out
    cameras : calibration of the images' cameras
    settings : None for the defaults
    progress : told after each camera; where the task can be cancelled
    rectifier : of this calibration, to share its maps between calls; None makes one
    memory : for all that is made, the cloud among it, to be used again by later calls; None takes fresh memory

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
    inner = without_rims(phase_maps, cameras, memory)
    phase_maps = without_blur(inner, cameras, settings.max_phase_step_rad, memory, read=names if rectified else names[1:])
    if rectified:
        return _on_rectified_grid(names, phase_maps, rectifier, settings, progress, memory)
    return _reconstruct(names, phase_maps, rectifier, settings, progress, memory)


def _on_rectified_grid(
    names: tuple[str, ...],
    phase_maps: Mapping[str, PhaseMap],
    rectifier: Rectifier,
    settings: ReconstructSettings,
    progress: Progress,
    memory: BufferPool,
) -> Reconstruction:
    """Reconstruct two cameras with the first one's phase taken to the rectified grid; pixels are named by the real image."""
    if len(names) != 2:
        raise ReconstructError(f"A rectified grid needs two cameras, not {len(names)}.", "Choose the grid of the images.")
    grid, turned = rectifier.rectified(names[0], names[1])
    maps = dict(phase_maps) | {names[0]: on_rectified_grid(phase_maps[names[0]], grid, settings.max_phase_step_rad)}
    made = _reconstruct(names, maps, turned, settings, progress, memory)
    native = np.rint(grid.native[made.cloud.pixel[:, 0], made.cloud.pixel[:, 1]]).astype(np.int32)
    fates = dict(made.fates) | {names[0]: _native_fate(made.fates[names[0]], grid.native, phase_maps[names[0]])}
    return replace(made, cloud=replace(made.cloud, pixel=native[:, ::-1]), fates=fates)


def _native_fate(fate: IntArray, native: FloatArray, phase_map: PhaseMap) -> IntArray:
    """Take what became of rectified pixels back to the pixels of the image; one with a point counts before others at a place."""
    height, width = phase_map.state.shape
    back = np.where(phase_map.state == 0, PointState.UNMATCHED, PointState.NO_PHASE).astype(np.uint8)
    at = np.rint(native).astype(np.int32)
    inside = (at[..., 0] >= 0) & (at[..., 1] >= 0) & (at[..., 0] < width) & (at[..., 1] < height)
    told = inside & (fate != PointState.NO_PHASE)
    for chosen in (told & (fate != PointState.VALID), told & (fate == PointState.VALID)):
        back[at[..., 1][chosen], at[..., 0][chosen]] = fate[chosen]
    back[phase_map.state != 0] = PointState.NO_PHASE
    back[phase_map.state == PointState.RIM] = PointState.RIM
    return np.asarray(read_only(back))


def _reconstruct(
    names: tuple[str, ...],
    phase_maps: Mapping[str, PhaseMap],
    rectifier: Rectifier,
    settings: ReconstructSettings,
    progress: Progress,
    memory: BufferPool,
) -> Reconstruction:
    work = _Work(names, phase_maps, rectifier, settings, memory)
    for number, name in enumerate(names[:-1]):
        progress.report(number, len(names) - 1, f"matching {name}")
        work.match(number)
    work.finish_last()
    progress.report(1, 1, "reconstructed")
    return Reconstruction(
        work.cloud(),
        work.figures(),
        rejections(*(work.fates[name] for name in names[:-1])),
        {name: read_only(work.fates[name]) for name in names},
    )


class _Work:
    """One view: the cameras one after the other, each for what those before it do not have."""

    def __init__(
        self,
        names: tuple[str, ...],
        phase_maps: Mapping[str, PhaseMap],
        rectifier: Rectifier,
        settings: ReconstructSettings,
        memory: BufferPool,
    ) -> None:
        self.names, self.phase_maps, self.rectifier, self.settings, self.memory = names, phase_maps, rectifier, settings, memory
        self.views = {name: PhaseView.of(phase_maps[name], settings.max_phase_step_rad, memory) for name in names}
        self.witnesses = dict(self.views)  # of points of later cameras; without pixels that two others contradict
        maps_across = {name: each for name in names if (each := phase_maps[name].orthogonal) is not None}
        self.views_across = {name: PhaseView.of(each, settings.max_phase_step_rad, memory) for name, each in maps_across.items()}
        self.across: dict[tuple[str, str], FloatArray] = {}
        self.skipped = self._pairs_along_the_fringes()
        self.covered = {name: memory.empty(self.views[name].phase.shape, np.uint8) for name in names[1:]}
        for covered in self.covered.values():
            covered.fill(0)
        self.fates: dict[str, IntArray] = {}
        self.grids: dict[str, tuple[DepthGrid, tuple[str, ...]]] = {}
        self.matched: dict[tuple[str, str], int] = {}
        self.shifts: dict[tuple[str, str], list[FloatArray]] = {}

    def _pairs_along_the_fringes(self) -> dict[tuple[str, str], str]:
        """Return the pairs whose epipolar lines run along the fringes, so that the phase does not tell where on a line a point is."""
        pairs = tuple(combinations(self.names, 2))
        sides = [pair_sides(*pair, self.views, self.rectifier) for pair in pairs]
        sines = in_bands(lambda number, _: fringe_sine(sides[number]), len(pairs), len(pairs))
        skipped = {
            pair: f"epipolar lines {degrees(np.arcsin(sine)):.0f}° from the direction of the fringes"
            for pair, sine in zip(pairs, sines, strict=True)
            if sine < LEAST_SINE
        }
        if skipped and len(skipped) == len(pairs):
            pair, why = next(iter(skipped.items()))
            raise ReconstructError(
                f"Fringes of this direction cannot match the cameras {' and '.join(pair)}: {why}.",
                "Project fringes of the other direction, or both.",
            )
        return skipped

    def match(self, number: int) -> None:
        """Match the ``number``-th camera with those after it, and clean what it finds."""
        name = self.names[number]
        skip = self._skip(number)
        others = tuple(other for other in self.names[number + 1 :] if (name, other) not in self.skipped)
        if not others or skip.all():
            self.fates[name] = np.where(skip == 0, np.uint8(PointState.UNMATCHED), skip)
            return
        tables = pair_tables(name, others, self.views, self.phase_maps[name], self.rectifier, self.memory)
        view = match_view(name, others, self.views, tables, skip, self.covered, self.rectifier, self.settings, self.memory)
        for place, other in enumerate(others):
            self.matched[name, other] = view.matched[place]
            self.shifts[name, other] = [view.shifts[place]]
        found = check_across(name, others, view, self.views, self.views_across, self.covered, self.rectifier, self.settings)
        self.across |= {(name, other): shifts for other, shifts in found.shifts.items()}
        if found.set_aside.any():
            self.witnesses[name] = self._without(name, found.set_aside)
        self._drop_seen_before(number, others, view)
        cameras = self.rectifier.cameras.cameras
        camera_from_reference = cameras[name].reference_from_camera.inverse()
        centres = [camera_from_reference.apply(cameras[other].reference_from_camera.translation_mm) for other in others]
        lens = Lens(self.rectifier.rays(name), self.rectifier.ray_steps(name), 1.0 / float(cameras[name].pinhole.matrix[0, 0]))
        grid = cleaned(view.depth_mm, view.sigma_mm, view.others, view.fate, lens, centres, self.settings, self.memory)
        self.fates[name] = view.fate
        self.grids[name] = (grid, others)

    def _without(self, name: str, pixels: BoolArray) -> PhaseView:
        """Return the phase of a camera without some pixels."""
        seen = self.phase_maps[name]
        state = np.where(pixels, np.uint8(PixelState.OUT_OF_RANGE), seen.state)
        return PhaseView.of(replace(seen, state=state), self.settings.max_phase_step_rad, self.memory)

    def _skip(self, number: int) -> IntArray:
        """Return the fate of pixels that are not matched: they have no phase, or take part in points already; 0 for all others."""
        name = self.names[number]
        if number == 0:
            state = self.views[name].state
            fate = self.memory.empty(state.shape, np.uint8)
            in_bands(lambda start, stop: kernels.mark_without_phase(state, start, stop, fate), len(state))
            return fate
        return self._marked(name, 0, PointState.VALID)

    def _marked(self, name: str, sampled: int, uncovered: PointState) -> IntArray:
        state, covered = self.views[name].state, self.covered[name]
        marked, every = self.memory.empty(covered.shape, np.uint8), sample_step(covered.shape)
        numbers = (every, np.uint8(sampled), np.uint8(uncovered))
        in_bands(lambda start, stop: kernels.mark_covered(state, covered, *numbers, start, stop, marked), len(marked))
        return marked

    def _drop_seen_before(self, number: int, others: tuple[str, ...], view: DepthMap) -> None:
        """Leave only points whose surroundings no camera before has a phase of, or which something hides from it."""
        name = self.names[number]
        for earlier in self.names[:number]:
            measured = self.grids[earlier][0] if earlier in self.grids else None
            shifts = keep_new(name, earlier, view, self.views | {earlier: self.witnesses[earlier]}, measured, self.rectifier, self.settings)
            if len(others) == 1:  # the points are of one pair alone: what the earlier camera sees tests that pair
                self.shifts[name, others[0]].append(shifts)

    def finish_last(self) -> None:
        """Say what became of the last camera's pixels: they only ever help others."""
        name = self.names[-1]
        self.fates[name] = self._marked(name, 1, PointState.UNMATCHED)

    def cloud(self) -> PointCloud:
        """Gather the points of all cameras in the reference camera's frame."""
        order = self.rectifier.cameras.names
        out = PointArrays.of(int(sum(grid.per_row.sum() for grid, _ in self.grids.values())), self.memory)
        first = 0
        for name, (grid, others) in self.grids.items():
            seen, camera = self.phase_maps[name], self.rectifier.cameras.cameras[name]
            bits = tuple(1 << order.index(each) for each in (name, *others))
            gather(grid, first, seen.grey, seen.saturation, bits, np.array(camera.reference_from_camera.matrix), out)
            first += int(grid.per_row.sum())
        return PointCloud(
            out.points_mm,
            out.normals,
            out.sigma_mm,
            out.grey,
            out.pixel,
            out.cameras,
            frame="camera",
            viewpoint_id=self.phase_maps[self.names[0]].viewpoint_id,
        )

    def figures(self) -> tuple[PairFigures, ...]:
        """Judge all pairs."""
        pairs = tuple(combinations(self.names, 2))
        return tuple(in_bands(lambda number, _: self._figures_of(pairs[number]), len(pairs), len(pairs)))

    def _figures_of(self, pair: tuple[str, str]) -> PairFigures:
        if pair in self.skipped:
            return PairFigures(pair, 0, None, skipped=self.skipped[pair])
        return pair_figures(pair, self.matched.get(pair, 0), self.shifts.get(pair, []), self.across.get(pair))


def _usable_names(phase_maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration) -> tuple[str, ...]:
    strangers = [name for name in phase_maps if name not in cameras.cameras]
    if strangers:
        raise ReconstructError(
            f"Camera {strangers[0]!r} is not in the calibration, which knows {', '.join(cameras.names)}.",
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
    kinds = {(phase_maps[name].pitch_px, phase_maps[name].projector_px) for name in names}
    if len(kinds) > 1:
        raise ReconstructError("The phase maps of the cameras are of different pitches.", "Decode the images of one pattern set.")
    return names
