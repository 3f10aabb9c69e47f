"""From where the rig should look next: reachable, in sight, new, and only where it teaches something."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.draft.draft import Setup
from measureapp.calibrate.guidance.next_view import gain_of
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibration_session.session import CalibrationSession
from measureapp.calibration_session.suggestion import LEAST_GAIN, NEAR_MM, NEAR_RAD, suggest_viewpoint
from measureapp.planning.reach import limit_violations
from tests.calibrate.paper_rig import BOARD, RIG, Cell, corners_of, planned
from tests.calibration_session.shown_board import Shown

CAMERAS = ("left", "right", "upper")
SIZE = (2592, 1944)
SIGMA_PX = 0.1
VIEWS = 8


@pytest.fixture
def collected(tmp_path, monkeypatch):
    """Return a session of the first planned poses, with or without their read-backs."""

    def made(readbacks=True):
        cell, generator, shown = Cell.of(1), np.random.default_rng(5), Shown(monkeypatch, SIGMA_PX)
        session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["cameras"], BOARD, CAMERAS))
        for _, readback, pose in cell.placed(planned(stations=False)[:VIEWS]):
            corners = corners_of(cell.truth.calibration.cameras, pose, SIGMA_PX, generator)
            shown.add(session, corners, readback if readbacks else None, SIZE)
        return session, cell

    return made


def seen_from(viewpoint, cell):
    ((_, _, pose),) = cell.placed((viewpoint,))
    return pose


def test_nothing_is_suggested_before_there_is_a_solution(collected):
    session, _ = collected()
    assert suggest_viewpoint(session.draft, RIG, "more01") is None


def test_nothing_is_suggested_where_it_is_not_known_where_the_robot_stood(collected):
    session, _ = collected(readbacks=False)
    session.solve()
    assert suggest_viewpoint(session.draft, RIG, "more01") is None


def test_the_suggested_viewpoint_can_be_reached_is_new_and_gains_what_was_predicted(collected):
    session, cell = collected()
    solution = session.solve().camera_solution
    found = suggest_viewpoint(session.draft, RIG, "more01")
    assert found.viewpoint.id == "more01"
    assert limit_violations(found.viewpoint, RIG) == ()
    place = seen_from(found.viewpoint, cell)  # with the true rig, which is not the drawn one
    assert gain_of(solution, place, solution.calibration.names) > LEAST_GAIN
    aparts = [place.inverse() @ known for known in solution.boards.values()]
    assert all(np.linalg.norm(apart.translation_mm) > NEAR_MM / 2 or apart.angle_rad > NEAR_RAD / 2 for apart in aparts)
    assert corners_of(cell.truth.calibration.cameras, place, 0.0, np.random.default_rng(0)), "no camera sees the board whole from there"
