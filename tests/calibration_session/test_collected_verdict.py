"""The verdict in millimetres, and the comparison with the calibration before."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.draft.draft import Limits, Setup
from measureapp.calibrate.draft.verdict import compare, evaluate
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibration_session.accepting import accept, read_result
from measureapp.calibration_session.session import CalibrationSession
from measureapp.errors import CalibrationError
from tests.calibration_session.shown_board import Shown

CAMERAS = ("left", "right", "upper")


@pytest.fixture
def collected(tmp_path, monkeypatch, head, board, simulate):
    """Return solved sessions of views with the same truth, or of a head that was knocked."""

    def made(name, seed, sigma_px=0.05, views=8, of=head):
        generator, shown = np.random.default_rng(seed), Shown(monkeypatch, sigma_px)
        session = CalibrationSession.create(tmp_path / name, Setup(KINDS["cameras"], board, CAMERAS))
        for _ in range(views):
            shown.add(session, simulate.corners(of, board, simulate.board_pose(generator), sigma_px, generator))
        session.solve()
        return session

    return made


def knocked(head):
    """The head with its right camera turned by 0.1°: 1 mm at the part."""
    from dataclasses import replace

    from measureapp.geometry.transform import RigidTransform, rotation_about

    right = head.cameras["right"]
    turned = RigidTransform.from_parts(
        right.reference_from_camera.rotation @ rotation_about([1, 0.3, 0], np.deg2rad(0.1)),
        right.reference_from_camera.translation_mm + np.array([0.3, 0.2, 0]),
        "camera",
        "right",
    )
    return replace(head, cameras={**head.cameras, "right": replace(right, reference_from_camera=turned)})


def test_the_verdict_states_a_length_in_mm_and_follows_its_limits(collected):
    session = collected("one", 1)
    verdict = evaluate(session.draft)
    assert "to a length of 300 mm" in verdict.sentence
    assert verdict.sentence.startswith("Adds ")
    assert evaluate(session.draft, Limits(verdict.expanded_mm * 1.01, 1.0, "a test")).level == ("usable" if verdict.reasons else "good")
    assert evaluate(session.draft, Limits(verdict.expanded_mm / 2, verdict.expanded_mm * 1.01, "a test")).level == "usable"
    worse = evaluate(session.draft, Limits(verdict.expanded_mm / 2, verdict.expanded_mm / 1.5, "a test"))
    assert worse.level == "bad"
    assert "4.0 times as many observations" in worse.remedy


def test_twice_the_noise_makes_the_verdict_twice_as_large(collected):
    one, two = (evaluate(collected(name, 1, sigma).draft).expanded_mm for name, sigma in (("one", 0.05), ("two", 0.10)))
    assert two / one == pytest.approx(2.0, rel=0.15)  # the noise is estimated from some 3000 residuals


def test_a_verdict_about_observations_that_changed_says_so(collected):
    session = collected("one", 1)
    session.remove("02")
    assert any("solve again" in reason for reason in evaluate(session.draft).reasons)
    assert evaluate(session.draft).level != "good"


def test_nothing_solved_has_no_verdict(tmp_path, board):
    session = CalibrationSession.create(tmp_path / "s", Setup(KINDS["cameras"], board, CAMERAS))
    with pytest.raises(CalibrationError, match="no solution yet"):
        evaluate(session.draft)


def test_two_calibrations_of_the_same_head_differ_within_their_uncertainties(collected, tmp_path):
    accept(collected("one", 1), tmp_path / "cameras.json")
    comparison = compare(read_result(tmp_path / "cameras.json"), collected("two", 2).draft)
    assert comparison.within, comparison.sentence
    assert 0.5 < comparison.normalised < 1.5  # 39 estimates scatter by 11 % about 1
    inside = [change.within for change in comparison.changes]
    assert np.mean(inside) > 0.8  # 95 % are expected; they are correlated
    assert comparison.on_part_mm > 0


def test_a_knocked_head_differs_by_more_than_the_uncertainties(collected, head, tmp_path):
    accept(collected("one", 1), tmp_path / "cameras.json")
    comparison = compare(read_result(tmp_path / "cameras.json"), collected("two", 2, of=knocked(head)).draft)
    assert not comparison.within
    assert "the cameras were knocked" in comparison.sentence or "more than" in comparison.sentence
    assert comparison.normalised > 10
    assert any(change.name == "right x" and not change.within for change in comparison.changes)
