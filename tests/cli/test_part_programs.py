"""`program pack`, `program show`, `program unpack`, and a scan by a part program."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from measureapp.cli import main
from measureapp.data.plan import ExposureBracket
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.folder import ProjectFolder
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource
from tests.cli.rig_files import write_binned_rig


def answer(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, dict]:
    code = main([*map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


@pytest.fixture
def program(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    """A part program with one viewpoint at one exposure."""
    plan = plan_around_part(read_rig("paper"), "cross", radius_mm=100, height_mm=80, count=1)
    (tmp_path / "plan.json").write_text(plan.model_copy(update={"bracket": ExposureBracket(exposures_us=(40_000,))}).model_dump_json())
    parts = ("--inspection", resource("parts/gypsum/program.toml"), "--part-number", "G-17", "--remarks", "Flat side down.")
    code, document = answer(capsys, "program", "pack", tmp_path / "plan.json", "--out", tmp_path / "cross.mpart", *parts)
    assert (code, document["name"], document["viewpoints"], document["nominal"]) == (0, "cross", 1, "nominal.stl")
    return tmp_path / "cross.mpart"


def test_a_part_program_tells_what_it_contains_and_gives_it_back(program: Path, tmp_path: Path, capsys) -> None:
    assert main(["program", "show", str(program)]) == 0
    said = capsys.readouterr().out
    assert "cross (G-17): 1 viewpoints, inspection program, nominal." in said
    assert "Not included: report template, picture." in said
    assert "Flat side down." in said
    code, document = answer(capsys, "program", "unpack", program, "--out", tmp_path / "edit")
    assert code == 0
    assert sorted(Path(path).name for path in document["files"].values()) == ["nominal.stl", "plan.json", "program.toml"]


def test_a_scan_by_a_part_program_stores_all_of_it_in_the_project(program: Path, tmp_path: Path, capsys) -> None:
    rig = write_binned_rig(tmp_path / "quarter.toml", 'part = "gypsum", seed = 1')
    code, document = answer(capsys, "scan", program, "--rig", rig, "--project", tmp_path / "project")
    assert (code, document["ended"]) == (0, "done")
    project = ProjectFolder.open(tmp_path / "project")
    assert project.settings.part == "cross"
    assert len(project.stored_viewpoints()) == 1
    assert project.program is not None
    assert project.nominal is not None
