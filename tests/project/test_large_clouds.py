from __future__ import annotations

import gc
from pathlib import Path

import numpy as np
import pytest

from measureapp.data.cloud import PointCloud
from measureapp.project import large_clouds
from measureapp.project.large_clouds import ARRAYS, map_large


def cloud_of(count: int) -> PointCloud:
    rng = np.random.default_rng(1)
    return PointCloud(
        rng.normal(size=(count, 3)),
        rng.normal(size=(count, 3)),
        rng.random(count),
        rng.random(count),
        rng.integers(0, 2000, (count, 2)),
        rng.integers(0, 255, count),
        "camera",
        "v01",
    )


@pytest.fixture
def on_disk(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> tuple[PointCloud, PointCloud]:
    monkeypatch.setattr(large_clouds, "LARGE_BYTES", 1000)
    cloud = cloud_of(1001)
    return cloud, map_large(cloud, tmp_path)


def test_a_large_cloud_is_the_same_on_disk_and_cannot_be_changed(on_disk: tuple[PointCloud, PointCloud], tmp_path: Path) -> None:
    cloud, mapped = on_disk
    assert mapped is not cloud and (mapped.frame, mapped.viewpoint_id) == ("camera", "v01")
    for name in ARRAYS:
        there, before = getattr(mapped, name), getattr(cloud, name)
        np.testing.assert_array_equal(there, before)
        assert there.dtype == before.dtype and not there.flags.owndata and not there.flags.writeable
    assert not list(tmp_path.iterdir())  # the file has no name


def test_a_part_of_it_outlives_it(on_disk: tuple[PointCloud, PointCloud]) -> None:
    cloud, mapped = on_disk
    points = mapped.points_mm[::2]
    del mapped, on_disk
    gc.collect()
    np.testing.assert_array_equal(points, cloud.points_mm[::2])


def test_a_small_cloud_stays_as_it_is_and_so_does_one_without_room(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    small = cloud_of(100)
    assert map_large(small, tmp_path) is small
    monkeypatch.setattr(large_clouds, "LARGE_BYTES", 1000)
    assert map_large(small, tmp_path / "not there") is small
