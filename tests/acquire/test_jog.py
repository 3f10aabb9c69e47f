"""Single axes are moved by hand in small steps, and cameras are shown live."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from acquire.fake_rig import Cell, fake_rig, released

from measureapp.acquire.events import ImageTaken
from measureapp.acquire.jog import find_references, jog, show_live
from measureapp.data.rig import KeepOutBox, MotionRules
from measureapp.errors import DeviceLost, LimitError, PlanError
from measureapp.progress import NoProgress


@pytest.fixture
def cell():
    return Cell()


@pytest.fixture
def rig(cell):
    """A rig without the model of an arm: at the origin of the base, where its flange begins, an arm would touch itself in one of two ways."""
    with released(fake_rig(cell)) as made:
        robot = made.description.robot.model_copy(update={"model_file": ""})
        yield replace(made, description=made.description.model_copy(update={"robot": robot}))


@pytest.mark.parametrize(("axis", "column"), [("x", 0), ("y", 1), ("z", 2)])
def test_the_flange_moves_along_an_axis_of_the_base_and_keeps_its_direction(rig, axis, column):
    at = jog(rig, axis, -12.5, NoProgress()).base_from_flange
    expected = np.zeros(3)
    expected[column] = -12.5
    np.testing.assert_allclose(at.translation_mm, expected)
    np.testing.assert_allclose(at.rotation, np.eye(3))


def test_the_flange_turns_about_itself(rig):
    jog(rig, "x", 40.0, NoProgress())
    at = jog(rig, "rz", 5.0, NoProgress()).base_from_flange
    assert at.angle_rad == pytest.approx(np.radians(5.0))
    np.testing.assert_allclose(at.translation_mm, [40.0, 0.0, 0.0])


def test_guide_and_table_move_by_steps_from_where_they_are(rig, cell):
    cell.guide_mm = 100.0
    assert jog(rig, "guide", -20.0, NoProgress()).guide_mm == 80.0
    assert jog(rig, "table", 9.0, NoProgress()).table_rad == pytest.approx(np.radians(9.0))


@pytest.mark.parametrize(("axis", "step"), [("x", 51.0), ("guide", -60.0), ("table", 11.0), ("rz", float("nan"))])
def test_a_step_too_large_for_a_hand_is_refused_and_nothing_moves(rig, cell, axis, step):
    with pytest.raises(LimitError, match="by hand is too large"):
        jog(rig, axis, step, NoProgress())
    assert cell.moves == 0


def test_a_step_into_a_keep_out_box_is_refused_and_one_out_of_it_is_not(rig, cell):
    here = jog(rig, "guide", 0.0, NoProgress())
    low, high = np.array([280.0, -100.0, -100.0]), np.array([340.0, 100.0, 100.0])  # the head reaches 255 mm from the flange's axis
    at = here.base_from_flange.translation_mm + np.array([0.0, here.guide_mm, 0.0])
    box = KeepOutBox(name="pillar", low_mm=tuple(at + low), high_mm=tuple(at + high))
    fenced = replace(rig, description=rig.description.model_copy(update={"motion": MotionRules(keep_out=(box,))}))
    jog(fenced, "x", 15.0, NoProgress())
    moves = cell.moves
    with pytest.raises(PlanError, match="would enter the keep-out box pillar"):
        jog(fenced, "x", 20.0, NoProgress())
    assert (cell.moves, fenced.latch.reason) == (moves, "")
    jog(rig, "x", 20.0, NoProgress())
    jog(fenced, "x", -20.0, NoProgress())


def test_a_device_that_fails_while_jogging_stops_everything(rig, cell):
    cell.fault = lambda name, call: "lost" if name == "guide" else ""
    with pytest.raises(DeviceLost):
        jog(rig, "guide", 1.0, NoProgress())
    assert rig.latch.reason
    assert rig.robot.stops == 1


def test_references_are_found_one_after_the_other(rig):
    found = []
    rig.table.home = lambda *, timeout_s: found.append("table")
    rig.guide.home = lambda *, timeout_s: found.append("guide")
    find_references(rig, NoProgress())
    assert found == ["table", "guide"]


def test_live_images_come_from_all_cameras_until_they_are_not_wanted_any_more(rig, cell):
    events = []
    show_live(rig, lambda: 20_000, lambda: len(events) < 6, events.append, NoProgress())
    assert [event.camera for event in events] == ["left", "right"] * 3
    assert all(isinstance(event, ImageTaken) for event in events)
    assert not rig.latch.reason
    assert cell.shown == -2
