"""Axes are doubted where all views depart in one pattern, not where they err as stated, and not for a single displaced view."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.register.joint.axis_doubt import AxisPattern, are_many, doubt_axes
from measureapp.register.joint.innovation_test import estimate_free_correction, innovation_limit
from measureapp.register.joint.pose_prior import carry_to_centres
from measureapp.register.pairs.icp import apply_motion
from tests.register.joint.test_innovation import LOOSE, SIGMAS, VIEWS, by_axes, drawn

STATED = by_axes(0.02, 0.003)
ANGLES = 2 * np.pi * np.arange(VIEWS) / VIEWS
UNIT_MM = 0.005


def patterns(kinematic, centres):
    """A displacement in the part's frame that goes twice around with the table's angle, and one of every view's own, in the cameras' frames."""
    about_centres = np.zeros((6 * VIEWS, 2))
    for view, angle in enumerate(ANGLES):
        about_centres[6 * view : 6 * view + 3] = UNIT_MM * np.array(
            [[np.cos(2 * angle), np.sin(2 * angle)], [np.sin(2 * angle), -np.cos(2 * angle)], [0, 0]]
        )
    back = np.linalg.inv(carry_to_centres(kinematic, centres))
    own = back @ np.kron(np.eye(VIEWS), np.diag([UNIT_MM] * 3 + [UNIT_MM / 400] * 3))
    return (
        AxisPattern("follows the angle", "the table", "Calibrate.", back @ about_centres),
        AxisPattern("differs from view to view", "the axes", "Calibrate.", own),
    )


def doubt(kinematic, pairs, centres, covariance=STATED):
    found = doubt_axes(patterns(kinematic, centres), kinematic, pairs, centres, covariance, carry_to_centres(kinematic, centres))
    return found if found is not None and found.is_certain else None


def contradicting(kinematic, pairs, centres, covariance) -> int:
    found = [estimate_free_correction(view, kinematic, pairs, centres, covariance, LOOSE) for view in range(VIEWS)]
    return sum(one is not None and one.distance > innovation_limit(SIGMAS, VIEWS) for one in found)


def displaced(kinematic, centres, size: float, rng):
    """The kinematic poses with the first pattern of a random phase."""
    moves = (carry_to_centres(kinematic, centres) @ patterns(kinematic, centres)[0].motions @ (size * rng.normal(size=2))).reshape(-1, 6)
    return [apply_motion(pose, move, centre) for pose, move, centre in zip(kinematic, moves, centres, strict=True)]


def test_axes_that_err_as_stated_are_not_doubted() -> None:
    rng = np.random.default_rng(5)
    assert sum(doubt(*drawn(STATED, rng)) is not None for _ in range(80)) <= 1


def test_what_the_stated_errors_explain_widens_nothing_that_matters() -> None:
    rng, added = np.random.default_rng(9), []
    for _ in range(20):
        kinematic, pairs, centres = drawn(STATED, rng)
        carry = carry_to_centres(kinematic, centres)
        found = doubt_axes(patterns(kinematic, centres), kinematic, pairs, centres, STATED, carry)
        assert found is not None
        added.append(np.diag(carry @ found.covariance @ carry.T).reshape(-1, 6)[:, :3].mean())
    assert np.sqrt(np.median(added)) < 0.0015  # against 0.003 mm of every view's own


def test_a_table_that_departs_in_one_pattern_is_doubted_by_name_and_its_views_are_kept() -> None:
    rng = np.random.default_rng(6)
    names, many, left = [], [], []
    for _ in range(20):
        kinematic, pairs, centres = drawn(STATED, rng)
        kinematic = displaced(kinematic, centres, 8.0, rng)
        found = doubt(kinematic, pairs, centres)
        many.append(are_many(contradicting(kinematic, pairs, centres, STATED), VIEWS))
        names.append("" if found is None else found.pattern.what)
        if found is not None:
            carry = carry_to_centres(kinematic, centres)
            left.append(contradicting(kinematic, pairs, centres, STATED + carry @ found.covariance @ carry.T))
    assert np.mean(many) > 0.5  # they would have been left out
    assert names.count("the table") >= 16
    assert np.mean(left) < 0.1


def test_the_sentence_names_pattern_size_and_remedy() -> None:
    rng = np.random.default_rng(7)
    kinematic, pairs, centres = drawn(STATED, rng)
    found = doubt(displaced(kinematic, centres, 8.0, rng), pairs, centres)
    assert found is not None
    assert "follows the angle" in found.sentence
    assert "mm rms" in found.sentence
    assert found.sentence.endswith("Calibrate.")
    assert 0.005 < found.size_mm < 0.2


def test_neither_a_displaced_view_nor_views_that_slipped_by_millimetres_are_taken_for_axes() -> None:
    rng = np.random.default_rng(8)
    kinematic, pairs, centres = drawn(STATED, rng)
    kinematic[2] = apply_motion(kinematic[2], np.array([2.0, 0, 0, 0, 0, 0]), centres[2])
    without = [pair for pair in pairs if 2 not in (pair.target, pair.source)]
    assert doubt(kinematic, without, centres) is None
    assert doubt(displaced(kinematic, centres, 400.0, rng), pairs, centres) is None


@pytest.mark.parametrize(("contradicting", "views", "many"), [(2, 6, False), (3, 8, True), (3, 26, False), (7, 26, True)])
def test_three_views_or_a_quarter_of_them_are_many(contradicting: int, views: int, many: bool) -> None:
    assert are_many(contradicting, views) is many
