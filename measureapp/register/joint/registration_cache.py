"""Registration cache: prepared clouds and pairwise registrations, computed once, in the background while a scan is running."""

from __future__ import annotations

import os
from collections.abc import Callable, Hashable, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from types import TracebackType
from typing import Any, Protocol, TypeVar, cast

import numpy as np

from measureapp.arrays import IntArray
from measureapp.data.cloud import PointCloud
from measureapp.geometry.transform import RigidTransform
from measureapp.register.clouds.quality import point_spacing_mm
from measureapp.register.pairs.icp import PairMeasurement, register_pair
from measureapp.register.pairs.prepare import PreparedCloud, occupied_cells, prepare
from measureapp.register.settings import StitchSettings

LEAST_POINTS = 100
VOXEL_PER_SPACING = 2.2
LEAST_VOXEL_MM = 0.7  # finer voxels take longer without better registration
VOXEL_STEPS = 4  # per factor of two; quantised so that an additional view rarely changes the voxel
CELL_PER_VOXEL = 5.0
STOPPED_WITHIN_S, ENDED_WITHIN_S = 0.3, 30.0  # for the registration under way, when a scan is stopped, and at its end
T = TypeVar("T")
A = TypeVar("A")


@dataclass(frozen=True, slots=True, eq=False)
class PlacedCloud:
    """A cloud with its kinematic pose."""

    cloud: PointCloud
    kinematic: RigidTransform  # part_from_camera


class Background(Protocol):
    """Does tasks in their order, on a thread that never keeps the program from ending."""

    def submit(self, task: Callable[[], T]) -> Future[T]:
        """Queue a task and return at once."""

    def close(self, within_s: float) -> None:
        """Cancel what has not begun, wait so long for the task under way, then leave it behind."""


class _AtOnce:
    """Does tasks where they are submitted."""

    def submit(self, task: Callable[[], T]) -> Future[T]:
        future: Future[T] = Future()
        try:
            future.set_result(task())
        except Exception as error:  # passed on by `RegistrationCache.finish`
            future.set_exception(error)
        return future

    def close(self, within_s: float) -> None:
        """Nothing is under way."""


class RegistrationCache:
    """Cache of prepared clouds and pair registrations; views added during a scan are prepared in the background, which the context closes.

    The result of stitching is the same with and without it: an entry is used only where stitching would compute the same.

    Parameters
    ----------
    background : where views are prepared; None: at once, by the caller
    """

    def __init__(self, settings: StitchSettings | None = None, background: Background | None = None) -> None:
        self.settings = settings or StitchSettings()
        self._entries: dict[Hashable, Any] = {}
        self._clouds: dict[int, PointCloud] = {}  # keeps clouds alive, whose identities are part of the keys of `_entries`
        self._added: list[PlacedCloud] = []
        self._worker = background or _AtOnce()
        self._futures: list[Future[None]] = []

    def __enter__(self) -> RegistrationCache:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self._worker.close(STOPPED_WITHIN_S if error is not None else ENDED_WITHIN_S)

    def add(self, cloud: PointCloud, kinematic: RigidTransform) -> None:
        """Prepare a view and register it with the earlier ones in the background; returns immediately."""
        self._futures.append(self._worker.submit(partial(self._prepare_view, PlacedCloud(cloud, kinematic))))

    def finish(self) -> None:
        """Wait for the background tasks; raises their exceptions."""
        pending, self._futures = self._futures, []
        for future in pending:
            future.result()

    def _prepare_view(self, new: PlacedCloud) -> None:
        if len(new.cloud) < LEAST_POINTS:
            return
        earlier, self._added = self._added, sorted([*self._added, new], key=lambda placed: placed.cloud.viewpoint_id)
        voxel = self.voxel_mm([placed.cloud for placed in self._added], self.settings)
        for other in earlier:
            if self.overlap(new, other, voxel) >= self.settings.least_overlap:
                pair = sorted((new, other), key=lambda placed: placed.cloud.viewpoint_id)
                self.register_pair(pair[0], pair[1], (0, 1), voxel, self.settings)

    def voxel_mm(self, clouds: Iterable[PointCloud], settings: StitchSettings) -> float:
        """Return the voxel size for thinning, from the median point spacing."""
        if settings.registration_voxel_mm is not None:
            return settings.registration_voxel_mm
        wanted = VOXEL_PER_SPACING * float(np.median([self.spacing_mm(cloud) for cloud in clouds])) / LEAST_VOXEL_MM
        return LEAST_VOXEL_MM * float(2.0 ** (np.ceil(VOXEL_STEPS * np.log2(max(wanted, 1.0))) / VOXEL_STEPS))

    def spacing_mm(self, cloud: PointCloud) -> float:
        """Return the median point spacing of a cloud."""
        return self._once(cloud, ("spacing",), lambda: point_spacing_mm(np.asarray(cloud.points_mm)))

    def prepare(self, cloud: PointCloud, voxel_mm: float) -> PreparedCloud:
        """Return the cloud prepared for registration."""

        def work() -> PreparedCloud:
            prepared = prepare(cloud, voxel_mm)
            cloud.give_up_pages()  # of a large cloud, until it is merged
            return prepared

        return self._once(cloud, ("prepared", voxel_mm), work)

    def overlap(self, a: PlacedCloud, b: PlacedCloud, voxel_mm: float) -> float:
        """Return the overlap at the kinematic positions: share of the smaller view's occupied cells that the other view occupies too."""
        first, second = self._cells(a, voxel_mm), self._cells(b, voxel_mm)
        return len(np.intersect1d(first, second, assume_unique=True)) / max(1, min(len(first), len(second)))

    def _cells(self, placed: PlacedCloud, voxel_mm: float) -> IntArray:
        def work() -> IntArray:
            prepared, pose = self.prepare(placed.cloud, voxel_mm), placed.kinematic
            return occupied_cells(prepared, pose.apply(prepared.points_mm), pose.rotate(prepared.normals), CELL_PER_VOXEL * voxel_mm)

        return self._once(placed.cloud, ("cells", voxel_mm, _bytes(placed.kinematic)), work)

    def register_pair(
        self, target: PlacedCloud, source: PlacedCloud, indices: tuple[int, int], voxel_mm: float, settings: StitchSettings
    ) -> PairMeasurement:
        """Return the registration of two views, started from their kinematic positions."""
        start = target.kinematic.inverse() @ source.kinematic

        def work() -> PairMeasurement:
            a, b = self.prepare(target.cloud, voxel_mm), self.prepare(source.cloud, voxel_mm)
            return register_pair(a, b, start, indices, settings.search_mm)

        self._clouds[id(source.cloud)] = source.cloud
        key = ("pair", id(source.cloud), voxel_mm, _bytes(start), settings.search_mm)
        return replace(self._once(target.cloud, key, work), target=indices[0], source=indices[1])

    def _once(self, cloud: PointCloud, what: tuple[Hashable, ...], work: Callable[[], T]) -> T:
        """Return a cached value, or compute it; two threads may compute the same value concurrently."""
        self._clouds[id(cloud)] = cloud
        key = (id(cloud), *what)
        if key not in self._entries:
            self._entries[key] = work()
        return cast(T, self._entries[key])


def map_in_parallel(work: Callable[[A], T], items: Iterable[A], report: Callable[[int], None] | None = None) -> list[T]:
    """Return ``work`` of every item, in order, on one thread per processor; ``report`` gets the number of finished items."""
    results: list[T] = []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        pending = [pool.submit(work, item) for item in items]
        try:
            for future in pending:
                results.append(future.result())
                if report is not None:
                    report(len(results))
        finally:
            for future in pending:
                future.cancel()
    return results


def _bytes(transform: RigidTransform) -> bytes:
    return transform.matrix.tobytes()
