"""Views held back tell a calibration that can be trusted from one that cannot."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.cameras.array import solve
from measureapp.calibrate.cameras.validation import cross_validate
from measureapp.errors import CalibrationError
from measureapp.geometry.pinhole import PinholeCamera
from tests.calibrate import paper_head


def test_held_back_views_fit_as_predicted_when_the_model_is_right():
    ratios = []
    for seed in range(2):
        generator = np.random.default_rng(seed)
        problem = paper_head.problem(paper_head.drawn_head(generator), 14, 0.1, generator)
        validation = cross_validate(problem, solve(problem))
        ratios += [half.difference_px / half.predicted_px for half in validation.halves]
        assert validation.healthy
        assert validation.observed_px == pytest.approx(validation.predicted_px, rel=0.03)
        assert "can be trusted" in validation.verdict
        assert len(validation.views) == 14
    assert 0.6 < np.sqrt(np.mean(np.square(ratios))) < 1.5  # six differences of about five degrees of freedom


def test_a_lens_that_does_not_follow_the_model_is_noticed():
    generator = np.random.default_rng(4)
    head = paper_head.drawn_head(generator)
    strange = {}
    for name, camera in head.cameras.items():
        lens = PinholeCamera(*paper_head.SIZE, camera.pinhole.matrix, [-0.1, 0.6, 0, 0, 3.0, 0.1, 0.9, 2.0])
        strange[name] = replace(camera, pinhole=lens)
    problem = paper_head.problem(replace(head, cameras=strange), 12, 0.02, generator)
    poor = replace(problem, distortion_count=4)
    validation = cross_validate(poor, solve(poor))
    assert not validation.healthy
    assert "there are errors other than noise" in validation.verdict


def test_a_bent_board_taken_as_flat_is_noticed():
    generator = np.random.default_rng(5)
    head = paper_head.drawn_head(generator)
    flat, bent = paper_head.BOARD, paper_head.BOARD.model_copy(update={"bow_mm": (0.15, 0.05, -0.1)})
    sightings = [
        one for view in range(12) for one in paper_head.seen(head, paper_head.board_pose(generator), 0.05, generator, f"{view:02d}", bent)
    ]
    problem = replace(paper_head.problem(head, 3, 0.05, generator), board=flat, sightings=tuple(sightings))
    honest = cross_validate(problem, solve(problem))
    taken_flat = replace(problem, free_bow=False)
    assert honest.healthy
    assert not cross_validate(taken_flat, solve(taken_flat)).healthy


def test_three_views_are_too_few_to_hold_some_back():
    generator = np.random.default_rng(6)
    problem = paper_head.problem(paper_head.drawn_head(generator), 3, 0.1, generator)
    with pytest.raises(CalibrationError, match="too few to hold some back"):
        cross_validate(problem, solve(problem))
