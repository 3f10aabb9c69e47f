"""`plan make`: a plan from a nominal, its prediction, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli import main
from measureapp.project.geometry.mesh_files import write_stl
from measureapp.project.plan_file import read_plan
from tests.planning.coverage.parts import casting

QUICK = ("--candidates", "200")


def stl(folder: Path, scale: float = 1.0) -> Path:
    part, path = casting(), folder / "casting.stl"
    write_stl(path, part.vertices_mm * scale, part.triangles)
    return path


def answer(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, dict]:
    code = main(["plan", "make", *map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


def test_a_plan_is_written_with_viewpoints_coverage_reasons_time_and_disk(tmp_path, capsys) -> None:
    out = tmp_path / "plan.toml"
    code, document = answer(capsys, stl(tmp_path), "--rig", "paper", "--out", out, "--samples", 300, *QUICK)
    plan = read_plan(out)
    assert code == 0
    assert [one["id"] for one in document["viewpoints"]] == [one.id for one in plan]
    assert plan.name == "plan"
    assert document["coverage"]["predicted_of_measurable"] >= 0.98
    assert document["coverage"]["predicted"] <= document["coverage"]["measurable"] < 1.0
    assert document["coverage"]["unreachable"][0]["reason"] == "touches the support"
    assert document["time_s"] > document["moves_s"] > 0.0
    assert document["bytes"] > 0
    assert document["problems"] == []


def test_the_number_of_viewpoints_can_be_given_and_lines_are_for_people(tmp_path, capsys) -> None:
    out = tmp_path / "two.json"
    assert (
        main(["plan", "make", str(stl(tmp_path)), "--rig", "paper", "--out", str(out), "--viewpoints", "2", "--samples", "200", *QUICK])
        == 0
    )
    words = capsys.readouterr().out
    assert len(read_plan(out)) == 2
    assert "2 viewpoints from" in words
    assert "Not measurable:" in words
    assert f"Plan saved to {out}" in words


@pytest.mark.parametrize(
    ("scale", "arguments", "words"),
    [
        (0.001, (), "probably metres"),
        (4.0, (), "too large for"),
        (0.001, ("--unit", "mm"), "too small to be measured"),
    ],
)
def test_a_nominal_in_another_unit_is_questioned_and_one_that_does_not_fit_refused(tmp_path, capsys, scale, arguments, words) -> None:
    out = tmp_path / "plan.toml"
    code, document = answer(capsys, stl(tmp_path, scale), "--rig", "paper", "--out", out, *arguments)
    assert code == 2
    assert words in document["error"]["message"]
    assert not out.exists()


def test_a_pose_on_the_table_is_read_and_the_unit_given(tmp_path, capsys) -> None:
    pose = tmp_path / "pose.txt"
    np.savetxt(pose, np.array([[1, 0, 0, 30.0], [0, 0, -1, 35.0], [0, 1, 0, 60.0], [0, 0, 0, 1]]))
    out = tmp_path / "plan.toml"
    found = answer(capsys, stl(tmp_path, 0.1), "--unit", "cm", "--pose", pose, "--rig", "paper", "--out", out, "--samples", 200, *QUICK)
    assert found[0] == 0
    assert max(area["place_mm"][0] for area in found[1]["coverage"]["unreachable"]) > -60.0


def test_missing_files_and_other_extensions_are_refused(tmp_path, capsys) -> None:
    out = tmp_path / "plan.toml"
    assert answer(capsys, tmp_path / "none.stl", "--rig", "paper", "--out", out)[0] == 2
    code, document = answer(capsys, stl(tmp_path), "--rig", "paper", "--out", tmp_path / "plan.xml", "--samples", 100)
    assert code == 2
    assert "plan.xml" in document["error"]["message"]


def test_a_part_on_its_head_is_planned_as_such_and_the_plan_says_so(tmp_path, capsys) -> None:
    out = tmp_path / "head.json"
    code, document = answer(capsys, stl(tmp_path), "--rig", "paper", "--out", out, "--upside-down", "--samples", 200, *QUICK)
    assert code == 0 and document["part_pose"]["rotation_deg"] == [180.0, 0.0, 0.0]
    pose = read_plan(out).part_pose
    assert pose is not None and "turned by 180/0/0°" in pose.words
    assert document["median_sigma_mm"] < 0.02 and "guide and table" in document["note"]
    lost = next(one for one in document["coverage"]["unreachable"] if one["reason"] == "touches the support")
    assert lost["fraction"] < 0.2  # the rim of its top, not its whole bottom


def test_two_statements_of_a_pose_are_refused(tmp_path, capsys) -> None:
    arguments = ["plan", "make", str(stl(tmp_path)), "--rig", "paper", "--out", str(tmp_path / "a.json"), "--upside-down", "--turn-deg"]
    assert main([*arguments, "90", "0", "0", "--json"]) == 2
    assert "Only one of" in json.loads(capsys.readouterr().out)["error"]["message"]
