"""Circles, slots, lines and edges: simulated surfaces with stated noise, and the truth asked back within bounds from that noise."""

from __future__ import annotations

import numpy as np
import pytest
from pydantic import ValidationError

from measureapp.data.inspection_program import InspectionProgram
from measureapp.geometry.transform import rotation_about
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.session.session import InspectionSession
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings

NOISE = 0.02
ONLY_SCATTER = InspectionSettings(uncertainty=UncertaintySettings(placement_mm=0, systematic_mm=0, systematic_relative=0))
CIRCLE = {"name": "c", "shape": "circle", "point_mm": [0, 0, 5], "direction": [0, 0, 1], "radius_mm": 10, "hole": True, "height_mm": 3}
SLOT = {
    "name": "s",
    "shape": "slot",
    "point_mm": [0, 0, 5],
    "direction": [0, 0, 1],
    "along": [1, 0, 0],
    "length_mm": 30,
    "width_mm": 10,
    "hole": True,
    "height_mm": 3,
}
LINE = {"name": "l", "shape": "line", "point_mm": [0, 0, 0], "direction": [1, 0, 0], "normals": [[0, 0, 1]], "length_mm": 60}
EDGE = {"name": "e", "shape": "edge", "point_mm": [0, 0, 0], "direction": [0, 1, 0], "normals": [[0, 0, 1], [1, 0, 0]], "length_mm": 60}


def measure(feature, points, *dimensions, more=()):
    program = InspectionProgram.model_validate(
        {"name": "p", "alignment": "none", "features": [feature, *more], "dimensions": list(dimensions)}
    )
    result = inspect(points, program, settings=ONLY_SCATTER)
    return {one.name: one for one in result.features}, {one.name: one for one in result.dimensions}


def noisy(rng, points, normals, noise=NOISE):
    return MeasuredPoints(points + noise * rng.standard_normal((len(points), 1)) * normals, normals)


def bore_wall(rng, radius=10.07, centre=(0.11, -0.08), count=1500, arc=2 * np.pi):
    turn, z = rng.uniform(0, arc, count), rng.uniform(0, 10, count)
    out = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(count)])
    return noisy(rng, radius * out + np.column_stack([np.full(count, centre[0]), np.full(count, centre[1]), z]), -out)


def slot_wall(rng, length=30.12, width=10.06, turn=0.01, centre=(0.1, 0.15), count=3000):
    half, radius = (length - width) / 2, width / 2
    around = 4 * half + 2 * np.pi * radius
    s = rng.uniform(0, around, count)
    straight = s < 4 * half
    side = np.where(s < 2 * half, 1.0, -1.0)
    u = np.where(straight, (s % (2 * half)) - half, 0.0)
    angle = (s - 4 * half) / radius
    end = np.where(angle < np.pi, 1.0, -1.0)
    bow = np.where(angle < np.pi, angle - np.pi / 2, angle - np.pi - np.pi / 2)
    out = np.where(straight[:, None], np.column_stack([np.zeros(count), side]), np.column_stack([end * np.cos(bow), np.sin(bow)]))
    middle = np.where(straight[:, None], np.column_stack([u, np.zeros(count)]), np.column_stack([end * half, np.zeros(count)]))
    flat = middle + radius * out
    rotation = rotation_about([0, 0, 1], turn)
    points = np.column_stack([flat, rng.uniform(0, 10, count)]) @ rotation.T + [*centre, 0]
    return noisy(rng, points, -np.column_stack([out, np.zeros(count)]) @ rotation.T)


def corner(rng, shift=(0.0, 0.0), lean=0.0, count=4000, bow=0.0):
    """Two faces of a block that meet at x = shift[0], z = shift[1]; the first leans about y, the edge bows by ``bow`` along x."""
    y = rng.uniform(-32, 32, (2, count))
    top = np.column_stack([rng.uniform(-12, 0, count), y[0], np.zeros(count)])
    side = np.column_stack([bow * (1 - (y[1] / 30) ** 2), y[1], rng.uniform(-12, 0, count)])
    turned = rotation_about([0, 1, 0], lean)
    points = np.vstack([top @ turned.T, side]) + np.array([shift[0], 0, shift[1]])
    normals = np.vstack([np.tile(turned @ [0, 0, 1.0], (count, 1)), np.tile([1.0, 0, 0], (count, 1))])
    return noisy(rng, points, normals)


def test_a_circle_is_found_in_a_slice_of_its_wall():
    rng = np.random.default_rng(1)
    features, dimensions = measure(CIRCLE, bore_wall(rng), {"name": "d", "kind": "diameter", "features": ["c"], "nominal": 20})
    used = features["c"].points
    assert 300 < used < 600  # 3 mm of 10 mm
    assert features["c"].point_mm[:2] == pytest.approx((0.11, -0.08), abs=4 * NOISE * np.sqrt(2 / used))
    assert features["c"].point_mm[2] == 5.0
    assert dimensions["d"].measured == pytest.approx(20.14, abs=8 * NOISE / np.sqrt(used))
    assert dimensions["d"].uncertainty == pytest.approx(4 * NOISE / np.sqrt(used), rel=0.4)


def test_the_intervals_of_a_circle_contain_the_truth_as_often_as_stated():
    hits = []
    for seed in range(60):
        _, dimensions = measure(
            CIRCLE, bore_wall(np.random.default_rng(seed), arc=4.0), {"name": "d", "kind": "diameter", "features": ["c"], "nominal": 20}
        )
        d = dimensions["d"]
        hits.append(abs(d.measured - 20.14) <= d.uncertainty)
    assert 0.85 <= np.mean(hits) <= 1.0  # 95 % less three standard deviations of 60 draws


def test_a_short_arc_determines_no_circle():
    _, dimensions = measure(
        CIRCLE, bore_wall(np.random.default_rng(2), arc=0.15), {"name": "d", "kind": "diameter", "features": ["c"], "nominal": 20}
    )
    assert dimensions["d"].measured is None and "c: " in dimensions["d"].reason


def test_a_slot_gives_width_length_and_place():
    wanted = [
        {"name": "w", "kind": "slot_width", "features": ["s"], "nominal": 10, "tolerance": "H11"},
        {"name": "l", "kind": "slot_length", "features": ["s"], "nominal": 30},
    ]
    features, dimensions = measure(SLOT, slot_wall(np.random.default_rng(3)), *wanted)
    assert dimensions["w"].measured == pytest.approx(10.06, abs=1.5 * dimensions["w"].uncertainty)
    assert dimensions["l"].measured == pytest.approx(30.12, abs=1.5 * dimensions["l"].uncertainty)
    assert dimensions["w"].uncertainty < 0.01 and dimensions["l"].uncertainty < 0.02
    assert features["s"].point_mm == pytest.approx([0.1, 0.15, 5.0], abs=0.01)
    assert np.arctan2(features["s"].direction[1], features["s"].direction[0]) == pytest.approx(0.01, abs=0.002)


def test_the_intervals_of_a_slot_contain_the_truth_as_often_as_stated():
    hits = []
    for seed in range(40):
        _, found = measure(
            SLOT,
            slot_wall(np.random.default_rng(seed), count=1500),
            {"name": "w", "kind": "slot_width", "features": ["s"], "nominal": 10},
            {"name": "l", "kind": "slot_length", "features": ["s"], "nominal": 30},
        )
        hits += [abs(found["w"].measured - 10.06) <= found["w"].uncertainty, abs(found["l"].measured - 30.12) <= found["l"].uncertainty]
    assert np.mean(hits) >= 0.85


def test_a_slot_has_no_diameter():
    _, found = measure(SLOT, slot_wall(np.random.default_rng(3)), {"name": "d", "kind": "diameter", "features": ["s"], "nominal": 10})
    assert "has no radius" in found["d"].reason


def test_a_line_follows_its_face_and_its_straightness_is_measured():
    rng = np.random.default_rng(4)
    x, y = rng.uniform(-32, 32, 6000), rng.uniform(-5, 5, 6000)
    height = 0.05 + 0.002 * x + 0.04 * np.sin(2 * np.pi * x / 40)
    face = noisy(rng, np.column_stack([x, y, height]), np.tile([0, 0, 1.0], (6000, 1)))
    features, found = measure(LINE, face, {"name": "st", "kind": "straightness", "features": ["l"], "upper_tolerance": 0.2})
    assert features["l"].direction[2] == pytest.approx(0.002, abs=0.0015)
    assert found["st"].measured == pytest.approx(0.078, abs=found["st"].uncertainty + 0.006)  # cells of 5 mm flatten the wave a little


def test_an_edge_is_where_its_faces_meet_whatever_is_missing_beside_it():
    rng = np.random.default_rng(5)
    points = corner(rng, shift=(0.08, -0.05), lean=0.003)
    near = (points.points_mm[:, 0] > -1.4) & (points.points_mm[:, 2] > -1.4)  # what window and blur removed
    features, _ = measure(EDGE, points.where(~near))
    truth = np.array([0.08, 0.0, -0.05])
    bound = 4 * NOISE * np.hypot(1 / np.sqrt(1000), 3.5 / 1.15 / np.sqrt(1000))
    assert features["e"].point_mm == pytest.approx(truth, abs=bound)
    assert "beside the edge" in features["e"].how


def test_the_intervals_of_an_edge_distance_contain_the_truth_as_often_as_stated():
    far = {"name": "q", "shape": "plane", "point_mm": [-12, 0, -6], "direction": [-1, 0, 0], "cut": {"band_mm": 1}}
    hits = []
    for seed in range(25):
        rng = np.random.default_rng(seed)
        points = corner(rng, shift=(0.08, -0.05), count=1500)
        wall = np.column_stack([np.full(800, -12.0), rng.uniform(-30, 30, 800), rng.uniform(-11, -1, 800)])
        back = noisy(rng, wall, np.tile([-1.0, 0, 0], (800, 1)))
        both = MeasuredPoints(np.vstack([points.points_mm, back.points_mm]), np.vstack([points.normals, back.normals]))
        _, found = measure(EDGE, both, {"name": "d", "kind": "distance", "features": ["e", "q"], "nominal": 12}, more=[far])
        hits.append(abs(found["d"].measured - 12.08) <= found["d"].uncertainty)
    assert np.mean(hits) >= 0.85


def test_the_straightness_of_an_edge_is_that_of_its_faces():
    bent = corner(np.random.default_rng(6), bow=0.3, count=12000)
    _, found = measure(EDGE, bent, {"name": "st", "kind": "straightness", "features": ["e"], "upper_tolerance": 0.5})
    assert found["st"].measured == pytest.approx(0.2505, abs=0.01)  # sections of 5 mm, the outer ones 2.5 mm from its ends


def test_an_internal_edge_has_its_faces_on_the_other_sides():
    rng = np.random.default_rng(7)
    y = rng.uniform(-32, 32, (2, 3000))
    floor = np.column_stack([rng.uniform(0, 12, 3000), y[0], np.zeros(3000)])
    wall = np.column_stack([np.zeros(3000), y[1], rng.uniform(0, 12, 3000)])
    points = noisy(rng, np.vstack([floor, wall]) + np.array([0.05, 0, 0.02]), np.repeat([[0, 0, 1.0], [1.0, 0, 0]], 3000, axis=0))
    features, _ = measure({**EDGE, "hole": True}, points)
    assert features["e"].point_mm == pytest.approx([0.05, 0.0, 0.02], abs=0.01)


def test_a_free_edge_without_a_statement_of_its_loss_is_refused():
    with pytest.raises(ValidationError, match="loss_mm"):
        InspectionProgram.model_validate({"name": "p", "alignment": "none", "features": [{**EDGE, "normals": [[0, 0, 1]]}]})


@pytest.mark.parametrize("lost", [0.0, 0.35, 0.7])
def test_the_uncertainty_of_a_free_edge_covers_the_points_it_lost(lost):
    free = {"name": "f", "shape": "edge", "point_mm": [0, 0, 0], "direction": [0, 1, 0], "normals": [[0, 0, 1]], "length_mm": 60}
    rng = np.random.default_rng(8)
    sheet = np.column_stack([rng.uniform(-20, -lost, 20_000), rng.uniform(-32, 32, 20_000), np.zeros(20_000)])
    points = noisy(rng, sheet, np.tile([0, 0, 1.0], (20_000, 1)))
    features, _ = measure({**free, "loss_mm": 0.7}, points)
    edge = features["f"]
    assert edge.standard_deviations["position_mm"] == pytest.approx(0.7 / np.sqrt(12), abs=0.02)
    assert abs(edge.point_mm[0]) <= 2 * edge.standard_deviations["position_mm"]


def test_a_contour_that_is_not_there_has_a_reason():
    session = InspectionSession(bore_wall(np.random.default_rng(1)))
    program = InspectionProgram.model_validate(
        {"name": "p", "alignment": "none", "features": [CIRCLE, {**EDGE, "point_mm": [400, 0, 0]}], "dimensions": []}
    )
    rows = {row.node.name: row for row in session.measure(program).rows}
    assert rows["c"].state == "current"
    assert rows["e"].state == "failed" and "points were measured there" in rows["e"].reason


def test_patterns_on_lines_and_grids_are_found_at_their_places():
    rng = np.random.default_rng(9)
    places = [(20 * column, 15 * row) for row in range(2) for column in range(3)]
    walls = [bore_wall(rng, 4.03, place, 900) for place in places]
    points = MeasuredPoints(np.vstack([one.points_mm for one in walls]), np.vstack([one.normals for one in walls]))
    grid = {"count": 6, "step_mm": [20, 0, 0], "per_row": 3, "row_step_mm": [0, 15, 0]}
    features, _ = measure({**CIRCLE, "radius_mm": 4, "repeat": grid}, points)
    for number, place in enumerate(places, start=1):
        assert features[f"c.{number}"].point_mm[:2] == pytest.approx(place, abs=0.01)


def test_the_roundness_of_a_circle_is_that_of_its_slice():
    rng = np.random.default_rng(10)
    turn, z = rng.uniform(0, 2 * np.pi, 20_000), rng.uniform(0, 10, 20_000)
    out = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(20_000)])
    wall = noisy(rng, (10 + 0.05 * np.cos(2 * turn))[:, None] * out + np.column_stack([np.zeros((20_000, 2)), z]), -out)
    _, found = measure(CIRCLE, wall, {"name": "r", "kind": "roundness", "features": ["c"], "upper_tolerance": 0.2})
    assert found["r"].measured == pytest.approx(0.1, abs=found["r"].uncertainty + 0.006)  # cells flatten the oval a little


def test_circles_at_different_heights_are_concentric_in_their_plane():
    rng = np.random.default_rng(11)
    lower, upper = bore_wall(rng, 10.0, (0.0, 0.0)), bore_wall(rng, 6.0, (0.1, 0.0))
    raised = upper.points_mm + np.array([0.0, 0.0, 20.0])
    both = MeasuredPoints(np.vstack([lower.points_mm, raised]), np.vstack([lower.normals, upper.normals]))
    small = {**CIRCLE, "name": "o", "point_mm": [0, 0, 25], "radius_mm": 6}
    wanted = {"name": "k", "kind": "concentricity", "features": ["o"], "datums": ["c"], "upper_tolerance": 0.5}
    _, found = measure(CIRCLE, both, wanted, more=[small])
    assert found["k"].measured == pytest.approx(0.2, abs=1.5 * found["k"].uncertainty)


def test_the_position_of_a_circle_and_a_slot_counts_in_their_plane():
    base = {"name": "b", "shape": "plane", "point_mm": [0, 0, 0], "direction": [0, 0, -1]}
    side = {"name": "q", "shape": "plane", "point_mm": [-25, 0, 5], "direction": [-1, 0, 0]}
    end = {"name": "r", "shape": "plane", "point_mm": [0, -25, 5], "direction": [0, -1, 0]}
    rng = np.random.default_rng(12)

    def face(normal, at, across, count=2000):
        first, second = across
        flat = rng.uniform(-4, 4, count)[:, None] * np.array(first) + rng.uniform(-20, 20, count)[:, None] * np.array(second)
        return noisy(rng, np.array(at) + flat, np.tile(np.array(normal, float), (count, 1)))

    faces = [
        face([0, 0, -1], [0, 0, 0], ([5.0, 0, 0], [0, 1.0, 0])),
        face([-1, 0, 0], [-25, 0, 5], ([0, 0, 1.0], [0, 1.0, 0])),
        face([0, -1, 0], [0, -25, 5], ([0, 0, 1.0], [1.0, 0, 0])),
    ]
    for feature, wall, centre in ((CIRCLE, bore_wall(rng), (0.11, -0.08)), (SLOT, slot_wall(rng), (0.1, 0.15))):
        parts = [*faces, wall]
        points = MeasuredPoints(np.vstack([one.points_mm for one in parts]), np.vstack([one.normals for one in parts]))
        wanted = {"name": "p", "kind": "position", "features": [feature["name"]], "datums": ["b", "q", "r"], "upper_tolerance": 0.5}
        _, found = measure(feature, points, wanted, more=[base, side, end])
        assert found["p"].measured == pytest.approx(2 * np.hypot(*centre), abs=2 * found["p"].uncertainty)
