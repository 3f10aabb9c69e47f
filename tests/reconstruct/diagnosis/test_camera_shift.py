"""What the phases of a view say about a camera that turned since the calibration."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.camera_shift import ShiftEvidence
from measureapp.geometry.transform import RigidTransform
from measureapp.reconstruct.diagnosis.camera_shift import camera_shift
from tests.reconstruct.conftest import Head, make_head, nearest, plane, sphere

SIGMA_RAD = 0.005
SCENE = nearest(plane(600, 0.2, 0.1), sphere((0.0, 0.0, 560.0), 60.0))
TURN_RAD = np.deg2rad([0.0, 0.03, -0.05])  # upright fringes hardly see a turn about x, which moves images along them


def knocked(cameras: CameraArrayCalibration, name: str, turn_rad: FloatArray) -> CameraArrayCalibration:
    """The calibration that a head had before ``name`` turned by ``turn_rad``; its images are taken with ``cameras``."""
    back = RigidTransform.from_vector(-turn_rad, np.zeros(3), name, name)
    if name != cameras.reference:
        moved = replace(cameras.cameras[name], reference_from_camera=cameras.cameras[name].reference_from_camera @ back)
        return replace(cameras, cameras={**cameras.cameras, name: moved})
    turn = RigidTransform.from_vector(turn_rad, np.zeros(3), "camera", "camera")
    others = {
        other: one if other == name else replace(one, reference_from_camera=turn @ one.reference_from_camera)
        for other, one in cameras.cameras.items()
    }
    return replace(cameras, cameras=others)


def solved(evidence: ShiftEvidence, name: str) -> tuple[FloatArray, FloatArray]:
    """The turn of one camera alone, and its standard deviations."""
    own = slice(3 * evidence.cameras.index(name), 3 * evidence.cameras.index(name) + 3)
    covariance = np.linalg.inv(evidence.information[own, own])
    return covariance @ evidence.gradient[own], np.sqrt(np.diag(covariance))


@pytest.mark.parametrize("name", ["left", "right", "upper"])
def test_the_turn_of_a_camera_comes_out_within_its_noise(head: Head, name: str) -> None:
    maps = head.phase_maps(SCENE, SIGMA_RAD, 3)
    evidence = camera_shift(maps, knocked(head.cameras, name, TURN_RAD))
    assert evidence is not None and evidence.freedom == evidence.samples > 300
    turn, sigma = solved(evidence, name)
    assert np.all(np.abs(turn - TURN_RAD)[1:] < 5 * sigma[1:] + 0.02 * np.abs(TURN_RAD[1:]))  # and what is beyond first order


def test_noise_alone_gives_no_turn_and_residuals_of_its_size(head: Head) -> None:
    evidence = camera_shift(head.phase_maps(SCENE, SIGMA_RAD, 5), head.cameras)
    assert evidence is not None
    for name in evidence.cameras:
        turn, sigma = solved(evidence, name)
        assert np.all(np.abs(turn)[1:] < 5 * sigma[1:])  # a turn about x shows in the direction of the fringes alone, that is badly
    # interpolation between pixels averages noise: the variance is between a quarter of the predicted and all of it, for two cameras of three
    assert 0.25 < evidence.misfit / evidence.freedom < 1.0 + 5 * np.sqrt(2 / evidence.freedom)


def test_two_cameras_need_fringes_of_both_directions() -> None:
    head = make_head(8, ("left", "right"))
    columns = head.phase_maps(SCENE, SIGMA_RAD, 3)
    assert camera_shift(columns, head.cameras) is None
    rows = head.phase_maps(SCENE, SIGMA_RAD, 4, horizontal=True)
    both = {name: replace(each, orthogonal=rows[name]) for name, each in columns.items()}
    turn = np.array([3e-4, 0.0, 0.0])  # about the line of sight across the rows; the columns cannot tell a turn from depth
    evidence = camera_shift(both, knocked(head.cameras, "right", turn))
    assert evidence is not None and evidence.freedom == evidence.samples
    found, sigma = solved(evidence, "right")
    assert abs(found[0] - turn[0]) < 5 * sigma[0] + 0.02 * turn[0]


def test_a_view_with_few_points_says_nothing(head: Head) -> None:
    small = sphere((0.0, 0.0, 550.0), 2.0)
    assert camera_shift(head.phase_maps(small, SIGMA_RAD, 3), head.cameras) is None
