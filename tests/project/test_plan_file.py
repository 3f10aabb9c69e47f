"""Files of scan plans."""

from __future__ import annotations

import json
import tomllib

import pytest

from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.data.plan import ExposureBracket, FlangePose, ScanPlan, StationPose, Viewpoint, ViewpointGroup
from measureapp.errors import InputError
from measureapp.project.plan_file import read_plan, write_plan

POSE = FlangePose(position_mm=(500.1, -1e-7, 600.0), quaternion_wxyz=(0.0, 1.0, 0.0, 0.0))
PLAN = ScanPlan(
    name='an "odd" name, ü',
    viewpoints=(Viewpoint(id="top", flange=POSE, guide_mm=0.0, table_deg=-12.5, settle_s=2.0),),
    groups=(ViewpointGroup(id="ring", poses=(StationPose(flange=POSE, guide_mm=30.0),), table_deg=(0.0, 90.0), exposures_us=(40_000,)),),
    patterns=PATTERN_SETS["paper"],
    bracket=ExposureBracket(exposures_us=(80_000, 10_000)),
    settle_s=0.5,
)


@pytest.mark.parametrize("name", ["plan.toml", "plan.json", "PLAN.TOML"])
def test_a_plan_survives_its_file_with_groups(tmp_path, name):
    write_plan(tmp_path / name, PLAN)
    assert read_plan(tmp_path / name) == PLAN


def test_a_plan_as_toml_names_a_predefined_pattern_set_and_states_no_defaults(tmp_path):
    write_plan(tmp_path / "plan.toml", PLAN.model_copy(update={"settle_s": None}))
    text = (tmp_path / "plan.toml").read_text(encoding="utf-8")
    document = tomllib.loads(text)
    assert document["patterns"] == "paper" and "settle_s" not in document and "none" not in text
    assert "position_mm = [500.1, -1e-07, 600.0]" in text


def test_other_patterns_survive_as_well(tmp_path):
    changed = PLAN.model_copy(update={"patterns": PATTERN_SETS["gray"].model_copy(update={"name": "own"})})
    write_plan(tmp_path / "plan.toml", changed)
    assert read_plan(tmp_path / "plan.toml") == changed


def test_a_file_of_another_kind_is_not_written(tmp_path):
    with pytest.raises(InputError, match=r"\.toml or \.json"):
        write_plan(tmp_path / "plan.txt", PLAN)
    assert not list(tmp_path.iterdir())


def broken(change) -> dict:
    document = json.loads(PLAN.model_dump_json(exclude_none=True))
    change(document)
    return document


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda d: d["viewpoints"][0]["flange"].update(quaternion_wxyz=[1, 1, 0, 0]), r"viewpoint 'top' \(no. 1\), flange.quaternion_wxyz"),
        (lambda d: d["viewpoints"].append(d["viewpoints"][0]), "two viewpoints have the same id 'top'"),
        (lambda d: d.update(patterns="stripes"), "no pattern set 'stripes'"),
        (lambda d: d["groups"][0].update(exposures_us=[1, 2]), r"group 'ring' \(no. 1\), exposures_us: .*long to short"),
        (lambda d: d["groups"][0].update(colour="red"), r"group 'ring' \(no. 1\), colour: is not a known field"),
        (lambda d: d["viewpoints"][0].update(id="<b>top</b>"), r"'<b>top</b>' \(no. 1\), id: a name begins"),
        (lambda d: d["viewpoints"].insert(0, 3), "viewpoint no. 1"),
        (lambda d: d["viewpoints"][0].pop("guide_mm"), "guide_mm: Field required"),
        (lambda d: d["viewpoints"][0].update(guide_mm="x", table_deg="y"), "and 1 more"),
        (lambda d: d.update(schema_version=9), "plan of version 9"),
        (lambda d: d.update(viewpoints=[], groups=[]), "no viewpoints"),
    ],
)
def test_what_is_wrong_is_named_with_its_viewpoint(tmp_path, change, told):
    (tmp_path / "plan.json").write_text(json.dumps(broken(change)))
    with pytest.raises(InputError, match=told):
        read_plan(tmp_path / "plan.json")


@pytest.mark.parametrize("text", ["", "[]", "3", "null", "\x00", '{"name": 3}', "[" * 5000])
def test_rubbish_is_no_plan(tmp_path, text):
    for name in ("plan.json", "plan.toml"):
        (tmp_path / name).write_text(text)
        with pytest.raises(InputError):
            read_plan(tmp_path / name)
