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


@pytest.mark.skipif(not Path("/proc/self/smaps").exists(), reason="the system does not state what is in memory")
def test_it_leaves_memory_until_it_is_used_again(on_disk: tuple[PointCloud, PointCloud]) -> None:
    cloud, mapped = on_disk
    np.testing.assert_array_equal(mapped.points_mm, cloud.points_mm)
    assert _mapped_kib(mapped) > 0
    mapped.give_up_pages()
    assert _mapped_kib(mapped) == 0
    cloud.give_up_pages()  # has no file to come back from
    for name in ARRAYS:
        np.testing.assert_array_equal(getattr(mapped, name), getattr(cloud, name))


def _mapped_kib(cloud: PointCloud) -> int:
    """Return how much of the mapping that holds a cloud is in memory."""
    address, inside = cloud.points_mm.ctypes.data, False
    for line in Path("/proc/self/smaps").read_text().splitlines():
        first = line.split()[0]
        if "-" in first and ":" not in first:
            start, end = (int(part, 16) for part in first.split("-"))
            inside = start <= address < end
        elif inside and first == "Rss:":
            return int(line.split()[1])
    raise AssertionError("not mapped")
