"""Scan plans: groups by repetition, exposures and settling of single viewpoints, older versions."""

from __future__ import annotations

import json

import pytest
from pydantic import ValidationError

from measureapp.data.plan import ExposureBracket, FlangePose, ScanPlan, StationPose, Viewpoint, ViewpointGroup
from measureapp.errors import InputError
from measureapp.project.plan_file import read_plan

POSE = FlangePose(position_mm=(500.0, 0.0, 600.0), quaternion_wxyz=(0.0, 1.0, 0.0, 0.0))
SINGLE = Viewpoint(id="top", flange=POSE, guide_mm=0.0, table_deg=0.0)
RING = ViewpointGroup(id="ring", poses=(StationPose(flange=POSE),), table_deg=(0.0, 120.0, 240.0))
STATIONS = ViewpointGroup(
    id="walls", poses=(StationPose(flange=POSE), StationPose(flange=POSE, guide_mm=300.0)), table_deg=(0.0, 90.0), exposures_us=(40_000,)
)


def test_a_group_repeats_every_pose_at_every_table_angle() -> None:
    plan = ScanPlan(name="impeller", viewpoints=(SINGLE,), groups=(RING, STATIONS))
    assert [viewpoint.id for viewpoint in plan] == [
        *("top", "ring-01", "ring-02", "ring-03"),
        *("walls-01-01", "walls-01-02", "walls-02-01", "walls-02-02"),
    ]
    assert len(plan) == 8
    assert [viewpoint.table_deg for viewpoint in plan][4:] == [0.0, 90.0, 0.0, 90.0]
    assert [viewpoint.guide_mm for viewpoint in plan][4:] == [0.0, 0.0, 300.0, 300.0]
    assert plan[2] == tuple(plan)[2]
    assert list(plan) == list(plan)


def test_a_viewpoint_has_its_own_exposures_and_settling_or_those_of_the_plan() -> None:
    shiny = SINGLE.model_copy(update={"id": "shiny", "exposures_us": (20_000, 5_000), "settle_s": 0.0})
    plan = ScanPlan(name="p", viewpoints=(SINGLE, shiny), groups=(STATIONS,), bracket=ExposureBracket(exposures_us=(80_000,)), settle_s=1.5)
    assert [plan.exposures_of(viewpoint) for viewpoint in plan][:3] == [(80_000,), (20_000, 5_000), (40_000,)]
    assert [plan.settle_of(viewpoint) for viewpoint in plan][:3] == [1.5, 0.0, 1.5]
    assert ScanPlan(name="p", viewpoints=(SINGLE,)).settle_of(SINGLE) is None


def test_what_a_plan_iterates_into_survives_a_file(tmp_path) -> None:
    plan = ScanPlan(name="p", viewpoints=(SINGLE,), groups=(RING, STATIONS))
    (tmp_path / "plan.json").write_text(plan.model_dump_json())
    assert read_plan(tmp_path / "plan.json") == plan


def test_a_plan_of_version_1_is_read_as_it_was_meant(tmp_path) -> None:
    old = {"schema_version": 1, "name": "old", "viewpoints": [json.loads(SINGLE.model_dump_json(exclude_none=True))]}
    (tmp_path / "old.json").write_text(json.dumps(old))
    assert read_plan(tmp_path / "old.json") == ScanPlan(name="old", viewpoints=(SINGLE,))


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"viewpoints": (), "groups": ()}, "no viewpoints"),
        ({"viewpoints": (SINGLE, SINGLE)}, "same id 'top'"),
        ({"viewpoints": (SINGLE.model_copy(update={"id": "ring-02"}),)}, "same id 'ring-02'"),
        ({"settle_s": -1.0}, "settle_s"),
        ({"schema_version": 4}, "schema_version"),
        ({"groups": ({**RING.model_dump(), "exposures_us": (10, 20)},)}, "long to short"),
        ({"groups": ({**RING.model_dump(), "table_deg": ()},)}, "table_deg"),
    ],
)
def test_what_makes_no_plan_is_refused(changes, told) -> None:
    with pytest.raises(ValidationError, match=told):
        ScanPlan.model_validate({"name": "p", "viewpoints": (SINGLE,), "groups": (RING,), **changes})


def test_an_unknown_field_of_a_plan_file_is_named(tmp_path) -> None:
    (tmp_path / "plan.toml").write_text('name = "p"\ncolour = "red"\n')
    with pytest.raises(InputError, match="colour: is not a known field"):
        read_plan(tmp_path / "plan.toml")
