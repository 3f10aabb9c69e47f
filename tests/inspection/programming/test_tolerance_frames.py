"""A tolerance chosen by its frame: what is allowed is what is evaluated, all else is refused in a sentence."""

from dataclasses import replace

import numpy as np
import pytest
from inspection.machined_part import Part
from inspection.session.machined import machined_part, program_of

from measureapp.data.control_frame import CHARACTERISTICS
from measureapp.data.datum_letters import letters_of
from measureapp.data.dimension_program import FORMS, DimensionProgram
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import InspectionProgram, MeasuredFeature
from measureapp.errors import InputError, InspectionError
from measureapp.inspection.evaluate import evaluate_dimension
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.programming import edits
from measureapp.inspection.programming.nominals import nominals_of
from measureapp.inspection.programming.tolerance_frames import (
    TOLERANCED,
    ToleranceChoice,
    first_choice,
    frame_of,
    refusal,
    takes_datums,
    with_tolerance,
)
from measureapp.inspection.session.session import InspectionSession
from measureapp.inspection.settings import InspectionSettings

FLAT = ToleranceChoice("flatness", "top", 0.05)
PLACE = ToleranceChoice("position", "bore", 0.2, ("base", "side"))
EDGE = {"name": "front", "shape": "plane", "point_mm": [0, 30, 15], "direction": [0, 1, 0]}


def why(choice, former="", **changes):
    program = program_of(extra_features=[EDGE], **changes)
    return refusal(program, choice, nominals_of(program), former)


@pytest.mark.parametrize(
    ("choice", "sentence"),
    [
        (replace(FLAT, datums=("base",)), "A flatness has no datums"),
        (replace(FLAT, feature="bore"), "bore is a cylinder: flatness is defined for a plane."),
        (replace(PLACE, datums=()), "A position needs a datum."),
        (replace(PLACE, datums=("base",)), "do not fix the location of bore"),
        (replace(PLACE, datums=("base", "base")), "Two datums are the same feature."),
        (replace(PLACE, datums=("base", "bore")), "cannot be the datum of its own tolerance"),
        (replace(PLACE, datums=("base", "top", "side")), "Datum top constrains nothing beyond base"),
        (replace(PLACE, width_mm=0.0), "greater than 0"),
        (replace(PLACE, feature=""), "Choose the toleranced feature."),
        (replace(PLACE, datums=("base", "side", "front"), condition="maximum"), "needs the limits of the diameter"),
        (ToleranceChoice("coaxiality", "bore", 0.1, ("base",)), "base is a plane, which cannot be a datum for coaxiality"),
        (ToleranceChoice("total_runout", "base", 0.1, ("bore", "side")), "A total runout has one datum."),
        (ToleranceChoice("parallelism", "side", 0.1, ("base",)), "side is 90° from parallelism to base"),
        (ToleranceChoice("straightness", "top", 0.1), "needs the direction of its lines"),
        (ToleranceChoice("line_profile", "top", 0.1, ("base",)), "needs a section plane"),
    ],
)
def test_what_is_not_allowed_is_refused_in_one_sentence(choice, sentence):
    found = why(choice)
    assert sentence in found and found.endswith(".")


@pytest.mark.parametrize(
    "choice",
    [
        FLAT,
        replace(PLACE, datums=("base", "side", "front")),
        ToleranceChoice("perpendicularity", "bore", 0.1, ("base",)),
        ToleranceChoice("parallelism", "top", 0.1, ("base",)),
        ToleranceChoice("surface_profile", "top", 0.1, ("base",), zone_offset_mm=0.02),
        ToleranceChoice("cylindricity", "bore", 0.1),
    ],
)
def test_what_is_allowed_is_measured(choice):
    program = program_of(extra_features=[EDGE])
    assert why(choice) == ""
    changed, name = with_tolerance(program, choice)
    stated = next(one for one in changed.dimensions if one.name == name)
    assert ToleranceChoice.of(stated) == choice
    if "front" not in choice.datums:  # the part has no such face
        found = InspectionSession(machined_part(), None).measure(changed).inspection.dimensions[-1]
        assert found.name == name and found.measured is not None, found.reason


@pytest.mark.parametrize("kind", [kind for kind in CHARACTERISTICS if kind not in ("line_profile",)])
def test_the_shapes_that_are_offered_are_those_that_are_evaluated(kind):
    up = np.array([0.0, 0.0, 1.0])
    axis = Feature("axis", "cylinder", np.zeros(3), up, 5.0)
    datums = () if not takes_datums(kind) else (FoundFeature("axis", axis, nominal=axis),)
    described = DimensionProgram(name="it", kind=kind, features=("one",), datums=tuple(one.name for one in datums), upper_tolerance=0.1)
    for shape in ("plane", "cylinder", "cone", "line", "circle", "sphere", "point", "slot", "torus"):
        feature = Feature("one", shape, np.zeros(3), up, 5.0, half_angle_rad=0.3, normal=np.array([1.0, 0.0, 0.0]))
        points = np.random.default_rng(1).normal(0, 5, (200, 3))
        found = FoundFeature("one", feature, points_mm=points, nominal=feature)
        try:
            evaluate_dimension(described, (found,), datums, InspectionSettings())
            message = ""
        except (InspectionError, ArithmeticError, ValueError) as error:
            message = str(error)
        assert message or shape in TOLERANCED[kind], shape
        undefined = any(words in message for words in ("is defined for", "has no nominal surface", "requires a measured", "no distances"))
        assert not (undefined and shape in TOLERANCED[kind]), (shape, message)


def test_an_edited_tolerance_keeps_its_name_and_loses_what_its_kind_has_not():
    material = {"material_condition": "maximum", "size_limits_mm": (15.9, 16.1)}
    loose = {"datum_material": [{"datum": "base", "condition": "maximum", "size_limits_mm": (1.0, 2.0)}]}
    entry = {
        "name": "place",
        "kind": "position",
        "features": ["bore"],
        "datums": ["base", "side"],
        "tolerance": "max 0.2",
        **material,
        **loose,
    }
    program = program_of(extra_dimensions=[{**entry, "group": "holes"}])
    choice = ToleranceChoice("perpendicularity", "bore", 0.15, ("base",))
    changed, name = with_tolerance(program, choice, "place")
    assert name == "place"
    (now,) = [one for one in changed.dimensions if one.name == "place"]
    assert ToleranceChoice.of(now) == choice and now.group == "holes" and now.tolerance is None and now.datum_material == ()
    kept, _ = with_tolerance(program, replace(ToleranceChoice.of(program.dimensions[-1]), width_mm=0.3), "place")
    assert kept.dimensions[-1].datum_material == program.dimensions[-1].datum_material
    with pytest.raises(InputError, match="no datums"):
        with_tolerance(program, replace(choice, kind=FORMS[0]), "place")


def test_the_frame_shows_the_letters_that_the_program_will_give():
    program = program_of()  # base is A
    frame = frame_of(program, replace(PLACE, datums=("side", "base"), condition="maximum"), {"bore": "cylinder"})
    assert frame.datums == ("B", "A") and frame.diameter == "Ø" and frame.modifiers == ("\u24c2",)
    changed, _ = with_tolerance(program, replace(PLACE, datums=("side", "base")))
    assert changed.datum_letters == {"A": "base", "B": "side"}
    assert all(isinstance(one, MeasuredFeature) for one in changed.features[:4])


def shaft():
    """Return two bearing seats and a part of the shaft between them, 0.03 mm off their axis, with its program."""
    part = Part(np.random.default_rng(3), 0.005)
    seats = {"left": 0.0, "middle": 60.0, "right": 120.0}
    for name, height in seats.items():
        part.round([0.03 if name == "middle" else 0.0, 0, height], 8.0, length_mm=20, hole=False, count=4000)
    features = [
        {"name": name, "shape": "cylinder", "point_mm": [0, 0, height], "direction": [0, 0, 1], "radius_mm": 8}
        for name, height in seats.items()
    ]
    return part.at_its_place(), InspectionProgram.model_validate({"name": "shaft", "alignment": "none", "features": features})


def test_a_common_datum_is_chosen_by_its_two_features_and_has_both_letters():
    cloud, program = shaft()
    choice = ToleranceChoice("coaxiality", "middle", 0.1, ("left",), partners=("right",))
    assert refusal(program, choice, nominals_of(program)) == ""
    assert frame_of(program, choice, {"middle": "cylinder"}).datums == ("A-B",)
    changed, _ = with_tolerance(program, choice)
    assert letters_of(changed) == {"left": "A", "right": "B", "left and right": "A-B"}
    assert changed.datum_letters == {"A": "left", "B": "right"}
    found = InspectionSession(cloud, None).measure(changed).inspection.dimensions[-1]
    assert found.frame.datums == ("A-B",) and found.datum_letters == ("A-B",)
    assert found.measured == pytest.approx(0.06, abs=found.uncertainty)
    again, _ = with_tolerance(changed, replace(choice, kind="total_runout", partners=("left",), datums=("right",)))
    assert [one.name for one in again.features] == ["left", "middle", "right", "left and right"]  # one common datum, whichever comes first
    lettered = edits.set_datum_letter(again, "left", "D")
    assert letters_of(lettered)["left and right"] == "D-B"
    with pytest.raises(InputError, match="has the letters of its features"):
        edits.set_datum_letter(again, "left and right", "C")


@pytest.mark.parametrize(
    ("feature", "datum", "partner", "sentence"),
    [
        ("middle", "left", "left", "Two datums are the same feature."),
        ("middle", "left", "middle", "middle cannot be the datum of its own tolerance."),
    ],
)
def test_features_that_are_no_common_datum_are_refused(feature, datum, partner, sentence):
    _, program = shaft()
    assert refusal(program, ToleranceChoice("coaxiality", feature, 0.1, (datum,), partners=(partner,)), nominals_of(program)) == sentence


def test_faces_in_different_planes_are_no_common_datum():
    found = why(ToleranceChoice("parallelism", "mid", 0.1, ("top",), partners=("base",)))
    assert "top and base are 30.000 mm from one plane: they cannot be one datum." in found


CIRCLE = {"name": "hole", "shape": "circle", "point_mm": [10, 5, 15], "direction": [0, 0, 1], "radius_mm": 4, "hole": True}
FLATNESS = {"name": "flat", "kind": "flatness", "features": ["top"], "upper_tolerance": 0.1}
LOCATION = {"name": "place", "kind": "position", "features": ["bore"], "datums": ["base", "side", "front"], "upper_tolerance": 0.2}


@pytest.mark.parametrize(
    ("feature", "datums", "dimensions", "kind", "chosen"),
    [
        ("top", (), [], "flatness", ()),
        ("top", (), [FLATNESS], "parallelism", ("base",)),  # the program has a datum; flatness is stated already
        ("hole", (), [], "roundness", ()),  # one datum does not fix the location
        ("hole", (), [LOCATION], "position", ("base", "side", "front")),
        ("bore", (), [LOCATION], "cylindricity", ()),  # position and perpendicularity are stated already
        ("hole", ("base", "side", "front"), [], "position", ("base", "side", "front")),
        ("side", ("base",), [], "perpendicularity", ("base",)),
    ],
)
def test_a_new_tolerance_begins_with_what_suits_the_feature_and_is_not_stated_yet(feature, datums, dimensions, kind, chosen):
    program = program_of(extra_features=[EDGE, CIRCLE], extra_dimensions=dimensions)
    choice = first_choice(program, feature, datums, 0.1, nominals_of(program))
    assert (choice.kind, choice.datums) == (kind, chosen)
    assert not refusal(program, choice, nominals_of(program))
