"""Pause, resume, skip and retake: where the rig then is, what is stored, and what is said."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from acquire.fake_rig import Cell, Truthful, drawn, fake_plan, fake_rig, released
from acquire.lockstep import SteppedRun, Stored

from measureapp.acquire.control import RunControl
from measureapp.acquire.engine import Engine
from measureapp.acquire.events import (
    RunPaused,
    RunResumed,
    ViewpointFailed,
    ViewpointQueued,
    ViewpointRetaken,
    ViewpointSkipped,
    ViewpointStored,
)
from measureapp.acquire.run_states import IllegalTransition, RunState, ViewpointState
from measureapp.acquire.tasks.fringes import FringeTask
from measureapp.data.plan import Viewpoint
from measureapp.devices.projector import DARK
from measureapp.errors import DeviceLost, InputError
from measureapp.progress import NoProgress

PLAN = fake_plan(3)


@pytest.fixture
def disk() -> Stored:
    return Stored()


@pytest.fixture
def run(disk: Stored) -> Iterator[SteppedRun]:
    made = SteppedRun(PLAN.viewpoints, (), disk)
    yield made
    made.close()


def until(run: SteppedRun, point: str) -> None:
    """Let everything succeed until the engine waits at a point."""
    for _ in range(100):
        if run.steps.at == point:
            return
        run.steps.go("ok")
    raise AssertionError(f"never at {point}")


def to_the_end(run: SteppedRun) -> None:
    while not run.steps.ended:
        run.steps.go("ok")


def of(run: SteppedRun, kind: type) -> list:
    return [event for event in run.events if isinstance(event, kind)]


def stored(run: SteppedRun) -> list[str]:
    return [event.viewpoint_id for event in of(run, ViewpointStored)]


def test_a_pause_while_images_are_taken_darkens_the_projector_and_takes_the_viewpoint_from_its_beginning(run, disk):
    until(run, "trigger")
    run.control.pause()
    assert run.control.state is RunState.PAUSING
    until(run, "paused")
    assert run.control.state is RunState.PAUSED
    assert run.cell.shown == DARK
    assert run.control.snapshot().waiting == ("v0", "v1", "v2")
    assert of(run, RunPaused)[-1] == RunPaused("Paused by the user.", "Resume the run to go on.")
    assert not disk.takes
    run.control.resume()
    to_the_end(run)
    assert len(of(run, RunResumed)) == 1
    assert (stored(run), run.task.dropped, run.ended.reason) == (["v0", "v1", "v2"], ["v0"], "done")


def test_a_pause_during_a_move_lets_the_move_end_and_moves_no_other_axis(run):
    until(run, "move")
    run.control.pause()
    moves = run.cell.moves
    run.steps.go("ok")
    assert run.steps.at == "paused"
    assert run.cell.moves == moves + 1


def test_a_complete_viewpoint_is_stored_before_the_run_pauses(run, disk):
    until(run, "check")
    run.control.pause()
    until(run, "paused")
    assert list(disk.takes) == ["v0"]


def test_a_pause_that_is_withdrawn_in_time_changes_nothing(run):
    until(run, "move")
    run.control.pause()
    run.control.pause()
    run.control.resume()
    to_the_end(run)
    assert not of(run, RunPaused)
    assert stored(run) == ["v0", "v1", "v2"]


def test_a_device_that_is_not_ready_keeps_the_run_paused_until_it_is(run):
    until(run, "move")
    run.control.pause()
    until(run, "paused")
    run.ready(False)
    run.control.resume()
    run.steps.go("ok")
    assert run.control.state is RunState.PAUSED
    assert of(run, RunPaused)[-1].message == "robot (robot) is not ready: its door is open. Close it."
    run.ready(True)
    run.control.resume()
    to_the_end(run)
    assert stored(run) == ["v0", "v1", "v2"]


@pytest.mark.parametrize("point", ["move", "trigger", "check"])
@pytest.mark.parametrize("name", [None, "v0"])
def test_the_present_viewpoint_is_skipped_wherever_it_is_and_the_run_goes_on(run, disk, point, name):
    until(run, point)
    run.control.skip(name)
    to_the_end(run)
    assert of(run, ViewpointSkipped) == [ViewpointSkipped("v0")]
    assert (list(disk.takes), run.task.dropped) == (["v1", "v2"], ["v0"])
    assert run.ended.message == "2 of 3 viewpoints are stored and kept; not v0. Continue the run to take the missing ones."


def test_a_waiting_viewpoint_is_skipped_at_once_and_can_be_wanted_again(run, disk):
    until(run, "trigger")
    run.control.skip("v1")
    assert run.control.snapshot().viewpoints["v1"] is ViewpointState.SKIPPED
    run.control.retake("v1")
    to_the_end(run)
    assert stored(run) == ["v0", "v2", "v1"]
    assert [event.viewpoint_id for event in of(run, ViewpointQueued)] == ["v1"]


def test_a_stored_viewpoint_is_taken_again_at_the_end_and_replaced_only_then(run, disk):
    until(run, "store")
    run.steps.go("ok")
    first = disk.takes["v0"]
    run.control.retake("v0")
    until(run, "store")
    while len(stored(run)) < 3:
        assert disk.takes["v0"] == first
        run.steps.go("ok")
    until(run, "store")
    assert disk.takes["v0"] == first
    to_the_end(run)
    assert stored(run) == ["v0", "v1", "v2", "v0"]
    assert disk.takes["v0"] > first


@pytest.mark.parametrize("fault", [False, True])
def test_a_viewpoint_taken_again_in_vain_keeps_its_earlier_images(disk, fault):
    disk.takes["v0"] = -1
    run = SteppedRun(PLAN.viewpoints[1:], PLAN.viewpoints[:1], disk)
    run.control.retake("v0")
    while stored(run) != ["v1", "v2"]:
        run.steps.go("ok")
    if fault:
        while not run.steps.ended:
            run.steps.go("contradiction" if run.steps.at == "check" else "ok")
        assert of(run, ViewpointFailed)[0].reason.endswith("The images stored before are kept.")
        assert len(of(run, ViewpointRetaken)) == 2
    else:
        run.control.skip()
        to_the_end(run)
    assert disk.takes["v0"] == -1
    assert run.control.snapshot().viewpoints["v0"] is ViewpointState.KEPT
    assert (run.ended.reason, run.ended.message, run.ended.stored) == ("done", "", ("v1", "v2"))
    run.close()


def test_images_for_which_the_disk_has_no_room_wait_in_memory_until_there_is(run, disk):
    until(run, "store")
    run.steps.go("full")
    assert run.steps.at == "paused"
    assert run.cell.shown == DARK
    paused = of(run, RunPaused)[-1]
    assert paused.message == "The disk is full."
    assert paused.hint == "Free some space. The images of v0 are in memory; they are stored first when the run goes on."
    run.control.resume()
    until(run, "store")
    run.steps.go("full")  # still no room
    assert run.steps.at == "paused"
    run.control.resume()
    to_the_end(run)
    assert disk.takes["v0"] == 1, "the very images that were taken first"
    assert stored(run) == ["v0", "v1", "v2"]
    assert not run.task.dropped


def test_images_that_cannot_be_stored_are_discarded_only_when_a_person_skips_them(run, disk):
    until(run, "store")
    run.steps.go("full")
    run.control.skip()
    run.steps.go("ok")
    assert run.control.state is RunState.PAUSED
    assert (of(run, ViewpointSkipped), run.task.dropped) == ([ViewpointSkipped("v0")], ["v0"])
    run.control.resume()
    to_the_end(run)
    assert list(disk.takes) == ["v1", "v2"]


def test_a_viewpoint_that_stays_refused_is_tried_once_more_at_the_end_and_then_reported(run, disk):
    while not run.steps.ended:
        at_v0 = run.control.snapshot().viewpoint_id == "v0"
        run.steps.go("contradiction" if run.steps.at == "check" and at_v0 else "ok")
    assert len(of(run, ViewpointRetaken)) == 2
    assert of(run, ViewpointQueued)[0].reason.endswith("It is tried once more at the end of the run.")
    assert [event.viewpoint_id for event in of(run, ViewpointFailed)] == ["v0"]
    assert run.task.dropped == ["v0"] * 4
    assert run.ended.message.startswith("2 of 3 viewpoints are stored and kept; not v0.")


def test_a_viewpoint_without_a_path_from_here_is_tried_from_elsewhere(run, disk):
    run.steps.go("no path")
    to_the_end(run)
    assert stored(run) == ["v1", "v2", "v0"]
    assert run.ended.reason == "done"


def test_a_run_that_a_fault_ends_says_the_reason_what_is_kept_and_how_to_go_on(run):
    until(run, "store")
    run.steps.go("ok")
    run.steps.go("lost")
    assert isinstance(run.error, DeviceLost)
    assert run.ended.message == (
        "robot is gone. Connect it. 1 of 3 viewpoints are stored and kept; not v1, v2. Continue the run to take the missing ones."
    )
    assert run.ended.stored == ("v0",)


def test_requests_that_make_no_sense_are_refused_in_words(run):
    until(run, "trigger")
    control = run.control
    with pytest.raises(InputError, match="no viewpoint 'x'"):
        control.skip("x")
    with pytest.raises(InputError, match="v0 is being taken"):
        control.retake("v0")
    until(run, "store")
    with pytest.raises(InputError, match="v0 cannot be skipped: it is storing"):
        control.skip("v0")
    to_the_end(run)
    for request in (control.pause, control.resume, control.skip, lambda: control.retake("v0")):
        with pytest.raises(InputError, match="The run has ended"):
            request()
    with pytest.raises(InputError, match="cannot be used for another one"):
        control.begin(PLAN.viewpoints)
    with pytest.raises(InputError, match="has not started"):
        RunControl().pause()


def test_an_illegal_transition_is_an_error_of_the_program():
    control = RunControl()
    control.begin(PLAN.viewpoints)
    control.next_viewpoint()
    with pytest.raises(IllegalTransition, match="v0, which is moving, cannot become stored"):
        control.enter("v0", ViewpointState.STORED)


def test_viewpoints_have_exposures_and_settling_times_of_their_own(monkeypatch):
    def own(viewpoint: Viewpoint, **values: object) -> Viewpoint:
        return viewpoint.model_copy(update=values)

    viewpoints = (own(PLAN[0], settle_s=0.15), own(PLAN[1], exposures_us=(80_000, 40_000)), PLAN[2])
    cell = Cell()
    sink, events = Truthful(cell), []
    with released(fake_rig(cell)) as rig:
        task = FringeTask(PLAN.patterns, (100_000,), drawn(PLAN), sink)
        Engine(rig).run("plan", viewpoints, task, events.append, NoProgress())
    assert [stack.exposures_us for stack in sink.stacks] == [(100_000,), (80_000, 40_000), (100_000,)]
    assert not sink.wrong
    assert of_kind_seconds(events)[0] >= 0.15
    reads = rig.guide.reads
    assert reads == 3 * 2 + 1, "the axes are read back again after settling"


def of_kind_seconds(events: list) -> list[float]:
    return [event.seconds for event in events if isinstance(event, ViewpointStored)]


def test_exposures_chosen_at_a_viewpoint_are_kept_in_its_stack():
    cell = Cell()
    sink, probes = Truthful(cell), []

    def choose(probe, planned):
        probes.append((probe.viewpoint_id, probe.exposures_us, planned))
        return (90_000, 30_000) if probe.viewpoint_id == "v1" else planned

    with released(fake_rig(cell)) as rig:
        task = FringeTask(PLAN.patterns, (100_000,), drawn(PLAN), sink, choose)
        Engine(rig).run("plan", PLAN.viewpoints, task, lambda _: None, NoProgress())
    assert probes == [(name, (100_000, 12_500), (100_000,)) for name in ("v0", "v1", "v2")]
    assert [stack.exposures_us for stack in sink.stacks] == [(100_000,), (90_000, 30_000), (100_000,)]
    assert not sink.wrong
