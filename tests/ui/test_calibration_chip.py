"""The header's chip says the gravest thing about the calibration."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime, timedelta

import pytest

from measureapp.data.validity import Drift, Validity
from measureapp.pipeline.events import ValidityKnown
from ui.controllers.run_events import RunEvents
from ui.pages.calibration_chip import calibration_state
from ui.pages.calibration_rows import added_to_length_mm, contributions
from ui.session import Session

MOVED = Drift(
    "drifted", "Camera left has turned by 0.030° since the calibration: calibrate the cameras again.", ("left",), 0.5, 0.04, 0.38, 0.03
)


def made(calibration) -> datetime:
    return datetime.fromisoformat(calibration.provenance.created)


def test_a_good_calibration_shows_age_and_millimetres(calibration, rig):
    good = Validity(drift=Drift("good", "The cameras stand as they were calibrated."))
    state = calibration_state(calibration, rig, good, made(calibration) + timedelta(days=2))
    shares = dict(contributions(calibration, rig))
    added = added_to_length_mm(calibration, rig)
    assert shares["Together"] < added < 2 * shares["Together"] and added != calibration.hand_eye.residual_mm
    assert (state.words, state.colour) == (f"Calibrated 2 days ago · adds {added:.3f}\u00a0mm (k = 2) ✓", "verdict_pass")
    assert "stand as they were calibrated" in state.tip


def test_a_joint_solution_states_what_it_adds_itself(calibration, rig):
    joint = replace(calibration, view_gaps_mm=0.06)
    assert "adds 0.060" in calibration_state(joint, rig, None, made(calibration)).words


def test_a_poor_fit_is_said_without_a_number_that_looks_good(calibration, rig):
    poor = replace(calibration, hand_eye=replace(calibration.hand_eye, residual_mm=9.0))
    state = calibration_state(poor, rig, None, made(calibration))
    assert (state.words, state.colour) == ("Calibrated just now · poor fit ✗", "verdict_fail")
    assert state.tip.startswith("Hand–eye: 9.000\u00a0mm. Residual up to")


def test_a_camera_that_moved_comes_first_with_its_millimetres(calibration, rig):
    state = calibration_state(calibration, rig, Validity(("It was warm.",), MOVED), made(calibration))
    assert (state.words, state.colour) == ("Camera left moved · 0.380\u00a0mm ✗", "verdict_fail")
    assert MOVED.sentence in state.tip and "It was warm." in state.tip


def test_an_expired_calibration_asks_to_be_checked(calibration, rig):
    later = made(calibration) + timedelta(days=(rig.calibration_rules.valid_days or 0) + 1)
    state = calibration_state(calibration, rig, None, later)
    assert "check it" in state.words and "has expired" in state.tip and state.colour == "verdict_not_proven"


@pytest.mark.usefixtures("qapp")
def test_the_session_hears_warnings_before_a_scan_and_a_moved_camera_after_it():
    session = Session()
    events = RunEvents(session)
    events.apply(ValidityKnown(Validity(("It was warm.",))))
    events.apply(ValidityKnown(Validity(("It was warm.",), MOVED)))
    assert [(message.text, message.level) for message in session.messages] == [("It was warm.", "warning"), (MOVED.sentence, "error")]
    assert session.validity is not None and session.validity.drift == MOVED
