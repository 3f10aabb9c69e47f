"""A whole view with the projector as one more eye."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.cloud import PROJECTOR_BIT
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.reconstruct.projector.with_projector import reconstruct_view_with_projector
from measureapp.reconstruct.reconstruct import reconstruct
from tests.reconstruct.conftest import plane
from tests.reconstruct.projector_scene import ProjectorHead, make_head

PLANE = plane(550, 0.2, 0.1)


@pytest.fixture(scope="module")
def head() -> ProjectorHead:
    return make_head(binning=8)


def blinded(phase_map: PhaseMap, columns: slice) -> PhaseMap:
    state = phase_map.state.copy()
    state[:, columns] = PixelState.SHADOW
    return replace(phase_map, state=state)


def test_what_the_left_camera_alone_sees_gets_points_of_the_projector(head: ProjectorHead) -> None:
    maps = head.phase_maps(PLANE, noise_seed=3)
    maps = {name: maps["left"] if name == "left" else blinded(maps[name], slice(100, 200)) for name in maps}
    by_cameras = reconstruct(maps, head.cameras)
    made = reconstruct_view_with_projector(maps, head.cameras)
    assert (by_cameras.states["left"] == PointState.UNMATCHED).sum() > 1000
    assert made.points > 0.9 * (by_cameras.states["left"] == PointState.UNMATCHED).sum()
    cloud = made.reconstruction.cloud
    filled = cloud.cameras & PROJECTOR_BIT != 0
    assert filled.sum() == made.points == len(cloud) - len(by_cameras.cloud)
    truth = head.depth_mm("left", PLANE)[cloud.pixel[filled, 0], cloud.pixel[filled, 1]]
    off = cloud.points_mm[filled, 2] - truth
    assert (off / cloud.sigma_mm[filled]).std() == pytest.approx(1.0, abs=0.15)
    assert (made.reconstruction.states["left"] == PointState.VALID).sum() >= (
        by_cameras.states["left"] == PointState.VALID
    ).sum() + made.points
    assert made.agreement["left"].refused == ""


def test_one_camera_and_the_projector_measure_alone(head: ProjectorHead) -> None:
    maps = {"left": head.phase_maps(PLANE, noise_seed=3)["left"]}
    made = reconstruct_view_with_projector(maps, head.cameras)
    assert made.points == len(made.reconstruction.cloud) > 0.98 * maps["left"].valid.sum()
    assert np.all(made.reconstruction.cloud.cameras & PROJECTOR_BIT)


def test_without_a_calibrated_projector_it_is_refused(head: ProjectorHead) -> None:
    maps = head.phase_maps(PLANE)
    with pytest.raises(ReconstructError, match="projector is not calibrated"):
        reconstruct_view_with_projector(maps, head.without_projector())
