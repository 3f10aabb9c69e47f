import pytest
from inspection.session.machined import program_of

from measureapp.errors import InputError, InspectionError
from measureapp.inspection.programming.edits import (
    add,
    change,
    duplicate,
    link_nominal,
    move,
    remove,
    rename,
    set_alignment,
    set_group,
    set_nominal,
    set_tolerance,
    unique_name,
)
from measureapp.inspection.session.graph import Node

TOP, MID, HEIGHT = Node("feature", "top"), Node("feature", "mid"), Node("dimension", "height")
PATTERN = {
    "name": "hole",
    "shape": "cylinder",
    "point_mm": [40, 0, 0],
    "direction": [0, 0, 1],
    "radius_mm": 3,
    "hole": True,
    "repeat": {"count": 4, "angle_deg": 90},
}
RING = {"name": "ring", "shape": "pitch_circle", "of": ["hole.{k}"], "count": 4}


def entry(program, name):
    return next(one for one in (*program.features, *program.dimensions, *program.alignments) if one.name == name)


def test_a_rename_reaches_every_reference():
    program = add(program_of(), "feature", PATTERN, RING)
    program = add(program, "alignment", {"name": "r", "alignment": "rps:hole.1,hole.2,top"})
    program = add(
        program, "dimension", {"name": "gap", "kind": "distance", "features": ["hole.{k}", "hole.{k+1}"], "nominal": 56, "count": 4}
    )
    program = rename(rename(program, Node("feature", "hole"), "bolt"), TOP, "cover")
    assert entry(program, "ring").of == ("bolt.{k}",)
    assert entry(program, "gap").features == ("bolt.{k}", "bolt.{k+1}")
    assert [point.feature for point in entry(program, "r").alignment.points] == ["bolt.1", "bolt.2", "cover"]
    assert entry(program, "mid").of == ("cover", "base") and entry(program, "height").features == ("cover", "base")


def test_a_name_in_use_or_empty_is_refused():
    with pytest.raises(InputError, match="already"):
        rename(program_of(), TOP, "base")
    with pytest.raises(InputError, match="needs a name"):
        rename(program_of(), TOP, "  ")


def test_a_name_that_is_shown_like_another_is_refused_and_never_proposed():
    program = rename(program_of(), HEIGHT, "blade_height")
    with pytest.raises(InputError, match="already"):
        rename(program, Node("dimension", "diameter"), "Blade height")
    assert unique_name(program, "dimension", "blade height") == "blade height 2"
    assert entry(rename(program, Node("dimension", "blade_height"), "blade height"), "blade height").kind == "distance"


def test_a_distance_of_a_feature_to_itself_is_refused():
    twice = {"name": "none", "kind": "distance", "features": ["top", "top"], "nominal": 0}
    with pytest.raises(InputError, match="two different features"):
        add(program_of(), "dimension", twice)
    around = {**twice, "features": ["hole.{k}", "hole.{k+4}"], "count": 4}
    with pytest.raises(InputError, match="two different features"):
        add(add(program_of(), "feature", PATTERN), "dimension", around)


def test_a_feature_and_a_dimension_may_have_one_name():
    program = rename(program_of(), HEIGHT, "top")
    program = rename(program, TOP, "cover")
    assert entry(program, "top").features == ("cover", "base")


def test_a_linked_nominal_follows_its_features_until_one_is_typed():
    program = link_nominal(set_nominal(program_of(), "height", 29.0), "height")
    assert entry(program, "height").nominal == 30.0
    program = change(program, TOP, {"point_mm": [0, 0, 31.5]})
    assert entry(program, "height").nominal == 31.5
    program = change(set_nominal(program, "height", 40.0), TOP, {"point_mm": [0, 0, 33.0]})
    assert entry(program, "height").nominal == 40.0 and not entry(program, "height").nominal_linked


def test_the_limits_of_a_standard_tolerance_follow_the_nominal():
    program = set_tolerance(program_of(), "height", "2768-m")
    assert entry(program, "height").limits == (-0.2, 0.2)
    assert entry(set_nominal(program, "height", 31.0), "height").limits == (-0.3, 0.3)
    with pytest.raises(InputError, match="500 mm"):
        set_nominal(set_tolerance(program_of(), "height", "H7"), "height", 600.0)


def test_a_nominal_that_follows_from_nothing_is_refused():
    with pytest.raises(InspectionError, match="does not follow"):
        link_nominal(program_of(), "position")


def test_a_tolerance_that_is_none_changes_nothing():
    with pytest.raises(InputError, match="not a tolerance"):
        set_tolerance(program_of(), "height", "tight")
    assert not entry(set_tolerance(program_of(), "height", ""), "height").is_toleranced


def test_a_parent_is_removed_only_with_its_children():
    with pytest.raises(InputError, match="mid, height"):
        remove(program_of(), [TOP])
    program = remove(program_of(), [TOP], with_children=True)
    assert {one.name for one in program.features} == {"base", "side", "bore"}
    assert {one.name for one in program.dimensions} == {"diameter", "position"}


def test_what_the_alignment_uses_stays():
    with pytest.raises(InputError, match="alignment"):
        remove(set_alignment(program_of(), "datums:base,bore"), [Node("feature", "bore")], with_children=True)


def test_duplicates_get_the_next_free_number():
    program, name = duplicate(program_of(), HEIGHT)
    assert name == "height 2" and [one.name for one in program.dimensions][:2] == ["height", "height 2"]
    _, name = duplicate(program, Node("dimension", "height 2"))
    assert name == "height 3" and unique_name(program, "feature", "new") == "new"


def test_entries_move_as_long_as_parents_stay_above():
    program = move(program_of(), HEIGHT, 99)
    assert program.dimensions[-1].name == "height"
    with pytest.raises(InputError, match="not defined before"):
        move(program_of(), MID, -9)


def test_groups_are_headings_of_dimensions():
    program = set_group(program_of(), ["height", "diameter"], "Fit")
    assert entry(program, "height").group == "Fit" and entry(set_group(program, ["height"], ""), "height").group == ""


def test_unknown_entries_and_values_are_named():
    with pytest.raises(InputError, match="no feature 'lid'"):
        change(program_of(), Node("feature", "lid"), {"hole": True})
    with pytest.raises(InputError, match="colour"):
        change(program_of(), TOP, {"colour": "red"})


def test_no_edit_changes_the_program_it_is_given():
    program = program_of()
    before = program.model_dump_json()
    remove(rename(set_tolerance(program, "height", "H7"), TOP, "lid"), [Node("feature", "lid")], with_children=True)
    assert program.model_dump_json() == before
