"""A session measures only what changed, and its results are those of measuring everything afresh."""

from __future__ import annotations

import dataclasses
import re
import time

import numpy as np
import pytest
from inspection.session.machined import machined_part, program_of

from measureapp.data.dimension import Verdict
from measureapp.errors import InspectionError
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.programming.edits import change, rename, set_alignment, set_tolerance
from measureapp.inspection.session.graph import Graph, Node
from measureapp.inspection.session.session import InspectionSession
from measureapp.progress import Cancelled, NoProgress


def names(result):
    return {(node.kind, node.name) for node in result.measured}


def assert_same(one, other):
    assert len(one.dimensions) == len(other.dimensions)
    for a, b in zip(one.dimensions, other.dimensions, strict=True):
        assert dataclasses.asdict(a) == dataclasses.asdict(b)
    for a, b in zip(one.features, other.features, strict=True):
        assert a.name == b.name and np.array_equal(a.point_mm, b.point_mm) and a.radius_mm == b.radius_mm
    assert np.array_equal(one.alignment.nominal_from_part.matrix, other.alignment.nominal_from_part.matrix)


@pytest.fixture(scope="module")
def points():
    return machined_part()


@pytest.fixture
def session(points):
    return InspectionSession(points)


def test_a_changed_tolerance_or_name_measures_nothing_again(session):
    first = session.measure(program_of())
    assert ("dimension", "height") in names(first) and ("feature", "top") in names(first)
    edited = program_of(height={"name": "overall height", "upper_tolerance": 0.0004, "lower_tolerance": -0.0004})
    again = session.measure(edited)
    assert again.measured == frozenset()
    assert again.inspection.dimensions[0].name == "overall height"
    assert again.inspection.dimensions[0].measured == first.inspection.dimensions[0].measured


def test_a_changed_feature_measures_itself_and_what_depends_on_it(session):
    session.measure(program_of())
    again = session.measure(program_of(top={"cut": {"edge_mm": 2.0, "band_mm": 1.0}}))
    assert names(again) == {
        ("feature", "top"),
        ("feature", "mid"),
        ("dimension", "height"),
        ("dimension", "mid to base"),
    }


def test_a_changed_alignment_measures_everything(session):
    first = session.measure(program_of())
    again = session.measure(program_of(alignment="datums:base"))
    assert {kind_name for kind_name in names(first) if kind_name[0] != "alignment"} <= names(again)


def test_undoing_an_edit_measures_nothing(session):
    session.measure(program_of())
    session.measure(program_of(top={"cut": {"band_mm": 1.0}}))
    assert session.measure(program_of()).measured == frozenset()


def test_rows_state_what_is_current_stale_and_failed(session):
    program = program_of()
    assert {row.state for row in session.rows(program)} == {"stale"}
    session.measure(program)
    assert {row.state for row in session.rows(program)} == {"current"}
    edited = program_of(top={"cut": {"band_mm": 1.0}})
    stale = {row.node.name for row in session.rows(edited) if row.state == "stale"}
    assert stale == {"top", "mid", "height", "mid to base"}


def test_a_failed_feature_keeps_its_place_and_is_named_by_its_children(session):
    program = program_of(top={"point_mm": [0.0, 0.0, 500.0]})
    result = session.measure(program)
    rows = {(row.node.kind, row.node.name): row for row in result.rows}
    assert rows["feature", "top"].state == "failed" and "points were measured there" in rows["feature", "top"].reason
    assert rows["feature", "mid"].failed_parents == (Node("feature", "top"),)
    assert rows["dimension", "mid to base"].failed_parents == (Node("feature", "top"),)
    assert rows["dimension", "diameter"].state == "current"
    by_name = {one.name: one for one in result.inspection.dimensions}
    assert by_name["mid to base"].verdict is Verdict.NOT_MEASURED and "top" in by_name["mid to base"].reason


def test_an_empty_tolerance_means_no_verdict(session):
    result = session.measure(program_of(height={"tolerance": ""}))
    height = result.inspection.dimensions[0]
    assert height.verdict is Verdict.NO_TOLERANCE and height.lower_tolerance is None and height.measured is not None


def test_a_tolerance_smaller_than_five_u_is_warned_of(session):
    result = session.measure(program_of(height={"tolerance": "±0.001"}))
    assert "smaller than 5 U" in result.inspection.dimensions[0].warning
    assert result.inspection.dimensions[0].tolerance_source == "±0.001"


def test_a_dimension_may_name_its_own_alignment(session, points):
    further = [{"name": "to base", "alignment": "datums:base"}]
    program = program_of(alignments=further, position={"alignment": "to base"})
    result = session.measure(program)
    alone = inspect(points, program_of(alignment="datums:base"))
    by_name = {one.name: one for one in result.inspection.dimensions}
    assert by_name["position"].measured == {one.name: one for one in alone.dimensions}["position"].measured
    assert by_name["position"].alignment == "to base" and "to base" in result.inspection.further


def test_a_further_alignment_that_fails_spares_the_others(session):
    further = [{"name": "to nothing", "alignment": "datums:nowhere"}]
    program = program_of(alignments=further, height={"alignment": "to nothing"}, extra_features=[_nowhere()])
    by_name = {one.name: one for one in session.measure(program).inspection.dimensions}
    assert by_name["height"].verdict is Verdict.NOT_MEASURED and "to nothing" in by_name["height"].reason
    assert by_name["diameter"].measured is not None


def test_a_failed_alignment_of_the_program_is_an_error(session):
    with pytest.raises(InspectionError, match="alignment"):
        session.measure(program_of(alignment="datums:nowhere", extra_features=[_nowhere()]))
    assert session.measure(program_of()).inspection.dimensions[0].measured is not None


def test_random_edits_give_the_results_of_measuring_afresh(session, points):
    rng = np.random.default_rng(4)
    edits = [
        {"height": {"upper_tolerance": 0.3}},
        {"height": {"tolerance": "2768-m"}},
        {"top": {"cut": {"band_mm": 1.5}}},
        {"bore": {"cut": {"band_mm": 1.2}}},
        {"alignment": "datums:base,bore"},
        {"position": {"upper_tolerance": 0.05}},
        {"side": {"name": "flank", "cut": {"edge_mm": 1.0}}},
        {"alignments": [{"name": "b", "alignment": "datums:base"}], "position": {"alignment": "b"}},
    ]
    chosen: dict = {}
    for number in rng.integers(0, len(edits), 6):
        chosen = {**chosen, **edits[number]} if rng.random() < 0.7 else dict(edits[number])
        if chosen.get("position", {}).get("alignment") and "alignments" not in chosen:
            chosen.pop("position")
        program = program_of(**chosen)
        assert_same(session.measure(program).inspection, inspect(points, program))


def test_the_graph_knows_parents_children_and_descendants():
    graph = Graph.of(program_of())
    top = Node("feature", "top")
    assert graph.parents[Node("feature", "mid")] == (top, Node("feature", "base"))
    assert set(graph.children(top)) == {Node("feature", "mid"), Node("dimension", "height")}
    assert Node("dimension", "mid to base") in graph.descendants(top)
    assert Node("feature", "base") in graph.ancestors(Node("dimension", "mid to base"))


def _nowhere():
    return {"name": "nowhere", "shape": "plane", "point_mm": [0, 0, 900], "direction": [0, 0, 1]}


@pytest.mark.timed
def test_one_dimension_of_half_a_million_points_takes_less_than_a_second_of_processor_time(samples, scan):
    part = samples("gypsum")
    points = scan(part.nominal, RigidTransform.identity("part", "nominal"), count=640_000)
    assert len(points) > 450_000
    session = InspectionSession(points, part.surface)
    session.measure(part.program)
    face = next(one for one in part.program.features if one.name == "face x+")
    cut = {**face.cut.model_dump(exclude_unset=True), "band_mm": 1.5}
    edited = change(part.program, Node("feature", "face x+"), {"cut": cut})
    before = time.process_time()
    result = session.measure(edited)
    assert time.process_time() - before < 1.0
    assert names(result) == {("feature", "face x+"), ("dimension", "a")}


def test_rows_can_be_asked_for_while_a_measurement_runs(points):
    session, program = InspectionSession(points), program_of()
    session.measure(program)
    seen = []

    class Asking(NoProgress):
        def report(self, done, total, note=""):
            seen.append({row.state for row in session.rows(program)})

    session.measure(program, Asking())
    assert seen and all(states == {"current"} for states in seen)


def test_a_cancelled_measurement_leaves_what_it_finished(points):
    session, program = InspectionSession(points), program_of()

    class Cancelling(NoProgress):
        def report(self, done, total, note=""):
            if note == "side":
                raise Cancelled

    with pytest.raises(Cancelled):
        session.measure(program, Cancelling())
    assert ("feature", "top") not in names(session.measure(program))
    assert_same(session.measure(program).inspection, inspect(points, program))


@pytest.mark.slow
def test_edits_of_a_sample_part_give_the_results_of_measuring_afresh(samples, scan, on_table):
    part = samples("gypsum")
    points = scan(part.nominal, on_table(20.0), count=60_000)
    session = InspectionSession(points, part.surface)
    rng = np.random.default_rng(7)
    program = part.program
    for _ in range(12):
        feature = program.features[rng.integers(len(program.features))]
        dimension = program.dimensions[rng.integers(len(program.dimensions))]
        edit = rng.integers(4)
        if edit == 0:
            cut = {**feature.cut.model_dump(exclude_unset=True), "band_mm": float(rng.uniform(1, 2))}
            program = change(program, Node("feature", feature.name), {"cut": cut})
        elif edit == 1:
            program = set_tolerance(program, dimension.name, rng.choice(["±0.05", "2768-m", "", "+0.1/-0.02"]))
        elif edit == 2:
            program = rename(program, Node("feature", feature.name), f"{feature.name}*")
        else:
            words = rng.choice(["best-fit", "none", f"datums:{program.features[-1].name}"])
            program = set_alignment(program, str(words))
        try:
            fresh = inspect(points, program, part.nominal)
        except InspectionError as error:
            with pytest.raises(InspectionError, match=re.escape(error.message)):
                session.measure(program)
            continue
        assert_same(session.measure(program).inspection, fresh)
