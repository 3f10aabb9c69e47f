"""`plan check`, `plan show` and `plan edit`."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from measureapp.cli import main
from measureapp.project.plan_file import read_plan
from measureapp.resources import resource
from tests.cli.refusal import refused

SAMPLE = resource("plans/paper_impeller.toml")
IMPELLER = resource("parts/impeller/nominal.stl")


def answered(capsys: pytest.CaptureFixture[str], *arguments: object, code: int = 0) -> dict:
    capsys.readouterr()
    assert main([*map(str, arguments), "--json"]) == code
    return json.loads(capsys.readouterr().out)


def edited(capsys: pytest.CaptureFixture[str], tmp_path: Path, *options: object):
    answered(capsys, "plan", "edit", SAMPLE, "--out", tmp_path / "new.toml", *options)
    return read_plan(tmp_path / "new.toml")


def test_a_good_plan_is_checked_with_its_coverage_time_and_size(capsys):
    found = answered(capsys, "plan", "check", SAMPLE, "--rig", "paper", "--nominal", IMPELLER)
    assert found["problems"] == [] and len(found["viewpoints"]) == 36
    assert 0.6 < found["coverage"]["predicted"] < 0.8
    lost = sum(entry["share"] for entry in found["coverage"]["unreachable"])
    assert lost == pytest.approx(1.0 - found["coverage"]["predicted"])
    assert found["time_s"] == found["images_s"] + found["moves_s"]
    assert found["bytes"] == 36 * 60 * 3 * 2592 * 1944
    assert all(0.0 < viewpoint["sees"] < 0.7 for viewpoint in found["viewpoints"])


def test_a_plan_with_problems_names_them_and_ends_with_1(capsys, tmp_path):
    options = ("--rig", "paper", "--guide", "700", "--add", "far=0,0,40:0,40", "--out", tmp_path / "bad.json")
    assert main(["plan", "edit", str(SAMPLE), *map(str, options)]) == 0
    found = answered(capsys, "plan", "check", tmp_path / "bad.json", "--rig", "paper", code=1)
    assert {problem["viewpoint"] for problem in found["problems"]} == {"far"}
    assert found["problems"][0]["kind"] == "limits" and found["viewpoints"][0]["problems"]
    assert found["coverage"] is None
    assert main(["plan", "check", str(tmp_path / "bad.json"), "--rig", "paper"]) == 1
    assert "✗ far: Guide at 700.0 mm" in capsys.readouterr().out


def test_a_plan_is_shown_as_a_table_and_as_a_picture(capsys, tmp_path):
    for name in ("plan.png", "plan.svg"):
        found = answered(capsys, "plan", "show", SAMPLE, "--rig", "paper", "--nominal", IMPELLER, "--out", tmp_path / name)
        assert found["files"]["picture"] == str(tmp_path / name)
    assert [group["name"] for group in found["groups"]] == ["rim", "blades", "hub"]
    assert found["viewpoints"][0]["elevation_deg"] == pytest.approx(52.0, abs=0.01)
    picture = np.asarray(Image.open(tmp_path / "plan.png").convert("RGB"))
    assert picture.shape[1] > 1000 and len(np.unique(picture.reshape(-1, 3), axis=0)) > 50
    drawing = (tmp_path / "plan.svg").read_text(encoding="utf-8")
    assert all(f">{number}</text>" in drawing for number in (1, 18, 36))
    assert main(["plan", "show", str(SAMPLE), "--rig", "paper"]) == 0
    assert "Group rim: 2 poses at 10 table angles." in capsys.readouterr().out


def test_edits_are_made_in_their_order(capsys, tmp_path):
    plan = edited(
        capsys,
        tmp_path,
        *("--rig", "paper", "--add", "top=0,0,40:0,60", "--add", "side=0,0,40:10,30,600,90", "--table", "30"),
        *("--remove", "hub", "--move", "side:-1", "--ungroup", "blades", "--repeat", "ring=top:0,90,180,270"),
        *("--exposures", "ring=50,10", "--exposures", "plan=80,20", "--settle", "ring=1.5", "--settle", "plan=0.5"),
    )
    assert [viewpoint.id for viewpoint in plan.viewpoints][:2] == ["side", "blades-01"]
    assert [group.id for group in plan.groups] == ["rim", "ring"]
    ring = plan.groups[1]
    assert (ring.table_deg, ring.exposures_us, ring.settle_s) == ((0.0, 90.0, 180.0, 270.0), (50_000, 10_000), 1.5)
    assert (plan.bracket.exposures_us, plan.settle_s) == ((80_000, 20_000), 0.5)


def test_the_added_viewpoint_looks_where_it_was_told_to(capsys, tmp_path):
    plan = edited(capsys, tmp_path, "--rig", "paper", "--add", "side=5,10,40:10,30,600,90", "--guide", "20")
    assert plan.viewpoints[0].guide_mm == 20.0
    shown = answered(capsys, "plan", "show", tmp_path / "new.toml", "--rig", "paper")["viewpoints"][0]
    assert (shown["azimuth_deg"], shown["elevation_deg"]) == (pytest.approx(10.0), pytest.approx(30.0))


def test_all_viewpoints_can_be_given_an_order_and_default_exposures(capsys, tmp_path):
    names = [viewpoint.id for viewpoint in read_plan(SAMPLE)][::-1]
    plan = edited(capsys, tmp_path, "--order", ",".join(names), "--exposures", "rim=20", "--exposures", "rim=default")
    assert [viewpoint.id for viewpoint in plan] == names and not plan.groups
    assert all(viewpoint.exposures_us is None for viewpoint in plan)


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--add", "a=0,0,40:0,60"], "--add needs --rig"),
        (["--add", "a", "--rig", "paper"], "--add a cannot be read"),
        (["--add", "a=0,0:0,60", "--rig", "paper"], "has 2 numbers"),
        (["--add", "a=0,0,nan:0,60", "--rig", "paper"], "nan is not a finite number"),
        (["--add", "a=0,0,1:0,95", "--rig", "paper"], "elevation of 95"),
        (["--add", "<b>=0,0,1:0,60", "--rig", "paper"], "cannot be a name"),
        (["--remove", "nobody"], "no viewpoint or group 'nobody'"),
        (["--move", "hub:up"], "'up' is not a number"),
        (["--repeat", "ring=rim-01-01:0"], "Only single viewpoints"),
        (["--exposures", "hub=10,20"], "long to short"),
        (["--settle", "plan=-1"], "settle_s"),
        (["--order", "hub-01"], "is missing"),
    ],
)
def test_edits_that_cannot_be_made_are_refused_and_write_nothing(capsys, tmp_path, options, told):
    assert told in refused(capsys, ["plan", "edit", str(SAMPLE), "--out", str(tmp_path / "new.toml"), *options])
    assert not list(tmp_path.iterdir())


def test_a_picture_or_plan_of_another_kind_is_refused(capsys, tmp_path):
    assert ".png or .svg" in refused(capsys, ["plan", "show", str(SAMPLE), "--rig", "paper", "--out", str(tmp_path / "a.jpg")])
    assert ".toml or .json" in refused(capsys, ["plan", "edit", str(SAMPLE), "--out", str(tmp_path / "a.txt")])


def test_a_plan_of_a_newer_version_is_refused(capsys, tmp_path):
    (tmp_path / "new.toml").write_text(SAMPLE.read_text(encoding="utf-8").replace("schema_version = 2", "schema_version = 4"), "utf-8")
    assert "version 4" in refused(capsys, ["plan", "check", str(tmp_path / "new.toml"), "--rig", "paper"])
