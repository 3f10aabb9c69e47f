"""A project written by the version before this one opens: settings, calibration with its uncertainty, measurement, session and result."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from measureapp.calibrate.draft.verdict import evaluate
from measureapp.calibration_session.accepting import read_result
from measureapp.calibration_session.session import CalibrationSession
from measureapp.cli import main
from measureapp.project.folder import ProjectFolder

ARCHIVE = Path(__file__).parents[1] / "data" / "project_of_version_before.zip"
MEASURED_MM = (180.0041, 140.0047, 60.0053, 39.9998)  # a, b, c, d of its gypsum cross, as that version stated them


@pytest.fixture(scope="module")
def older(tmp_path_factory):
    folder = tmp_path_factory.mktemp("older") / "project"
    shutil.unpack_archive(ARCHIVE, folder)
    return folder


def test_its_calibration_and_measurement_are_read_as_they_were_written(older):
    project = ProjectFolder.open(older)
    calibration = project.require_calibration()
    assert calibration.cameras.names == ("left", "right", "upper")
    assert calibration.cameras.cameras["left"].pinhole.matrix[0, 0] == pytest.approx(1023.8271732840454, abs=1e-9)
    assert calibration.stations
    assert project.rig_uncertainty() is not None
    assert project.plan() is not None
    assert [line.kind for line in project.calibration_history()] == ["scan"]
    measurement = project.measurement()
    assert [one.measured for one in measurement.inspection.dimensions] == pytest.approx(MEASURED_MM, abs=5e-5)
    assert len(measurement.views) == 3 and len(measurement.stitched) > 100
    assert len(measurement.stitched.placements) == 8
    assert measurement.stitched.errors is not None


def test_its_calibration_session_is_continued_and_its_result_is_read(older):
    folder = older / "calibration" / "sessions" / "axis-001"
    session = CalibrationSession.open(folder)
    assert session.setup.kind.name == "axis"
    assert [one.status for one in session.observations] == ["new", "removed", "new", "new", "new"]
    assert session.setup.noise.robot_mm > 0 and session.setup.hand_eye is not None
    solved = session.solve()
    assert evaluate(session.draft).level in ("good", "usable")
    kept = read_result(folder / "result" / "axis.json")
    # The same axis; its standard deviations are larger now by the uncertainty of the cameras (decision 19).
    np.testing.assert_allclose(solved.solution.best.axis.direction, kept.direction, atol=1e-12)
    np.testing.assert_allclose(solved.solution.best.axis.point_mm, kept.point_mm, atol=1e-8)
    assert kept.direction_sigma_rad < solved.solution.best.axis.direction_sigma_rad < 10 * kept.direction_sigma_rad
    session.undo()
    assert session.observation("02").status == "new"


def test_commands_work_on_it(older, capsys):
    assert main(["report", str(older), "--csv", "--json"]) in (0, 1)
    assert main(["calibrate", "history", str(older), "--json"]) == 0
    assert capsys.readouterr().out
