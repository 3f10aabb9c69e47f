from __future__ import annotations

import threading
from concurrent.futures import Future

import numpy as np
import pytest

from measureapp.data.cloud import StitchedCloud
from measureapp.progress import Cancelled
from measureapp.register.joint import registration_cache as module
from measureapp.register.joint.registration_cache import RegistrationCache, map_in_parallel
from measureapp.register.settings import StitchSettings
from measureapp.register.stitch import stitch

ANGLES = [0.0, 60.0, 120.0, 180.0, 240.0, 300.0]


@pytest.fixture(scope="module")
def scan(scanned, impeller_mesh):
    return scanned(impeller_mesh, ANGLES, [45.0], step_mm=1.0)


@pytest.fixture(scope="module")
def batch(scan) -> StitchedCloud:
    return stitch(scan.clouds, scan.kinematic)


@pytest.mark.parametrize("arrival", [[0, 1, 2, 3, 4, 5], [3, 5, 0, 4, 1, 2]])
def test_stitching_while_views_arrive_gives_exactly_what_stitching_afterwards_gives(scan, batch, arrival):
    with RegistrationCache() as registration_cache:
        for i in arrival:
            registration_cache.add(scan.clouds[i], scan.kinematic[i])
        ahead = stitch(scan.clouds, scan.kinematic, registration_cache=registration_cache)
    assert np.array_equal(ahead.points_mm, batch.points_mm)
    for one, other in zip(ahead.placements, batch.placements, strict=True):
        assert np.array_equal(one.part_from_camera.matrix, other.part_from_camera.matrix)
        assert (one.verdict, one.residual_mm, one.sigma_mm) == (other.verdict, other.residual_mm, other.sigma_mm)


def test_no_pair_remains_to_be_registered_after_the_last_view(scan, monkeypatch):
    with RegistrationCache() as registration_cache:
        for cloud, kinematic in zip(scan.clouds, scan.kinematic, strict=True):
            registration_cache.add(cloud, kinematic)
        registration_cache.finish()
        monkeypatch.setattr(module, "register_pair", None)
        monkeypatch.setattr(module, "prepare", None)
        stitched = stitch(scan.clouds, scan.kinematic, registration_cache=registration_cache)
    assert all(placement.verdict == "good" for placement in stitched.placements)


def test_views_not_stitched_in_the_end_change_nothing(scan):
    chosen = [0, 1, 2, 4]
    clouds, kinematic = [scan.clouds[i] for i in chosen], [scan.kinematic[i] for i in chosen]
    with RegistrationCache() as registration_cache:
        for cloud, pose in zip(scan.clouds, scan.kinematic, strict=True):
            registration_cache.add(cloud, pose)
        ahead = stitch(clouds, kinematic, registration_cache=registration_cache)
    assert np.array_equal(ahead.points_mm, stitch(clouds, kinematic).points_mm)


def test_a_pair_registered_for_other_settings_or_poses_is_not_taken(scan):
    settings = StitchSettings(search_mm=2.0)
    with RegistrationCache() as registration_cache:
        for cloud, truth in zip(scan.clouds, scan.truth, strict=True):
            registration_cache.add(cloud, truth)
        ahead = stitch(scan.clouds, scan.kinematic, settings, registration_cache=registration_cache)
    assert np.array_equal(ahead.points_mm, stitch(scan.clouds, scan.kinematic, settings).points_mm)


def test_a_failure_during_preparation_is_reported_with_the_result(scan, monkeypatch):
    def broken(*_: object) -> None:
        raise MemoryError("too little memory")

    monkeypatch.setattr(module, "prepare", broken)
    with RegistrationCache() as registration_cache:
        registration_cache.add(scan.clouds[0], scan.kinematic[0])
        registration_cache.add(scan.clouds[1], scan.kinematic[1])
        with pytest.raises(MemoryError, match="too little memory"):
            registration_cache.finish()


def test_a_registration_under_way_is_left_behind_when_a_scan_is_stopped(scan):
    begun, released = threading.Event(), threading.Event()

    class Stuck:
        closed_within_s = -1.0

        def submit(self, task):
            threading.Thread(target=lambda: (begun.set(), released.wait()), daemon=True).start()
            return Future()

        def close(self, within_s):
            self.closed_within_s = within_s

    background = Stuck()
    with pytest.raises(Cancelled), RegistrationCache(background=background) as cache:
        cache.add(scan.clouds[0], scan.kinematic[0])
        begun.wait(5.0)
        raise Cancelled
    released.set()
    assert 0.0 <= background.closed_within_s < 1.0


def test_the_first_failure_of_parallel_work_ends_it():
    def work(number: int) -> int:
        if number == 3:
            raise ValueError("three")
        return number

    heard: list[int] = []
    with pytest.raises(ValueError, match="three"):
        map_in_parallel(work, range(1000), heard.append)
    assert heard == [1, 2, 3]
