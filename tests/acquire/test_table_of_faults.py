"""Rows of the table of faults that only the engine can answer, each injected into a rig of fakes with real fringes."""

from __future__ import annotations

from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from math import radians

import pytest
from acquire.fake_rig import Cell, Truthful, drawn, fake_plan, fake_rig, released
from acquire.test_engine import once, run, stopped

from measureapp.acquire import run as engine_run
from measureapp.acquire import session
from measureapp.acquire.engine import Engine
from measureapp.acquire.events import ViewpointFailed, ViewpointRetaken, ViewpointStored
from measureapp.acquire.tasks.fringes import FringeTask
from measureapp.devices.camera import StreamStatistics
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, DeviceLost, MotionError
from measureapp.progress import NoProgress

IMAGES = fake_plan().patterns.count
ONE_EXPOSURE = (60_000,)


@pytest.fixture
def cell():
    return Cell()


@pytest.fixture
def rig(cell):
    with released(fake_rig(cell)) as made:
        yield made


def reasons(events, kind=ViewpointFailed):
    return {event.viewpoint_id: event.reason for event in events if isinstance(event, kind)}


def stored(sink):
    return [stack.viewpoint_id for stack in sink.stacks]


def test_d1_an_image_that_stays_damaged_is_projected_four_times_in_all(rig, cell):
    shown = []
    show = rig.projector.show
    rig.projector.show = lambda index, *, timeout_s: shown.append(index) or show(index, timeout_s=timeout_s)
    cell.fault = lambda name, call: "failed" if name == "left" and cell.shown == 5 else ""
    events = run(rig, fake_plan(1, ONE_EXPOSURE), sink := Truthful(cell))
    assert "taken again 3 times in vain" in reasons(events)["v0"]
    first_try = shown[: shown.index(-2, 1)]  # the next one begins in the dark, too
    assert first_try.count(5) == 1 + 3
    assert not sink.stacks


def test_d2_many_packets_sent_again_are_told_at_the_end_of_a_scan(rig, cell):
    rig.cameras["left"].statistics = lambda: StreamStatistics(108, 0, resent_packets=40, lost_packets=0, packets=20_000)
    rig.cameras["right"].statistics = lambda: StreamStatistics(108, 0, resent_packets=19, lost_packets=0, packets=20_000)
    ended = run(rig, fake_plan(), Truthful(cell))[-1]
    assert (ended.reason, ended.message) == (
        "done",
        "Camera left: 0.20% of the packets were sent again: check cable, switch and packet delay.",
    )


def test_d2_a_camera_that_cannot_tell_its_packets_spoils_no_scan(rig, cell):
    def fail():
        raise DeviceLost("gone.", "Connect it.")

    rig.cameras["left"].statistics = fail
    ended = run(rig, fake_plan(1), sink := Truthful(cell))[-1]
    assert (ended.reason, ended.message, stored(sink)) == ("done", "", ["v0"])


def test_d3_after_a_pulled_cable_the_whole_view_is_discarded_and_taken_again_by_a_new_connection(rig, cell):
    first_of_v1 = 3 * IMAGES
    faults = {first_of_v1 + 5: "no rows", first_of_v1 + 6: "lost"}
    cell.fault = lambda name, call: faults.get(call, "") if name == "left" else ""
    plan, sink = fake_plan(), Truthful(cell)
    with pytest.raises(DeviceLost, match="left is gone"):
        run(rig, plan, sink)
    assert stopped(rig)
    assert (stored(sink), sink.dropped) == (["v0"], ["v1"])
    cell.fault = lambda name, call: ""
    rest = plan.model_copy(update={"viewpoints": plan.viewpoints[1:]})
    with released(fake_rig(cell)) as connected_again:
        run(connected_again, rest, sink)
    assert stored(sink) == ["v0", "v1", "v2"]


def test_d3_an_image_without_rows_alone_is_taken_again(rig, cell):
    cell.fault = once("left", 5, "no rows")
    events = run(rig, fake_plan(), sink := Truthful(cell))
    assert not reasons(events, ViewpointRetaken)
    assert len(sink.stacks) == 3


def test_d6_images_that_arrive_under_each_other_s_camera_are_refused_by_their_serial_numbers(rig, cell):
    left, right = rig.cameras["left"], rig.cameras["right"]
    left.next_frame, right.next_frame = right.next_frame, left.next_frame
    events = run(rig, fake_plan(1), sink := Truthful(cell))
    assert "Camera left: the image is from camera 1, not 0" in reasons(events)["v0"]
    assert not sink.stacks


@pytest.mark.parametrize("exposures_us", [(100_000, 50_000, 25_000), ONE_EXPOSURE])
@pytest.mark.parametrize("begins", [1, 3, 6, IMAGES, IMAGES + 2])
def test_d9_a_projector_that_stays_late_by_one_pattern_never_gives_a_stack(rig, cell, exposures_us, begins):
    """From the first image, from the middle, from the last one, and from the next viewpoint (or exposure) on."""
    count = before = 0

    def show(index, *, timeout_s):
        nonlocal count, before
        count += 1
        cell.shown, before = (index if count < begins + 1 else before), index

    rig.projector.show = show
    events = run(rig, fake_plan(2, exposures_us), sink := Truthful(cell))
    assert stored(sink) == (["v0"] if begins > IMAGES and exposures_us == ONE_EXPOSURE else [])
    assert "v1" in reasons(events)


def dimmed(cell: Cell, factor: float, when: Callable[[int, int], bool]) -> None:
    """Let the lamp be dimmer at viewpoint v1, for the exposures and patterns given."""
    genuine = cell.mean

    def mean(camera, exposure_us, pattern):
        return genuine(camera, exposure_us, pattern) * (factor if cell.guide_mm == 10.0 and when(exposure_us, pattern) else 1.0)

    cell.mean = mean


@pytest.mark.parametrize("factor", [0.0, 0.8])
@pytest.mark.parametrize(
    ("exposures_us", "when"),
    [
        ((100_000, 50_000, 25_000), lambda exposure_us, pattern: exposure_us == 50_000),
        ((100_000, 50_000, 25_000), lambda exposure_us, pattern: exposure_us < 100_000 and pattern >= 5),
        (ONE_EXPOSURE, lambda exposure_us, pattern: pattern >= 5),
        (ONE_EXPOSURE, lambda exposure_us, pattern: pattern >= 9),
        (ONE_EXPOSURE, lambda exposure_us, pattern: 4 <= pattern < 6),
    ],
    ids=["a whole exposure", "from one image on", "one exposure, half of it", "one exposure, its last group", "one exposure, two images"],
)
def test_d10_a_lamp_that_changes_within_a_view_fails_it_with_the_cause(rig, cell, factor, exposures_us, when):
    dimmed(cell, factor, when)
    events = run(rig, fake_plan(3, exposures_us), sink := Truthful(cell))
    assert stored(sink) == ["v0", "v2"]
    assert "lamp" in reasons(events)["v1"] or "projector" in reasons(events)["v1"]


@pytest.mark.parametrize("exposures_us", [(100_000, 50_000, 25_000), ONE_EXPOSURE])
def test_d10_a_lamp_that_is_out_for_a_whole_view_fails_it_with_the_cause(rig, cell, exposures_us):
    dimmed(cell, 0.0, lambda exposure_us, pattern: True)
    events = run(rig, fake_plan(3, exposures_us), sink := Truthful(cell))
    assert stored(sink) == ["v0", "v2"]
    assert "no camera sees fringes: the projector was dark" in reasons(events)["v1"]


@pytest.mark.parametrize("exposures_us", [(100_000, 50_000, 25_000), ONE_EXPOSURE])
def test_d10_a_lamp_that_is_a_fifth_dimmer_for_a_whole_view_is_not_noticed(rig, cell, exposures_us):
    """The phase does not depend on the brightness: such a view is right, with more noise, and the decoded modulation says how much."""
    dimmed(cell, 0.8, lambda exposure_us, pattern: True)
    run(rig, fake_plan(3, exposures_us), sink := Truthful(cell))
    assert stored(sink) == ["v0", "v1", "v2"]


@pytest.mark.parametrize(("off_deg", "is_used"), [(0.02, True), (0.06, False)])
def test_m6_the_angle_read_back_is_stored_within_the_limit_and_never_the_nominal_one(rig: Rig, cell, off_deg, is_used):
    rig.table.step = lambda at: at + radians(off_deg)
    cell.fault = lambda name, call: "off" if name == "table" else ""
    plan, sink = fake_plan(2), Truthful(cell)
    if is_used:
        run(rig, plan, sink)
        assert [stack.readback.table_rad for stack in sink.stacks] == [radians(off_deg), radians(17.0 + off_deg)]
    else:
        with pytest.raises(MotionError, match=r"the table stopped at 0\.060°"):
            run(rig, plan, sink)
        assert stopped(rig)
        assert not sink.stacks


def test_a_person_has_to_reset_the_stop_after_an_axis_stopped_elsewhere(rig, cell):
    cell.fault = once("robot", 1, "off")
    plan, sink = fake_plan(), Truthful(cell)
    with pytest.raises(MotionError, match="Check for a collision"):
        run(rig, plan, sink)
    moves = cell.moves
    task = FringeTask(plan.patterns, plan.bracket.exposures_us, drawn(plan), sink)
    with pytest.raises(DeviceError, match="The rig was stopped"):
        Engine(rig).run(plan.name, plan.viewpoints[1:], task, lambda _: None, NoProgress())
    assert cell.moves == moves


def test_d11_a_clock_that_is_set_back_changes_nothing_but_the_times_recorded(rig, cell, monkeypatch):
    """By an hour with every look at it."""
    start, looks = datetime(2026, 1, 1, tzinfo=UTC), []

    class SetBack(datetime):
        @classmethod
        def now(cls, tz=None):
            looks.append(start - timedelta(hours=len(looks)))
            return looks[-1]

    monkeypatch.setattr(engine_run, "datetime", SetBack)
    monkeypatch.setattr(session, "datetime", SetBack)
    events = run(rig, fake_plan(), sink := Truthful(cell))
    assert stored(sink) == ["v0", "v1", "v2"]
    times = [stack.conditions.taken_at for stack in sink.stacks]
    assert times == sorted(times, reverse=True), "the clock was not looked at"
    assert len({stack.approach for stack in sink.stacks}) == 3
    assert all(0.0 <= event.seconds < 60.0 for event in events if isinstance(event, ViewpointStored))
