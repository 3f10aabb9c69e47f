"""`plan extend` prints coverage, holes and proposals, and stores the extended plan only where it is asked to."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from measureapp.cli import main
from measureapp.data.plan import ScanPlan
from measureapp.pipeline.closed_loop.causes import Cause, Hole
from measureapp.pipeline.closed_loop.next_views import Proposal, extended
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig

PLAN = plan_around_part(read_rig("paper"), "two", radius_mm=60.0, height_mm=60.0, count=2)


def found(plan: ScanPlan, proposals: tuple[Proposal, ...]) -> Any:
    """A scan that measured half of the surface."""
    return SimpleNamespace(
        measured=0.5,
        sufficient=0.5,
        accessible=0.8,
        expected=0.5 + sum(one.share for one in proposals),
        median_sigma_mm=0.012,
        shares=lambda: {str(Cause.UNSEEN): 0.3, str(Cause.SUPPORT): 0.2},
        holes=lambda: (Hole(Cause.UNSEEN, 812.0, 0.3, (1.0, 2.0, 3.0)),),
        proposals=proposals,
        plan=extended(plan, proposals),
    )


@pytest.fixture
def project(tmp_path: Path) -> ProjectFolder:
    made = ProjectFolder.create(tmp_path / "p", ProjectSettings(name="two", part="box", rig=read_rig("paper")))
    made.save_plan(PLAN)
    return made


@pytest.fixture
def proposal(monkeypatch: pytest.MonkeyPatch) -> Proposal:
    viewpoint = PLAN[0].model_copy(update={"id": "next01", "table_deg": 45.0})
    one = Proposal(viewpoint, "viewpoint", 0.25, 677.0, 9.5, "for 812 mm²: no viewpoint sees it")
    monkeypatch.setattr("measureapp.pipeline.closed_loop.of_project.find_next_views", lambda *_, **__: found(PLAN, (one,)))
    return one


def test_proposals_are_printed_with_their_gain_and_reason_and_nothing_is_stored(project, proposal, capsys) -> None:
    assert main(["plan", "extend", str(project.path), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["coverage"] == {"measured": 0.5, "sufficient": 0.5, "accessible": 0.8, "expected": 0.75, "median_sigma_mm": 0.012}
    assert answer["holes"][0]["cause"] == "no viewpoint sees it"
    assert answer["proposals"][0]["viewpoint"]["id"] == "next01"
    assert (answer["proposals"][0]["gain"], answer["proposals"][0]["seconds"]) == (0.25, 9.5)
    assert answer["written"] is False
    assert project.plan() == PLAN


def test_the_extended_plan_is_stored_on_request_and_the_scan_that_takes_it_is_named(project, proposal, capsys) -> None:
    assert main(["plan", "extend", str(project.path), "--write"]) == 0
    said = capsys.readouterr().out
    assert "next01: + 25.0% in 10 s" in said or "next01: + 25.0% in 9 s" in said
    assert f"--project {project.path} --resume" in said
    stored = project.plan()
    assert stored is not None and [one.id for one in stored] == [*(one.id for one in PLAN), "next01"]


def test_a_complete_scan_is_said_to_need_nothing(project, monkeypatch, capsys) -> None:
    monkeypatch.setattr("measureapp.pipeline.closed_loop.of_project.find_next_views", lambda *_, **__: found(PLAN, ()))
    assert main(["plan", "extend", str(project.path), "--write"]) == 0
    assert "No viewpoint or exposure within reach is expected to measure more." in capsys.readouterr().out
    assert project.plan() == PLAN


def test_a_project_without_results_is_refused_in_words(project, capsys) -> None:
    assert main(["plan", "extend", str(project.path)]) == 2
    assert "has no results" in capsys.readouterr().err
