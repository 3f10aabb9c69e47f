"""The engine takes every viewpoint, retakes what is wrong, and stops everything when it cannot go on."""

from __future__ import annotations

import threading
import time

import numpy as np
import pytest
from acquire.fake_rig import Cell, Truthful, drawn, fake_plan, fake_rig, released
from robot_requests import Stalls

from measureapp.acquire import device_call, session
from measureapp.acquire.engine import Engine
from measureapp.acquire.events import (
    ImageTaken,
    RunEnded,
    RunStarted,
    ViewpointEntered,
    ViewpointFailed,
    ViewpointRetaken,
    ViewpointStarted,
    ViewpointStored,
)
from measureapp.acquire.session import RigSession
from measureapp.acquire.stopping import abort, reset
from measureapp.acquire.tasks.board import BoardTask
from measureapp.acquire.tasks.fringes import FringeTask
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.errors import DeviceError, DeviceLost, MotionError, StorageError
from measureapp.progress import Cancelled, NoProgress


@pytest.fixture
def cell():
    return Cell()


@pytest.fixture
def rig(cell):
    with released(fake_rig(cell)) as made:
        yield made


def run(rig, plan, sink, progress=None, events=None):
    events = [] if events is None else events
    try:
        task = FringeTask(plan.patterns, plan.bracket.exposures_us, drawn(plan), sink)
        Engine(rig).run(plan.name, plan.viewpoints, task, events.append, progress or NoProgress())
    finally:
        assert isinstance(events[-1], RunEnded)
        assert sum(isinstance(event, RunEnded) for event in events) == 1
        assert not sink.wrong
    return events


def once(device, call, fault):
    return lambda name, number: fault if (name, number) == (device, call) else ""


def kinds(events):
    return [type(event) for event in events if not isinstance(event, ImageTaken | ViewpointEntered)]


def stopped(rig):
    return all(device.stops for device in rig.devices)


def test_every_viewpoint_is_taken_with_all_patterns_exposures_and_cameras(rig, cell):
    plan, sink = fake_plan(), Truthful(cell)
    events = run(rig, plan, sink)
    assert kinds(events) == [RunStarted, *[ViewpointStarted, ViewpointStored] * 3, RunEnded]
    assert events[-1].reason == "done"
    assert [stack.viewpoint_id for stack in sink.stacks] == ["v0", "v1", "v2"]
    assert sink.exposures == [(f"v{i}", level) for i in range(3) for level in range(3)]
    assert cell.shown == -2, "the light stays on"


def test_stacks_between_which_only_the_table_turned_say_so(rig, cell):
    here, there = (FlangePose(position_mm=(400, 0, z), quaternion_wxyz=(1, 0, 0, 0)) for z in (500, 505))
    places = [(here, 0.0), (here, 0.0), (there, 0.0), (here, 0.0), (here, 5.0), (here, 5.0)]
    viewpoints = tuple(Viewpoint(id=f"v{i}", flange=pose, guide_mm=slide, table_deg=30.0 * i) for i, (pose, slide) in enumerate(places))
    plan, sink = fake_plan().model_copy(update={"viewpoints": viewpoints}), Truthful(cell)
    run(rig, plan, sink)
    approaches = [stack.approach for stack in sink.stacks]
    assert [approaches.index(approach) for approach in approaches] == [0, 0, 2, 3, 4, 4]


@pytest.mark.parametrize("fault", ["failed", "serial", "read-back"])
def test_a_damaged_image_is_taken_again_within_its_sequence(rig, cell, fault):
    cell.fault = once("left", 5, fault)
    sink = Truthful(cell)
    events = run(rig, fake_plan(), sink)
    assert ViewpointRetaken not in kinds(events)
    assert len(sink.stacks) == 3


@pytest.mark.parametrize("fault", ["missing", "double", "stale", "earlier", "half exposed", "torn", "wrapped", "lamp"])
def test_images_that_contradict_the_sequence_or_each_other_let_the_viewpoint_be_taken_again(rig, cell, fault):
    count = fake_plan().patterns.count
    cell.fault = once("right", 3 * count + 4, fault)  # at the second viewpoint
    sink = Truthful(cell)
    events = run(rig, fake_plan(), sink)
    assert [event.viewpoint_id for event in events if isinstance(event, ViewpointRetaken)] == ["v1"]
    assert sink.dropped == ["v1"]
    assert len(sink.stacks) == 3


def test_a_projector_that_is_late_by_one_pattern_is_noticed_from_the_images(rig, cell):
    cell.fault = once("projector", 40, "late")
    events = run(rig, fake_plan(), Truthful(cell))
    assert [event.viewpoint_id for event in events if isinstance(event, ViewpointRetaken)] == ["v1"]


def test_a_camera_that_repeats_images_of_the_viewpoint_before_is_noticed(rig, cell):
    cell.fault = lambda name, call: "earlier" if name == "left" and cell.guide_mm == 10.0 else ""
    events = run(rig, fake_plan(), sink := Truthful(cell))
    assert "is an image of v0" in next(event.reason for event in events if isinstance(event, ViewpointRetaken))
    assert [stack.viewpoint_id for stack in sink.stacks] == ["v0", "v2"]


def test_images_that_stay_damaged_fail_the_viewpoint_with_the_reason_and_the_run_goes_on(rig, cell):
    cell.fault = lambda name, call: "failed" if name == "left" and cell.guide_mm == 10.0 else ""
    events = run(rig, fake_plan(), sink := Truthful(cell))
    assert "taken again 3 times in vain" in next(event.reason for event in events if isinstance(event, ViewpointFailed))
    assert [stack.viewpoint_id for stack in sink.stacks] == ["v0", "v2"]


def test_a_camera_without_images_ends_the_run_as_lost(rig, cell):
    cell.fault = lambda name, call: "missing" if name == "left" else ""
    with pytest.raises(DeviceLost, match="delivered no image"):
        run(rig, fake_plan(), Truthful(cell))
    assert stopped(rig)


def test_an_exposure_that_a_camera_clamps_ends_the_viewpoint_before_any_image(rig, cell):
    rig.cameras["right"].longest_us = 60_000
    events = run(rig, fake_plan(), sink := Truthful(cell))
    failures = [event for event in events if isinstance(event, ViewpointFailed)]
    assert len(failures) == 3
    assert "right set 60000 µs instead of the requested 100000 µs" in failures[0].reason
    assert not sink.stacks
    assert rig.cameras["left"].calls == 0


@pytest.mark.parametrize("axis", ["robot", "guide", "table"])
@pytest.mark.parametrize("fault", ["off", "stuck"])
def test_an_axis_that_stops_elsewhere_stops_everything_and_nothing_moves_on(rig, cell, axis, fault):
    cell.fault = once(axis, 1 if axis == "robot" else 2, fault)
    with pytest.raises(MotionError, match=axis):
        run(rig, fake_plan(), sink := Truthful(cell))
    assert stopped(rig)
    assert not any(stack.viewpoint_id == "v2" for stack in sink.stacks)


@pytest.mark.parametrize("axis", ["robot", "guide", "table"])
def test_an_axis_that_moves_or_only_turns_while_images_are_taken_is_noticed(rig, cell, axis):
    cell.fault = once(f"{axis} read", 2, "creep")
    with pytest.raises(MotionError, match=f"the {axis} moved while images were taken"):
        run(rig, fake_plan(), sink := Truthful(cell))
    assert sink.dropped == ["v0"]
    assert stopped(rig)


@pytest.mark.parametrize("axis", ["robot", "guide", "table"])
def test_a_read_back_that_is_not_a_number_is_no_confirmation(rig, cell, axis):
    cell.fault = once(f"{axis} read", 1, "nan")
    with pytest.raises(MotionError, match=axis):
        run(rig, fake_plan(), sink := Truthful(cell))
    assert not sink.stacks


@pytest.mark.parametrize("device", ["robot", "guide", "table", "left", "projector"])
@pytest.mark.parametrize(("fault", "error"), [("oserror", DeviceLost), ("lost", DeviceLost), ("interrupt", KeyboardInterrupt)])
def test_any_exception_from_a_driver_stops_every_device_and_is_told_last(rig, cell, device, fault, error):
    cell.fault = once(device, 2, fault)
    events = []
    with pytest.raises(error):
        run(rig, fake_plan(), Truthful(cell), events=events)
    assert stopped(rig)
    assert events[-1].reason == ("cancelled" if fault == "interrupt" else "failed")
    if fault == "oserror":
        assert f"failed: OSError: {device}: connection reset" in events[-1].message
    assert cell.shown == -2


def test_an_axis_that_does_not_arrive_stops_everything(rig, cell):
    cell.fault = once("guide", 1, "timeout")
    with pytest.raises(MotionError):
        run(rig, fake_plan(), Truthful(cell))
    assert stopped(rig)


def test_an_event_handler_that_fails_stops_the_rig_too(rig, cell):
    def on_event(event):
        if isinstance(event, ViewpointStored):
            raise RuntimeError("the window is gone")

    plan = fake_plan()
    task = FringeTask(plan.patterns, plan.bracket.exposures_us, drawn(plan), Truthful(cell))
    with pytest.raises(RuntimeError):
        Engine(rig).run(plan.name, plan.viewpoints, task, on_event, NoProgress())
    assert stopped(rig)


class CancelledAfter:
    """Progress that is cancelled a moment after the first report."""

    def __init__(self, seconds):
        self.end = time.monotonic() + seconds

    def report(self, done, total, note=""):
        self.check()

    def check(self):
        if time.monotonic() > self.end:
            raise Cancelled


@pytest.mark.timed
@pytest.mark.parametrize("device", ["robot", "guide", "table", "left", "projector"])
def test_cancelling_reaches_a_call_that_blocks(rig, cell, device):
    cell.fault = once(device, 1, "blocked")
    started = time.monotonic()
    events = []
    with pytest.raises(Cancelled):
        run(rig, fake_plan(), Truthful(cell), CancelledAfter(0.1), events)
    assert time.monotonic() - started < 2.0
    assert stopped(rig)
    assert events[-1].reason == "cancelled"


def test_a_device_that_never_answers_is_given_up(rig, cell, monkeypatch):
    monkeypatch.setattr(device_call, "GRACE_S", -119.9)  # of the 120 s that a move may take
    cell.fault = once("robot", 1, "blocked")
    with pytest.raises(DeviceLost, match="The robot does not answer any more"):
        run(rig, fake_plan(), Truthful(cell))
    assert stopped(rig)


@pytest.fixture
def stalls():
    with Stalls() as found:
        yield found


def test_a_stop_from_another_thread_reaches_every_device_while_a_call_blocks_a_hundred_times(rig, cell, stalls):
    worst = 0.0
    for _ in range(100):
        blocked = threading.Event()

        def fault(name, call, blocked=blocked):
            if name == "robot" and not blocked.is_set():
                blocked.set()
                return "blocked"
            return ""

        cell.fault = fault
        before = [device.stops for device in rig.devices]
        outcome = []

        def work(outcome=outcome):
            try:
                run(rig, fake_plan(), Truthful(cell))
            except Cancelled:
                outcome.append("cancelled")

        thread = threading.Thread(target=work)
        thread.start()
        assert blocked.wait(5.0)
        started = time.monotonic()
        assert abort(rig, "Stop was pressed.") == ""
        ended = time.monotonic()
        worst = max(worst, ended - started - stalls.within(started, ended))
        assert all(device.stops > count for device, count in zip(rig.devices, before, strict=True))
        thread.join(5.0)
        assert outcome == ["cancelled"]
        reset(rig)
    assert worst < 0.2


def test_a_stop_latches_until_a_person_resets_it(rig, cell):
    abort(rig, "the emergency stop was pressed.")
    plan, sink = fake_plan(), Truthful(cell)
    with pytest.raises(DeviceError, match="The rig was stopped: the emergency stop was pressed"):
        run(rig, plan, sink)
    assert cell.moves == 0
    reset(rig)
    run(rig, plan, sink)
    assert len(sink.stacks) == 3


def test_a_device_that_fails_to_stop_is_named_and_the_others_are_stopped(rig):
    def fail():
        raise OSError("no route to host")

    rig.guide.stop = fail
    never = threading.Event()
    rig.table.stop = lambda: never.wait(5.0)
    report = abort(rig, "test.")
    never.set()
    assert "guide: OSError: no route to host" in report
    assert "table: no answer" in report
    assert rig.robot.stops == 1


def test_a_second_task_on_one_rig_is_refused(rig):
    with RigSession(rig), pytest.raises(DeviceError, match="in use by another task"), RigSession(rig):
        pass


def test_the_board_is_taken_by_every_camera_at_its_longest_exposure_that_does_not_saturate(rig, cell):
    genuine = cell.mean
    gain = {"left": 2.6, "right": 1.0}
    cell.mean = lambda camera, exposure_us, pattern: np.minimum(255.0, gain[camera] * genuine(camera, exposure_us, pattern))
    views = []
    Engine(rig).run("calibration", fake_plan(2).viewpoints, BoardTask(views.append), lambda event: None, NoProgress())
    assert [view.viewpoint_id for view in views] == ["v0", "v1"]
    for camera, images in views[1].images.items():
        assert (images >= 255).mean() < 0.002, camera
    truth = {camera: genuine(camera, 100_000, -1).mean() * gain[camera] for camera in gain}
    assert views[1].images["right"].mean() == pytest.approx(truth["right"], abs=1.0)
    assert views[1].images["left"].mean() < 0.85 * truth["left"]
    assert views[1].readback.guide_mm == 10.0


def test_images_that_cannot_be_stored_stop_the_rig_but_leave_no_doubt_about_it(rig, cell):
    sink = Truthful(cell)

    def store(stack):
        raise StorageError("disk full.", "Free some space.")

    sink.store = store
    with pytest.raises(StorageError):
        run(rig, fake_plan(), sink)
    assert stopped(rig)
    assert not rig.latch.reason


def test_an_interrupt_while_the_head_is_busy_keeps_its_own_reason(rig, cell, monkeypatch):
    monkeypatch.setattr(device_call, "LEAVE_S", 0.05)
    released = threading.Event()
    genuine = rig.cameras["left"].next_frame

    def next_frame(*, timeout_s):
        released.wait(0.5)  # not ended by a stop
        return genuine(timeout_s=timeout_s)

    rig.cameras["left"].next_frame = next_frame
    with pytest.raises(Cancelled):
        run(rig, fake_plan(), Truthful(cell), CancelledAfter(0.2))
    released.set()


def test_a_camera_that_computes_its_images_has_the_time_it_states_and_a_real_one_has_not(rig, cell, monkeypatch):
    """A virtual rig with kernels to be compiled, on a busy computer, is not lost."""
    monkeypatch.setattr(device_call, "GRACE_S", 0.0)
    monkeypatch.setattr(session, "STEPS_OF_A_SHOT", 0.0)
    camera, slow = rig.cameras["left"], threading.Event()
    genuine = camera.trigger

    def trigger():
        if not slow.is_set():
            slow.wait(0.3)
            slow.set()
        genuine()

    camera.trigger = trigger
    with pytest.raises(DeviceLost, match="does not answer"):
        run(rig, fake_plan(1), Truthful(cell))
    reset(rig)
    slow.clear()
    camera.longest_rendering_s = 30.0
    run(rig, fake_plan(1), sink := Truthful(cell))
    assert len(sink.stacks) == 1
