"""Circle, slot, line, edge and hole pattern from clicks: the nominal's own dimensions, or those of the measured points."""

from __future__ import annotations

import numpy as np
import pytest
from inspection.drilled_plate import (
    HOLE_MM,
    HOLES_AT,
    SLOT_AT,
    SLOT_LENGTH_MM,
    SLOT_WIDTH_MM,
    SMALL_AT,
    SMALL_MM,
    drilled_plate,
    mesh_of,
    points_on,
    tube,
)

from measureapp.data.inspection_program import InspectionProgram
from measureapp.errors import InputError, InspectionError
from measureapp.inspection.programming.clicking.describe import describe_on_nominal, describe_on_points, nominals_described, try_feature
from measureapp.inspection.programming.clicking.patterns import copies_of, pattern_of_selected
from measureapp.inspection.programming.nominals import nominals_of
from measureapp.inspection.surface.nominal import NominalSurface

NOISE_MM = 0.01
EXACT_MM = 1e-5  # the nominal's vertices are on its shapes; entries are rounded to 1e-6
FACETS_MM = 0.022  # of a diameter: the points are on facets of up to 7°, which are inside the circle through their vertices
CLICKED_MM = 0.1  # of a nominal from clicks on noisy points: it is a start only, and the band around it is 2 mm


@pytest.fixture(scope="module")
def surface():
    return NominalSurface(drilled_plate())


@pytest.fixture(scope="module")
def points():
    return points_on(drilled_plate(), noise_mm=NOISE_MM)


def on_wall(centre, radius_mm, degrees, z=5.0):
    return np.array([centre[0] + radius_mm * np.cos(np.radians(degrees)), centre[1] + radius_mm * np.sin(np.radians(degrees)), z])


@pytest.mark.parametrize(
    "click", [on_wall(HOLES_AT[1], HOLE_MM, 200, 3.0), [30.0, 17.5, 10.0], [30.0, 17.5, 0.0]], ids=["wall", "top", "base"]
)
def test_a_click_on_a_hole_or_beside_it_gives_its_circle_and_the_points_its_true_size(surface, points, click):
    entry = describe_on_nominal("circle", surface, [np.array(click)], "c")
    assert entry["hole"] is True and entry["radius_mm"] == pytest.approx(HOLE_MM, abs=EXACT_MM)
    assert entry["point_mm"][:2] == pytest.approx(HOLES_AT[1], abs=EXACT_MM) and entry["direction"] == pytest.approx([0, 0, 1], abs=1e-6)
    level = entry["point_mm"][2]
    assert 3.0 <= level <= 7.0 and entry["height_mm"] == 2.0  # away from both ends of the wall
    assert click[2] not in (3.0,) or level == pytest.approx(3.0, abs=1e-6)  # the height of the click where that is
    (found,) = try_feature(entry, points, surface)
    assert found.feature is not None and found.feature.points > 200
    bound = 5 * NOISE_MM * np.sqrt(2 / found.feature.points)
    assert 2 * found.feature.radius_mm == pytest.approx(2 * HOLE_MM, abs=2 * bound + FACETS_MM)
    assert found.feature.point_mm[:2] == pytest.approx(HOLES_AT[1], abs=bound)


def test_the_click_beside_a_hole_means_the_nearest_one(surface):
    entry = describe_on_nominal("circle", surface, [np.array([50.0, 26.0, 10.0])], "c")
    assert entry["radius_mm"] == pytest.approx(SMALL_MM, abs=EXACT_MM) and entry["point_mm"][:2] == pytest.approx(SMALL_AT, abs=EXACT_MM)


def test_a_click_on_a_chamfer_means_the_hole_below_it():
    mesh = mesh_of(np.concatenate([tube([0, 0, 0], 5.0, 0, 8), tube([0, 0, 0], 5.0, 8, 9, top_mm=6.0)]))
    entry = describe_on_nominal("circle", NominalSurface(mesh), [np.array([5.5, 0, 8.5])], "c")
    assert entry["radius_mm"] == pytest.approx(5.0, abs=EXACT_MM) and entry["point_mm"][2] == pytest.approx(5.0, abs=1e-6)


def test_a_slot_has_the_dimensions_of_the_nominal_and_is_measured_within_its_noise(surface, points):
    for click in ([20.0, 26.0, 5.0], [20.0, 35.0, 10.0]):
        entry = describe_on_nominal("slot", surface, [np.array(click)], "s")
        assert (entry["length_mm"], entry["width_mm"]) == pytest.approx((SLOT_LENGTH_MM, SLOT_WIDTH_MM), abs=1e-4)
        assert entry["point_mm"][:2] == pytest.approx(SLOT_AT, abs=1e-4) and entry["along"] == pytest.approx([1, 0, 0], abs=1e-5)
        assert entry["hole"] is True
    (found,) = try_feature(entry, points, surface)
    assert found.feature is not None
    assert 2 * found.feature.radius_mm == pytest.approx(SLOT_WIDTH_MM, abs=FACETS_MM) and found.feature.length_mm == pytest.approx(
        SLOT_LENGTH_MM, abs=0.03
    )


def test_a_line_runs_from_the_first_click_to_the_second_on_one_face(surface, points):
    entry = describe_on_nominal("line", surface, [np.array([2.0, 19.0, 10.0]), np.array([58.0, 21.0, 10.0])], "l")
    assert entry["length_mm"] == pytest.approx(np.hypot(56, 2)) and entry["normals"] == [[0, 0, 1]]
    (found,) = try_feature(entry, points, surface)
    assert found.feature is not None and found.feature.point_mm[2] == pytest.approx(10.0, abs=5 * NOISE_MM / np.sqrt(found.feature.points))


def test_an_edge_is_that_of_its_two_faces_wherever_it_is_clicked(surface, points):
    for click in ([20.0, 1.0, 10.0], [45.0, 0.0, 9.0]):
        entry = describe_on_nominal("edge", surface, [np.array(click)], "e")
        assert entry["point_mm"] == pytest.approx([30, 0, 10], abs=1e-6) and np.abs(entry["direction"]) == pytest.approx(
            [1, 0, 0], abs=1e-6
        )
        assert sorted(entry["normals"]) == [pytest.approx([0, -1, 0], abs=1e-6), pytest.approx([0, 0, 1], abs=1e-6)]
        assert 55 < entry["length_mm"] < 60 and "hole" not in entry
    (found,) = try_feature(entry, points, surface)
    assert found.feature is not None and found.feature.point_mm[1:] == pytest.approx([0, 10], abs=5e-3)


def test_an_inner_edge_has_its_material_outside():
    step = np.array(
        [
            [[0, 0, 0], [20, 0, 0], [20, 20, 0]],
            [[0, 0, 0], [20, 20, 0], [0, 20, 0]],
            [[0, 0, 0], [0, 20, 0], [0, 20, 15]],
            [[0, 0, 0], [0, 20, 15], [0, 0, 15]],
        ],
        float,
    )
    mesh = mesh_of(step)
    surface = NominalSurface(mesh)
    entry = describe_on_nominal("edge", surface, [np.array([1.0, 9.0, 0.0])], "e")
    assert entry["hole"] is True and entry["point_mm"] == pytest.approx([0, 10, 0], abs=1e-6)
    (found,) = try_feature(entry, points_on(mesh, noise_mm=NOISE_MM), surface)
    assert found.feature is not None and found.feature.point_mm[[0, 2]] == pytest.approx([0, 0], abs=5e-3)


def test_a_click_on_one_hole_finds_the_row_of_all_equal_ones(surface, points):
    entry = describe_on_nominal("pattern", surface, [on_wall(HOLES_AT[0], HOLE_MM, 90)], "h")
    assert entry["repeat"] == {"count": 3, "step_mm": pytest.approx([20, 0, 0], abs=1e-5)}
    assert copies_of(entry) == ("h.1", "h.2", "h.3")
    found = try_feature(entry, points, surface)
    assert [one.feature.point_mm[:2] for one in found] == [pytest.approx(place, abs=5e-3) for place in HOLES_AT]
    middle = describe_on_nominal("pattern", surface, [on_wall(HOLES_AT[1], HOLE_MM, 90)], "h")
    assert middle["repeat"]["count"] == 3 and middle["point_mm"][0] in (pytest.approx(10), pytest.approx(50))  # a row begins at its end


def test_holes_on_a_circle_are_a_pattern_about_its_axis_and_other_holes_are_not_part_of_it():
    axis = np.array([0.0, 1.0, 1.0]) / np.sqrt(2)
    u, v = np.array([1.0, 0, 0]), np.cross(axis, [1.0, 0, 0])
    centre = np.array([3.0, -2.0, 5.0])
    places = [centre + 20 * (np.cos(t) * u + np.sin(t) * v) for t in np.radians([10, 82, 154, 226, 298])]
    inner = [centre + 9 * (np.cos(t) * u + np.sin(t) * v) for t in np.radians([0, 120, 240])]
    walls = [tube(place, 2.5, -4, 4, axis=axis) for place in (*places, *inner)]
    walls += [tube(centre, 5.0, -4, 4, axis=axis), tube(places[0] + 20 * axis, 2.5, -4, 4, axis=axis)]  # of another size, at another level
    surface = NominalSurface(mesh_of(np.concatenate(walls)))
    entry = describe_on_nominal("pattern", surface, [places[2] + 2.5 * u], "h")
    found = [one.point_mm for one in nominals_described(entry)]
    assert len(found) == 5 and entry["repeat"]["angle_deg"] == pytest.approx(72)
    for place in places:
        assert min(np.linalg.norm(one - place) for one in found) < 1e-4


def test_a_grid_is_a_pattern_from_its_corner():
    walls = [tube([12.0 * column, 15.0 * row, 0], 2.0, -3, 3) for row in range(2) for column in range(4)]
    surface = NominalSurface(mesh_of(np.concatenate(walls)))
    entry = describe_on_nominal("pattern", surface, [np.array([2.0, 0, 0])], "h")
    assert len(nominals_described(entry)) == 8 and entry["repeat"]["per_row"] == 4
    assert {tuple(np.round(one.point_mm[:2], 4)) for one in nominals_described(entry)} == {
        (12.0 * c, 15.0 * r) for r in range(2) for c in range(4)
    }


@pytest.mark.parametrize(
    ("kind", "clicks", "reason"),
    [
        ("circle", [[20.0, 26.0, 5.0]], "not a cylinder"),
        ("circle", [[0.0, 20.0, 5.0]], "no curved wall"),
        ("circle", [[30.0, 10.0, 25.0]], "off the CAD model"),
        ("slot", [[36.0, 10.0, 5.0]], "round"),
        ("line", [[10.0, 19.0, 10.0], [10.5, 19.0, 10.0]], "less than 2 mm apart"),
        ("line", [[2.0, 19.0, 10.0], [0.0, 19.0, 5.0]], "not straight"),
        ("edge", [[36.2, 10.0, 10.0]], "curved"),
        ("edge", [[20.0, 20.0, 10.0]], "edge"),
        ("pattern", [[53.0, 30.0, 5.0]], "no other hole"),
    ],
)
def test_a_click_that_gives_no_such_feature_is_refused_with_a_remedy(surface, kind, clicks, reason):
    with pytest.raises(InspectionError, match=reason) as refused:
        describe_on_nominal(kind, surface, [np.array(one) for one in clicks], "x")
    assert refused.value.hint


def test_without_a_nominal_three_clicks_on_a_wall_give_a_circle(points):
    entry = describe_on_points(
        "circle", points, [on_wall(HOLES_AT[0], HOLE_MM, angle, z) for angle, z in ((10, 4), (120, 6), (250, 5))], "c"
    )
    assert entry["hole"] is True and entry["radius_mm"] == pytest.approx(HOLE_MM, abs=CLICKED_MM)
    assert entry["point_mm"] == pytest.approx([*HOLES_AT[0], 5.0], abs=CLICKED_MM) and entry["direction"] == pytest.approx(
        [0, 0, 1], abs=0.01
    )
    (found,) = try_feature(entry, points, None)
    assert 2 * found.feature.radius_mm == pytest.approx(2 * HOLE_MM, abs=FACETS_MM)


def test_without_a_nominal_ends_and_sides_give_a_slot(points):
    half = SLOT_LENGTH_MM / 2
    clicks = [[20 - half, 30.0, 5.0], [20 + half, 30.1, 4.0], [18.0, 26.0, 5.0], [23.0, 34.0, 6.0]]
    entry = describe_on_points("slot", points, [np.array(one) for one in clicks], "s")
    assert (entry["length_mm"], entry["width_mm"]) == pytest.approx((SLOT_LENGTH_MM, SLOT_WIDTH_MM), abs=CLICKED_MM)
    (found,) = try_feature(entry, points, None)
    assert 2 * found.feature.radius_mm == pytest.approx(SLOT_WIDTH_MM, abs=FACETS_MM)


def test_without_a_nominal_a_click_on_each_face_gives_their_edge_between_its_ends(points):
    entry = describe_on_points("edge", points, [np.array([30.0, 2.5, 10.0]), np.array([20.0, 0.0, 6.0])], "e")
    assert entry["point_mm"] == pytest.approx([30, 0, 10], abs=0.3) and entry["length_mm"] == pytest.approx(60, abs=2.0)
    assert np.asarray(entry["point_mm"])[1:] == pytest.approx([0, 10], abs=0.01) and "hole" not in entry
    (found,) = try_feature(entry, points, None)
    assert found.feature is not None and found.feature.point_mm[1:] == pytest.approx([0, 10], abs=5e-3)


def test_without_a_nominal_two_clicks_give_a_line(points):
    entry = describe_on_points("line", points, [np.array([2.0, 19.0, 10.0]), np.array([58.0, 19.0, 10.0])], "l")
    assert entry["length_mm"] == pytest.approx(56, abs=0.1) and entry["normals"][0] == pytest.approx([0, 0, 1], abs=0.01)


@pytest.mark.parametrize(
    ("kind", "clicks", "reason"),
    [
        ("circle", [[2.0, 2.0, 10.0], [5.0, 20.0, 10.0], [40.0, 20.0, 10.0]], "one flat face"),
        ("circle", [[16.0, 10.0, 5.0], [0.0, 20.0, 5.0], [30.0, 4.0, 5.0]], "not on one wall"),
        ("circle", [[10.0, 10.0, 5.0], [10.0, 10.0, 6.0], [10.0, 10.0, 7.0]], "Nothing was measured"),
        ("edge", [[2.0, 2.0, 10.0], [40.0, 20.0, 10.0]], "parallel"),
        ("line", [[2.0, 19.0, 10.0], [0.0, 19.0, 4.0]], "not straight"),
        ("pattern", [[16.0, 10.0, 5.0]], "CAD model only"),
    ],
)
def test_clicks_on_points_that_give_no_such_feature_are_refused_with_a_remedy(points, kind, clicks, reason):
    with pytest.raises(InspectionError, match=reason) as refused:
        describe_on_points(kind, points, [np.array(one) for one in clicks], "x")
    assert refused.value.hint


def test_selected_holes_become_a_pattern_of_the_first_and_unlike_ones_are_refused(surface):
    entries = [describe_on_nominal("circle", surface, [on_wall(place, HOLE_MM, 0)], f"c{k}") for k, place in enumerate(HOLES_AT)]
    entries.append(describe_on_nominal("circle", surface, [on_wall(SMALL_AT, SMALL_MM, 0)], "small"))
    program = InspectionProgram.model_validate({"name": "p", "alignment": "none", "features": entries})
    made = pattern_of_selected(program, ["c2", "c0", "c1"], dict(nominals_of(program)), "h")
    assert made["repeat"] == {"count": 3, "step_mm": pytest.approx([-20, 0, 0], abs=1e-5)} and made["radius_mm"] == entries[2]["radius_mm"]
    for names, reason in ((["c0"], "at least two"), (["c0", "small"], "not equal")):
        with pytest.raises(InspectionError, match=reason):
            pattern_of_selected(program, names, dict(nominals_of(program)), "h")


def test_an_entry_with_impossible_values_is_refused_in_words():
    with pytest.raises(InputError, match="longer than wide"):
        nominals_described(
            {"name": "s", "shape": "slot", "point_mm": [0, 0, 0], "direction": [0, 0, 1], "along": [1, 0, 0], "length_mm": 5, "width_mm": 8}
        )
