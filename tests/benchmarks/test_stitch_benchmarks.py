"""Stitching 36 views, and one pair beside small_gicp and Open3D on the same clouds; run with ``-m slow``.

Asked for: 36 clouds within 30 s on two processors (stretch 15 s), a pair no slower than small_gicp's own GICP and 1.4 times as fast as
Open3D's, from the clouds to the pose, at equal accuracy. Times of processors are held against the bounds, so that other work on the
machine does not decide; wall-clock times stand beside them in the record of each run.
"""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter, process_time
from typing import Any

import numpy as np
import pytest

from measureapp.data.cloud import PointCloud
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.registration_cache import map_in_parallel
from measureapp.register.pairs.icp import apply_motion, register_pair
from measureapp.register.pairs.prepare import prepare
from measureapp.register.stitch import stitch
from tests.register.conftest import impeller, scanned

__all__ = ["scanned"]  # the fixture

Benchmark = Callable[..., Any]
pytestmark = pytest.mark.slow

VIEWS, PROCESSORS, MOST_SECONDS = 36, 2, 30.0
VOXEL_MM, SEARCH_MM, STEP_MM = 0.8, 3.0, 0.2
ROUNDS = 5
LEAST_OF_SMALL_GICP, LEAST_OF_OPEN3D = 1.0, 1.4
START = RigidTransform.from_vector(np.radians([0.2, -0.15, 0.1]), [0.5, -0.4, 0.6], "camera", "camera")
AS_EXACT_MM = 0.001


def by_ours(target: PointCloud, source: PointCloud, start: RigidTransform) -> RigidTransform:
    a, b = map_in_parallel(lambda cloud: prepare(cloud, VOXEL_MM), (target, source))
    found = register_pair(a, b, start, (0, 1), SEARCH_MM)
    return apply_motion(found.target_from_source, found.change, found.centre_mm)


def by_small_gicp(target: PointCloud, source: PointCloud, start: RigidTransform) -> RigidTransform:
    import small_gicp

    result = small_gicp.align(
        np.asarray(target.points_mm), np.asarray(source.points_mm), start.matrix, registration_type="GICP",
        downsampling_resolution=VOXEL_MM, max_correspondence_distance=SEARCH_MM, num_threads=PROCESSORS,
    )  # fmt: skip
    return transform(result.T_target_source)


def by_open3d(target: PointCloud, source: PointCloud, start: RigidTransform) -> RigidTransform:
    import open3d as o3d

    made = []
    for cloud in (target, source):
        thinned = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.array(cloud.points_mm))).voxel_down_sample(VOXEL_MM)
        thinned.estimate_covariances()
        made.append(thinned)
    result = o3d.pipelines.registration.registration_generalized_icp(made[1], made[0], SEARCH_MM, start.matrix)
    return transform(result.transformation)


def transform(matrix: np.ndarray) -> RigidTransform:
    u, _, vt = np.linalg.svd(matrix[:3, :3])
    return RigidTransform.from_parts(u @ vt, matrix[:3, 3], "camera", "camera")


def test_a_pair_is_registered_as_fast_and_as_exactly_as_by_small_gicp_and_open3d(benchmark: Benchmark, scanned: Any) -> None:
    scan = scanned(impeller(), [0.0, 30.0], [45.0], step_mm=STEP_MM)
    target, source = scan.clouds
    truth = scan.truth[0].inverse() @ scan.truth[1]
    ways = {"ours": by_ours, "small_gicp": by_small_gicp, "Open3D": by_open3d}
    seconds: dict[str, list[float]] = {name: [] for name in ways}
    used: dict[str, list[float]] = {name: [] for name in ways}
    error: dict[str, float] = {}
    sample = np.asarray(source.points_mm)[::50]
    for _ in range(ROUNDS):
        for name, way in ways.items():
            start, start_of_process = perf_counter(), process_time()
            found = way(target, source, START @ truth)
            seconds[name].append(perf_counter() - start)
            used[name].append(process_time() - start_of_process)
            error[name] = float(np.sqrt(np.mean(np.sum((found.apply(sample) - truth.apply(sample)) ** 2, axis=1))))
    benchmark.pedantic(by_ours, (target, source, START @ truth), rounds=ROUNDS)
    clock = {name: min(values) for name, values in seconds.items()}
    ratios = {name: clock[name] / clock["ours"] for name in ways}
    benchmark.extra_info.update(
        {"times ours": ratios, "processor ms": {name: 1e3 * min(values) for name, values in used.items()}, "error_mm": error}
    )
    assert error["ours"] < min(error["small_gicp"], error["Open3D"]) + AS_EXACT_MM
    assert ratios["small_gicp"] > LEAST_OF_SMALL_GICP
    assert ratios["Open3D"] > LEAST_OF_OPEN3D


def test_36_views_are_stitched_within_thirty_seconds_of_two_processors(benchmark: Benchmark, scanned: Any) -> None:
    scan = scanned(impeller(), [30.0 * k for k in range(12)], [25.0, 45.0, 70.0], step_mm=STEP_MM, station_mm=0.2, station_deg=0.02)
    assert len(scan.clouds) == VIEWS
    stitch(scan.clouds[:2], scan.kinematic[:2])  # compiles
    start, start_of_process = perf_counter(), process_time()
    stitched = benchmark.pedantic(stitch, (scan.clouds, scan.kinematic), {"stations": scan.stations}, rounds=1)
    clock, used = perf_counter() - start, process_time() - start_of_process
    benchmark.extra_info.update({"seconds": clock, "processor seconds": used, "points": sum(len(cloud) for cloud in scan.clouds)})
    assert all(placement.verdict == "good" for placement in stitched.placements)
    assert used < MOST_SECONDS * PROCESSORS
