"""Views held back tell whether a projector that is added to calibrated cameras can be trusted."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.cameras.array import solve
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.cameras.validation import cross_validate
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about
from tests.calibrate import paper_head

SIGMA_PX = 0.1
LENS = [-0.05, 0.03, 4e-4, -3e-4, 0.0]
STRANGE = [-0.1, 0.6, 0, 0, 3.0, 0.1, 0.9, 2.0]


def with_projector(cameras: CameraArrayCalibration, lens: list[float]) -> CameraArrayCalibration:
    """Return the head with a projector of the cameras' image size between left and right, so that it sees what they see."""
    focal, (width, height) = paper_head.FOCAL, paper_head.SIZE
    pinhole = PinholeCamera(width, height, np.array([[focal, 0, width / 2 + 9], [0, focal, height / 2 - 7], [0, 0, 1]]), lens)
    place = RigidTransform.from_parts(rotation_about([0, 1, 0], -0.30), [165.0, 20.0, 30.0], "camera", PROJECTOR)
    return replace(cameras, cameras={**cameras.cameras, PROJECTOR: CameraCalibration(PROJECTOR, pinhole, place)})


def checked(seed: int, lens: list[float], sigma_px: float = SIGMA_PX, distortion_count: int = 5):
    """Calibrate cameras from views of their own, add the projector from others, and hold views back."""
    generator = np.random.default_rng(seed)
    truth = paper_head.drawn_head(generator)
    known = solve(replace(paper_head.problem(truth, 14, sigma_px, generator), distortion_count=distortion_count)).calibration
    seen = paper_head.problem(with_projector(truth, lens), 14, sigma_px, generator)
    problem = replace(seen, known=known, distortion_count=distortion_count)
    return cross_validate(problem, solve(problem))


def test_a_projector_beside_given_cameras_predicts_views_held_back():
    ratios = []
    for seed in range(2):
        validation = checked(seed, LENS)
        assert validation.healthy
        assert validation.observed_px == pytest.approx(validation.predicted_px, rel=0.05)
        assert [half.camera for half in validation.halves] == [PROJECTOR]  # the cameras were given: they are not checked here
        assert "px for the projector, with" in validation.verdict
        ratios += [half.difference_px / half.predicted_px for half in validation.halves]
    assert 0.4 < np.sqrt(np.mean(np.square(ratios))) < 1.7  # two differences of about five degrees of freedom


def test_a_projector_whose_lens_does_not_follow_the_model_is_noticed():
    validation = checked(4, STRANGE, sigma_px=0.02, distortion_count=4)
    assert not validation.healthy
    assert "there are errors other than noise" in validation.verdict
