"""What stitching needs of single views and of pairs of them: made once, and during a scan as soon as a view is there."""

from __future__ import annotations

import os
from collections.abc import Callable, Hashable, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from types import TracebackType
from typing import Any, TypeVar, cast

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
LEAST_VOXEL_MM = 0.7  # finer thinning registers no better, but takes its time
VOXEL_STEPS = 4  # per factor of two; so that one view more seldom asks for another voxel
CELL_PER_VOXEL = 5.0
T = TypeVar("T")
A = TypeVar("A")


@dataclass(frozen=True, slots=True, eq=False)
class PlacedCloud:
    """A cloud and where the axes put it."""

    cloud: PointCloud
    kinematic: RigidTransform  # part_from_camera


class Groundwork:
    """Remembers what was made of clouds; views that are added beforehand are worked on by a thread of its own, which the context ends.

    It never changes what stitching gives: what was made ahead is taken where stitching would make the same, and else made anew.
    """

    def __init__(self, settings: StitchSettings | None = None) -> None:
        self.settings = settings or StitchSettings()
        self._made: dict[Hashable, Any] = {}
        self._kept: dict[int, PointCloud] = {}  # keeps the identities in the keys of `_made` from being given away again
        self._added: list[PlacedCloud] = []
        self._ahead = ThreadPoolExecutor(1, "stitching-ahead")
        self._begun: list[Future[None]] = []

    def __enter__(self) -> Groundwork:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self._ahead.shutdown(wait=True, cancel_futures=True)

    def add(self, cloud: PointCloud, kinematic: RigidTransform) -> None:
        """Begin to prepare a view and to register it with the earlier ones; returns at once."""
        self._begun.append(self._ahead.submit(self._work_on, PlacedCloud(cloud, kinematic)))

    def finish(self) -> None:
        """Wait for what was begun; raises what failed in it."""
        begun, self._begun = self._begun, []
        for future in begun:
            future.result()

    def _work_on(self, new: PlacedCloud) -> None:
        if len(new.cloud) < LEAST_POINTS:
            return
        earlier, self._added = self._added, sorted([*self._added, new], key=lambda placed: placed.cloud.viewpoint_id)
        voxel = self.voxel_mm([placed.cloud for placed in self._added], self.settings)
        for other in earlier:
            if self.overlap(new, other, voxel) >= self.settings.least_overlap:
                pair = sorted((new, other), key=lambda placed: placed.cloud.viewpoint_id)
                self.registered(pair[0], pair[1], (0, 1), voxel, self.settings)

    def voxel_mm(self, clouds: Iterable[PointCloud], settings: StitchSettings) -> float:
        """Return the edge of the voxels in which clouds are thinned, by the usual spacing of their points."""
        if settings.registration_voxel_mm is not None:
            return settings.registration_voxel_mm
        wanted = VOXEL_PER_SPACING * float(np.median([self.spacing_mm(cloud) for cloud in clouds])) / LEAST_VOXEL_MM
        return LEAST_VOXEL_MM * float(2.0 ** (np.ceil(VOXEL_STEPS * np.log2(max(wanted, 1.0))) / VOXEL_STEPS))

    def spacing_mm(self, cloud: PointCloud) -> float:
        """Return the usual distance of neighbouring points of a cloud."""
        return self._once(cloud, ("spacing",), lambda: point_spacing_mm(np.asarray(cloud.points_mm)))

    def prepared(self, cloud: PointCloud, voxel_mm: float) -> PreparedCloud:
        """Return the thinned cloud."""
        return self._once(cloud, ("prepared", voxel_mm), lambda: prepare(cloud, voxel_mm))

    def overlap(self, a: PlacedCloud, b: PlacedCloud, voxel_mm: float) -> float:
        """Return the share of the smaller view's surface that lies in cells of the other's, where the axes put them."""
        first, second = self._cells(a, voxel_mm), self._cells(b, voxel_mm)
        return len(np.intersect1d(first, second, assume_unique=True)) / max(1, min(len(first), len(second)))

    def _cells(self, placed: PlacedCloud, voxel_mm: float) -> IntArray:
        def work() -> IntArray:
            prepared, pose = self.prepared(placed.cloud, voxel_mm), placed.kinematic
            return occupied_cells(prepared, pose.apply(prepared.points_mm), pose.rotate(prepared.normals), CELL_PER_VOXEL * voxel_mm)

        return self._once(placed.cloud, ("cells", voxel_mm, _bytes(placed.kinematic)), work)

    def registered(
        self, target: PlacedCloud, source: PlacedCloud, indices: tuple[int, int], voxel_mm: float, settings: StitchSettings
    ) -> PairMeasurement:
        """Return the registration of two views from where the axes put them."""
        start = target.kinematic.inverse() @ source.kinematic

        def work() -> PairMeasurement:
            a, b = self.prepared(target.cloud, voxel_mm), self.prepared(source.cloud, voxel_mm)
            return register_pair(a, b, start, indices, settings.search_mm)

        self._kept[id(source.cloud)] = source.cloud
        key = ("pair", id(source.cloud), voxel_mm, _bytes(start), settings.search_mm)
        return replace(self._once(target.cloud, key, work), target=indices[0], source=indices[1])

    def _once(self, cloud: PointCloud, what: tuple[Hashable, ...], work: Callable[[], T]) -> T:
        """Return what is remembered; two threads that ask at once may both make it, and make the same."""
        self._kept[id(cloud)] = cloud
        key = (id(cloud), *what)
        if key not in self._made:
            self._made[key] = work()
        return cast(T, self._made[key])


def in_parallel(work: Callable[[A], T], items: Iterable[A], tell: Callable[[int], None] | None = None) -> list[T]:
    """Return what ``work`` gives for every item, in their order, by one thread per processor; ``tell`` hears how many are done."""
    results: list[T] = []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        pending = [pool.submit(work, item) for item in items]
        try:
            for future in pending:
                results.append(future.result())
                if tell is not None:
                    tell(len(results))
        finally:
            for future in pending:
                future.cancel()
    return results


def _bytes(transform: RigidTransform) -> bytes:
    return transform.matrix.tobytes()
