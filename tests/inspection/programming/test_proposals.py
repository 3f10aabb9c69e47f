import numpy as np
import pytest
from inspection.session.machined import UP, machined_part, program_of

from measureapp.data.inspection_program import InspectionProgram
from measureapp.errors import InspectionError
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.measured_points import MeasuredPoints, sample_mesh
from measureapp.inspection.programming.edits import add
from measureapp.inspection.programming.nominals import nominals_of
from measureapp.inspection.programming.picking import pick_on_nominal, shapes_at
from measureapp.inspection.programming.proposals import propose_dimensions

EXTRA = [
    {"name": "hole", "shape": "cylinder", "point_mm": [40, 0, 0], "direction": UP, "radius_mm": 3, "repeat": {"count": 4, "angle_deg": 90}},
    {"name": "ball", "shape": "sphere", "point_mm": [0, 0, 60], "radius_mm": 5},
    {"name": "slope", "shape": "plane", "point_mm": [0, 0, 30], "direction": [1, 0, 1]},
    {"name": "shaft", "shape": "cylinder", "point_mm": [50, 0, 80], "direction": UP, "radius_mm": 6},
]
PROGRAM = program_of(extra_features=EXTRA)


def proposed(*names):
    return propose_dimensions(PROGRAM, names, nominals_of(PROGRAM))


@pytest.mark.parametrize(
    ("names", "kind", "nominal"),
    [
        (("bore",), "diameter", 16.0),
        (("top", "base"), "distance", 30.0),
        (("top", "side"), "angle", 90.0),
        (("top", "slope"), "angle", 45.0),
        (("hole.1", "hole.2"), "distance", 56.5685),
        (("ball", "top"), "distance", 30.0),
        (("bore", "side"), "distance", 20.0),
        (("top",), "flatness", None),
        (("bore", "top"), "perpendicularity", None),
        (("bore", "shaft"), "coaxiality", None),
    ],
)
def test_the_selection_decides_what_is_proposed(names, kind, nominal):
    found = proposed(*names)[0]
    assert found.kind == kind and found.dimensions[0].get("nominal") == nominal
    add(PROGRAM, "dimension", *found.dimensions)  # is valid


def test_a_pattern_gets_its_pitch_circle_and_spacing():
    (found,) = proposed("hole")
    assert found.features[0]["of"] == ["hole.{k}"] and found.features[0]["count"] == 4
    assert [one["nominal"] for one in found.dimensions] == [80.0, pytest.approx(56.5685)]
    program = add(add(PROGRAM, "feature", *found.features), "dimension", *found.dimensions)
    assert nominals_of(program)["hole pitch circle"].radius_mm == pytest.approx(40)


def test_three_single_holes_get_a_pitch_circle():
    (found,) = proposed("hole.1", "hole.2", "bore")
    assert found.features[0]["of"] == ["hole.1", "hole.2", "bore"] and len(found.dimensions) == 1


def test_axes_in_one_line_get_no_pitch_circle():
    lined = [
        {"name": name, "shape": "cylinder", "point_mm": [0, 0, z], "direction": UP, "radius_mm": 9}
        for name, z in (("hub", 10), ("rim", 50))
    ]
    program = add(PROGRAM, "feature", *lined)
    assert propose_dimensions(program, ["bore", "hub", "rim"], nominals_of(program)) == ()
    balls = [{"name": f"ball {k}", "shape": "sphere", "point_mm": [20 * k, 0, 60], "radius_mm": 5} for k in (1, 2, 3)]
    program = add(PROGRAM, "feature", *balls)
    assert propose_dimensions(program, ["ball 1", "ball 2", "ball 3"], nominals_of(program)) == ()


def test_new_names_are_in_the_language_of_who_edits_the_program():
    chinese = {"diameter": "直径", "pitch circle": "分布圆", "spacing": "间距", "perpendicularity": "垂直度"}
    nominals = nominals_of(PROGRAM)

    def names(*selected):
        return [
            str(one["name"]) for found in propose_dimensions(PROGRAM, selected, nominals, chinese.__getitem__) for one in found.dimensions
        ]

    assert names("hole") == ["hole 分布圆直径", "hole 间距"]
    assert names("bore", "top")[0] == "bore 垂直度"
    assert names("top", "base") == ["top – base"]


def test_no_form_is_proposed_for_a_constructed_feature():
    made = [
        {"name": "above", "shape": "offset", "of": ["top"], "distance_mm": 5.0},
        {"name": "axis", "shape": "symmetry", "of": ["hole.1", "hole.3"]},
    ]
    program = add(PROGRAM, "feature", *made)
    nominal = nominals_of(program)
    assert propose_dimensions(program, ["above"], nominal) == () == propose_dimensions(program, ["axis"], nominal)
    assert [one.kind for one in propose_dimensions(program, ["axis", "top"], nominal)] == [
        "angle"
    ]  # it has no length to be perpendicular over
    assert [one.kind for one in propose_dimensions(program, ["above", "base"], nominal)] == ["distance"]


def test_nothing_is_proposed_where_nothing_fits():
    assert proposed() == () and proposed("unknown") == () and proposed("top", "base", "side") == ()


def test_a_second_proposal_gets_another_name():
    program = add(PROGRAM, "dimension", *proposed("bore")[0].dimensions)
    again = propose_dimensions(program, ["bore"], nominals_of(program))[0]
    assert again.dimensions[0]["name"] == "bore diameter 2"


def test_a_click_on_the_nominal_means_its_face(samples):
    surface = samples("gypsum").surface
    picked = pick_on_nominal(surface, np.array([90.0, 5.0, 25.0]), "end")
    assert picked.entry["shape"] == "plane" and picked.entry["direction"] == pytest.approx([1, 0, 0]) and len(picked.triangles) >= 2
    assert picked.entry["point_mm"][0] == pytest.approx(90)


def test_a_click_on_a_ball_or_a_shaft_means_its_shape(samples):
    plate = samples("sphere_plate")
    ball = next(one for one in plate.program.features if one.shape == "sphere")
    picked = pick_on_nominal(plate.surface, np.array(ball.point_mm) + ball.radius_mm * np.array(UP), "ball")
    assert picked.entry["shape"] == "sphere" and picked.entry["radius_mm"] == pytest.approx(ball.radius_mm, abs=0.01)
    assert not picked.entry.get("hole")


def test_a_picked_face_can_be_measured(samples):
    part = samples("gypsum")
    picked = pick_on_nominal(part.surface, np.array([90.0, 5.0, 25.0]), "end")
    program = InspectionProgram.model_validate({"name": "p", "alignment": "none", "features": [picked.entry]})
    assert inspect(sample_mesh(part.nominal, 60_000), program, part.nominal).features[0].name == "end"


def test_a_click_on_the_cloud_tries_all_shapes():
    points = machined_part(count=3000)
    assert shapes_at(points, np.array([0.0, 0.0, 30.0]))[0].shape == "plane"
    assert shapes_at(points, np.array([58.0, 0.0, 15.0]))[0].shape == "cylinder"
    with pytest.raises(InspectionError, match="no measured surface"):
        shapes_at(MeasuredPoints(points.points_mm, points.normals), np.array([0.0, 0.0, 300.0]))
