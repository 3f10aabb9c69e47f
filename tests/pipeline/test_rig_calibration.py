"""All calibrations of a connected rig in one run: what it takes, what it keeps, and what it says where the board is not seen."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from measureapp.data.board import CheckerboardDescription
from measureapp.data.plan import Viewpoint
from measureapp.devices.connect import connect_rig
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError, InputError
from measureapp.pipeline import rig_calibration
from measureapp.pipeline.rig_calibration import CalibrationRequest, calibrate_into_project
from measureapp.planning.calibration_views import calibration_viewpoints
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig


@pytest.fixture
def rig() -> Rig:
    return connect_rig(read_rig("paper").at_resolution("quarter").model_copy(update={"driver_settings": {"part": "flat"}}))


@pytest.fixture
def few(rig: Rig, monkeypatch: pytest.MonkeyPatch) -> list[Viewpoint]:
    """The first viewpoints alone, and a solver that solves nothing; the list can be made longer."""
    viewpoints = list(calibration_viewpoints(rig.description, motions=("robot",), arm=arm_of(rig.description))[:2])
    monkeypatch.setattr(rig_calibration, "calibration_viewpoints", lambda *_, **__: tuple(viewpoints))
    monkeypatch.setattr(rig_calibration, "solve_calibration", lambda *_: SimpleNamespace(solution=None, refused=()))
    return viewpoints


def run(rig: Rig, folder: Path, **kinds: Any) -> tuple[Any, ProjectFolder]:
    return calibrate_into_project(CalibrationRequest(rig.description, folder, **kinds), lambda _: None, NoProgress(), held=rig)


def test_views_are_stored_and_only_missing_ones_are_taken_afterwards(rig: Rig, few: list[Viewpoint], tmp_path: Path) -> None:
    further = calibration_viewpoints(rig.description, motions=("robot",), arm=arm_of(rig.description))[2]
    first, project = run(rig, tmp_path / "p")
    assert first.taken == tuple(viewpoint.id for viewpoint in few) and first.kept == ()
    few.append(further)
    second, _ = run(rig, tmp_path / "p")
    assert (second.taken, second.kept) == ((further.id,), first.taken)
    assert len(project.board_views()) == 3


def test_a_board_that_is_nowhere_ends_the_run_with_the_viewpoints_and_what_to_do(rig: Rig, few: list[Viewpoint], tmp_path: Path) -> None:
    few[:] = calibration_viewpoints(rig.description, motions=("robot",), arm=arm_of(rig.description))[:6]
    without = replace(rig, place_on_table=lambda _: None)  # as where a person forgot it
    with pytest.raises(CalibrationError, match=r"No camera detects the board of 14 × 11 corners from pose01, pose02, pose03") as refused:
        run(without, tmp_path / "p")
    assert "on its stand" in refused.value.hint
    assert ProjectFolder.open(tmp_path / "p").board_views() == ()
    assert not rig.latch.reason  # nothing is wrong with the rig
    run(rig, tmp_path / "p")
    assert len(ProjectFolder.open(tmp_path / "p").board_views()) == 6


def test_a_project_of_another_rig_or_board_is_refused_before_anything_moves(rig: Rig, few: list[Viewpoint], tmp_path: Path) -> None:
    run(rig, tmp_path / "p")
    other = rig.description.model_copy(update={"name": "Other rig"})
    with pytest.raises(InputError, match="described differently than Other rig"):
        calibrate_into_project(CalibrationRequest(other, tmp_path / "p"), lambda _: None, NoProgress())
    board = CheckerboardDescription(columns=9, rows=6, square_mm=25.0)
    with pytest.raises(InputError, match="another board"):
        run(rig, tmp_path / "p", board=board)


def test_another_rig_than_the_connected_one_is_refused(rig: Rig, tmp_path: Path) -> None:
    other = rig.description.model_copy(update={"standoff_mm": 600.0})
    with pytest.raises(InputError, match="described differently") as refused:
        calibrate_into_project(CalibrationRequest(other, tmp_path / "p"), lambda _: None, NoProgress(), held=rig)
    assert "Disconnect" in refused.value.hint
    assert not (tmp_path / "p").exists()


@pytest.mark.slow
def test_the_virtual_rig_calibrates_itself_completely_and_says_how_well(rig: Rig, tmp_path: Path) -> None:
    found, project = run(rig, tmp_path / "p")
    assert found.failed == () and not found.unseen and len(found.taken) > 50
    assert found.solved.verdict.level == "good"
    truth, calibration = rig.truth(), project.require_calibration()
    assert truth is not None
    off = calibration.hand_eye.flange_from_camera.inverse() @ truth.hand_eye.flange_from_camera
    assert abs(off.translation_mm).max() < 1.0 and off.angle_rad < 0.002
