"""Datum letters belong to the program: a letter names one feature, whatever dimension refers to it."""

import pytest
from inspection.session.machined import machined_part, program_of

from measureapp.data.control_frame import with_frames
from measureapp.data.datum_letters import letters_of
from measureapp.errors import InputError
from measureapp.inspection.programming.edits import add, move, remove, rename, set_alignment, set_datum_letter
from measureapp.inspection.session.graph import Node
from measureapp.inspection.session.session import InspectionSession
from measureapp.project.program_file import parse_program
from measureapp.project.program_rewrite import format_program, rewrite_program
from measureapp.resources import resource

SIDE_TO_TOP = {"name": "square", "kind": "perpendicularity", "features": ["side"], "datums": ["top"], "upper_tolerance": 0.1}
PLACE = {"name": "place", "kind": "position", "features": ["bore"], "datums": ["top", "side"], "upper_tolerance": 0.2}


def program(**changes):
    """Return a program whose dimensions have the datums base, top, and top with side."""
    return program_of(extra_dimensions=[SIDE_TO_TOP, PLACE], **changes)


@pytest.fixture(scope="module")
def session():
    return InspectionSession(machined_part(), None)


def cells(measured):
    return {one.name: one.frame.datums for one in measured.inspection.dimensions if one.frame is not None}


def test_a_letter_names_one_feature_in_all_frames_of_a_result(session):
    found = session.measure(program())
    assert cells(found) == {"position": ("A",), "square": ("B",), "place": ("B", "C")}
    named = {}
    for one in found.inspection.dimensions:
        for letter, feature in zip(one.datum_letters, one.datums, strict=True):
            assert named.setdefault(letter, feature) == feature
    assert named == {"A": "base", "B": "top", "C": "side"}


def test_a_program_without_letters_gets_them_in_the_order_of_first_use_its_alignment_first():
    assert letters_of(program()) == {"base": "A", "top": "B", "side": "C"}
    aligned = set_alignment(program_of(), "datums:side,base,bore")
    assert letters_of(aligned) == {"side": "B", "base": "A", "bore": "C"}  # base had its letter before
    assert letters_of(program(alignment={"method": "datums", "datums": ["side", "base", "bore"]})) == {
        "side": "A",
        "base": "B",
        "bore": "C",
        "top": "D",
    }


def test_letters_outlive_edits_and_are_part_of_the_saved_text():
    before = format_program(program())
    assert "datum_letters" not in before
    edited = move(program(), Node("dimension", "position"), 5)  # its datum is now used last
    assert letters_of(edited) == {"base": "A", "top": "B", "side": "C"}
    text = rewrite_program(before, edited)
    assert 'datum_letters = { A = "base", B = "top", C = "side" }' in text
    assert letters_of(parse_program(text)) == letters_of(edited)
    gone = remove(edited, [Node("dimension", "square"), Node("dimension", "place")])
    again = add(gone, "dimension", {**SIDE_TO_TOP, "datums": ["bore"]})
    assert letters_of(again) == {"base": "A", "top": "B", "side": "C", "bore": "D"}


def test_letters_follow_names_and_go_with_their_features():
    renamed = rename(program(), Node("feature", "top"), "upper face")
    assert letters_of(renamed)["upper face"] == "B"
    gone = remove(renamed, [Node("feature", "upper face")], with_children=True)
    assert letters_of(gone) == {"base": "A", "side": "C"}


def test_a_letter_is_changed_by_hand_and_a_taken_one_changes_places(session):
    swapped = set_datum_letter(program(), "side", "A")
    assert letters_of(swapped) == {"side": "A", "top": "B", "base": "C"}
    assert cells(session.measure(swapped))["place"] == ("B", "A")
    assert not session.measure(set_datum_letter(swapped, "top", "F")).measured  # letters cost no measurement
    given = set_datum_letter(program(), "bore", "A")
    assert letters_of(given) == {"bore": "A", "top": "B", "side": "C", "base": "D"}
    assert "bore" not in letters_of(set_datum_letter(given, "bore", ""))
    with pytest.raises(InputError, match="used as a datum"):
        set_datum_letter(program(), "top", "")
    with pytest.raises(InputError, match="not a datum letter"):
        set_datum_letter(program(), "top", "b1")


@pytest.mark.parametrize(
    ("letters", "message"),
    [({"A": "nothing"}, "not defined"), ({"A": "top", "B": "top"}, "two datum letters"), ({"a": "top"}, "not a datum letter")],
)
def test_letters_that_name_nothing_or_one_feature_twice_are_refused(letters, message):
    with pytest.raises(ValueError, match=message):
        program(datum_letters=letters)


def test_results_that_were_stored_with_other_letters_get_those_of_the_program(session):
    found = session.measure(program()).inspection
    swapped = set_datum_letter(program(), "side", "B")
    shown = {one.name: one for one in with_frames(found.dimensions, swapped, found.features)}
    assert shown["place"].datum_letters == shown["place"].frame.datums == ("C", "B")
    assert shown["square"].frame.datums == ("C",)


def test_copies_with_datums_of_their_own_have_no_letters_in_common():
    bosses = [
        {"name": "post", "shape": "cylinder", "point_mm": [50, 0, 15], "direction": [0, 0, 1], "radius_mm": 8, "repeat": {"count": 2}},
        {"name": "cap", "shape": "plane", "point_mm": [50, 0, 30], "direction": [0, 0, 1], "repeat": {"count": 2}},
    ]
    entry = {"name": "lean", "kind": "perpendicularity", "features": ["post.{k}"], "datums": ["cap.{k}"], "count": 2, "statistic": "max"}
    own = program_of(extra_features=bosses, extra_dimensions=[{**entry, "upper_tolerance": 0.1}])
    assert letters_of(own) == {"base": "A"}


def test_the_sample_gear_states_its_letters():
    gear = parse_program(resource("parts/gear/tolerances.toml").read_text(encoding="utf-8"))
    assert dict(gear.datum_letters) == {"A": "gear face", "B": "bore"}
