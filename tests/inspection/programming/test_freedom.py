import numpy as np
import pytest
from inspection.session.machined import UP, machined_part, program_of
from pydantic import ValidationError

from measureapp.data.alignment_program import BestFit, ByCoordinates, ReferencePoint, ReferencePoints, ThreeTwoOne
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.programming.freedom import alignment_freedom, datums_freedom, points_freedom, three_two_one_freedom

POINT = {"name": "p", "shape": "surface_point", "point_mm": [10, 10, 30], "direction": UP}


def test_the_degrees_of_freedom_grow_with_every_datum():
    program = program_of()
    freedoms = [datums_freedom(program, ["base", "bore", "top"][:count]) for count in (1, 2, 3)]
    assert [one.fixed for one in freedoms] == [3, 5, 5]
    assert [step.fixed for step in freedoms[2].steps] == [3, 2, 0] and "constrains nothing" in freedoms[2].steps[2].problem
    assert set(freedoms[0].free) == {"translation along x", "translation along y", "rotation about z"}
    assert freedoms[1].motions.shape == (6, 1)


def test_reference_points_fix_along_their_locked_axes_only():
    program = program_of(extra_features=[POINT])
    locked = [ReferencePoint(feature="mid", lock="z"), ReferencePoint(feature="p"), ReferencePoint(feature="bore", lock="xy")]
    found = points_freedom(program, locked)
    assert [step.fixed for step in found.steps] == [1, 1, 2] and found.fixed == 4
    refused = points_freedom(program, [ReferencePoint(feature="bore")])
    assert "lock" in refused.steps[0].problem and refused.fixed == 0


def test_redundant_reference_points_take_part_in_the_least_squares():
    points = [ReferencePoint(feature=name, lock="z") for name in ("top", "top", "side")]
    steps = points_freedom(program_of(), points).steps
    assert steps[1].fixed == 0 and "least squares" in steps[1].problem


def test_a_whole_alignment_states_its_freedom():
    program = program_of(extra_features=[POINT])
    three = alignment_freedom(program, ThreeTwoOne(plane="base", line="side", point="p"))
    assert [step.fixed for step in three.steps] == [3, 2, 0]
    assert alignment_freedom(program, BestFit()).fixed == 6 and alignment_freedom(program, ByCoordinates()).free == ()
    points = tuple(ReferencePoint(feature="top", lock=axis) for axis in "xyz")
    assert alignment_freedom(program, ReferencePoints(points=points)).fixed == 3


def test_elements_that_the_alignment_would_refuse_are_refused_at_once():
    program = program_of(extra_features=[POINT])
    point = datums_freedom(program, ["base", "p"])
    assert point.steps[1].refused and "must be a plane" in point.steps[1].problem and point.fixed == 3
    bore_first = three_two_one_freedom(program, ["bore", "base"])
    assert bore_first.steps[0].refused and "needs a plane there" in bore_first.steps[0].problem
    clocked = three_two_one_freedom(program, ["base", "bore", "p"])  # a surface point stops no rotation
    assert [step.refused for step in clocked.steps] == [False, False, True] and "do not fix" in clocked.steps[2].problem
    assert not any(step.refused for step in three_two_one_freedom(program, ["base", "side", "p"]).steps[:2])


def test_a_lock_names_each_axis_once():
    for lock in ("xx", "w", "xyzx"):
        with pytest.raises(ValidationError):
            ReferencePoint(feature="a", lock=lock)
    with pytest.raises(ValidationError, match="remove one"):
        ReferencePoint(feature="a", lock="x", along=((0, 0, 1),))


def test_an_alignment_by_coordinates_moves_the_part_as_stated():
    alignment = {"method": "coordinates", "rotation_deg": [0, 0, 90], "translation_mm": [1, 2, 3]}
    found = inspect(machined_part(), program_of(alignment=alignment)).alignment
    assert found.nominal_from_part.apply(np.array([[1.0, 0, 0]]))[0] == pytest.approx([1, 3, 3])
    assert found.method == "coordinates" and not found.for_comparison_only


@pytest.mark.parametrize("draws", [12, pytest.param(30, marks=pytest.mark.slow)])
def test_the_stated_weakest_direction_is_that_of_repeated_measurements(draws):
    stated, placed = [], []
    from inspection.machined_part import Part

    for seed in range(draws):
        part = Part(np.random.default_rng(seed), 0.05)
        part.square([0, 0, 0], [0, 0, -1], [1, 0, 0], half_mm=6, count=300)
        part.square([30, 0, 15], [1, 0, 0], [0, 1, 0], half_mm=14, count=3000)
        part.round([50, 0, 15], 8.0, length_mm=28, hole=True, count=3000)
        alignment = inspect(part.at_its_place(), program_of(alignment="datums:base,side")).alignment
        stated.append(alignment.weakest_mm)
        placed.append(alignment.nominal_from_part.apply(np.array([[58.0, 14, 29]]))[0] - [58, 14, 29])
    assert alignment.fixed == 5 and abs(alignment.weakest_direction[2]) > 0.7  # the small base lets the far end rise and fall
    assert np.median(stated) >= 2 * np.std(placed, axis=0)[2] * 0.6
    assert np.median(stated) <= 2 * np.std(placed, axis=0).max() * 3
