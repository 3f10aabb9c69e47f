"""Random requests and faults at every instant of a run: no illegal transition, no deadlock, nothing reported stored that is not."""

from __future__ import annotations

from itertools import pairwise

import pytest
from acquire.fake_rig import fake_plan
from acquire.lockstep import SteppedRun, Stored
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule, run_state_machine_as_test

from measureapp.acquire.events import (
    RunEnded,
    RunPaused,
    RunStarted,
    ViewpointEntered,
    ViewpointStored,
)
from measureapp.acquire.run_states import RunState
from measureapp.devices.projector import DARK
from measureapp.errors import DeviceLost, InputError, MotionError
from measureapp.progress import Cancelled

PLAN = fake_plan(4)
NAMES = tuple(viewpoint.id for viewpoint in PLAN)
OUTCOMES = {
    "move": ("refused", "refused", "no path", "limit", "timeout", "off", "lost", "oserror"),
    "trigger": ("failed", "double", "double", "missing", "refused", "refused", "lost"),
    "check": ("contradiction",),
    "store": ("full", "full", "full", "bug"),
    "paused": (),
}
ORDER = ["moving", "confirming", "settling", "capturing", "checking", "storing", "stored"]
LEFT = {"waiting", "skipped", "failed", "kept"}
ALLOWED = (
    {(before, after) for before, after in pairwise(ORDER)}
    | {(state, left) for state in ORDER[:-1] for left in LEFT}
    | {("waiting", "moving"), ("waiting", "skipped"), ("waiting", "kept")}
    | {(closed, "waiting") for closed in ("stored", "skipped", "failed", "kept")}
)
"""Stated anew: a shared mistake would prove nothing."""
EXPECTED = (type(None), Cancelled, DeviceLost, MotionError, ValueError)


class EngineMachine(RuleBasedStateMachine):
    steps = 0

    def __init__(self) -> None:
        super().__init__()
        self.disk = Stored()
        self.run = SteppedRun(PLAN.viewpoints, (), self.disk)

    def over(self) -> bool:
        return self.run.steps.ended

    def go(self, outcome: str) -> None:
        self.run.steps.go(outcome)

    @rule(goal=st.sampled_from(("move", "trigger", "check", "store", "store", "store")))
    def go_on_well(self, goal: str) -> None:
        for _ in range(12):
            if not self.over():
                self.go("ok")
            if self.over() or self.run.steps.at in (goal, "paused"):
                return

    @precondition(lambda self: not self.over() and OUTCOMES[self.run.steps.at])
    @rule(data=st.data())
    def fault(self, data: st.DataObject) -> None:
        at = self.run.steps.at
        self.go(data.draw(st.sampled_from(OUTCOMES[at]), label=f"fault at {at}"))

    @rule()
    def pause(self) -> None:
        self.request(self.run.control.pause)

    @rule()
    def resume(self) -> None:
        self.request(self.run.control.resume)

    @rule(name=st.sampled_from((None, *NAMES, "stranger")))
    def skip(self, name: str | None) -> None:
        self.request(lambda: self.run.control.skip(name))

    @rule(name=st.sampled_from((*NAMES, "stranger")))
    def retake(self, name: str) -> None:
        before = dict(self.disk.takes)
        self.request(lambda: self.run.control.retake(name))
        assert self.disk.takes == before, "images were given away before there were new ones"

    @rule(is_ready=st.booleans())
    def ready(self, is_ready: bool) -> None:
        self.run.ready(is_ready)

    @precondition(lambda self: not self.over())
    @rule(now=st.integers(0, 9))
    def stop(self, now: int) -> None:
        if now == 7:  # most runs shall last
            self.run.cancelled = True
            self.run.steps.reach()
            if not self.over():
                self.go("ok")
                while not self.over():  # until the next cancellation point
                    self.go("ok")
            assert isinstance(self.run.error, Cancelled)

    @precondition(lambda self: self.over())
    @rule()
    def continue_the_scan(self) -> None:
        self.run.close()
        missing = tuple(viewpoint for viewpoint in PLAN if viewpoint.id not in self.disk.takes)
        stored = tuple(viewpoint for viewpoint in PLAN if viewpoint.id in self.disk.takes)
        self.run = SteppedRun(missing or stored[:1], stored, self.disk)

    def request(self, make: object) -> None:
        try:
            make()  # type: ignore[operator]
        except InputError as error:
            assert error.message.endswith(".")
            return
        assert not self.over()

    @invariant()
    def everything_is_as_it_should(self) -> None:
        type(self).steps += 1
        events, control = list(self.run.events), self.run.control
        assert isinstance(self.run.error, EXPECTED), self.run.error
        assert isinstance(events[0], RunStarted)
        states = dict.fromkeys(NAMES, "waiting") | {name: "stored" for name in NAMES if name not in events[0].viewpoint_ids}
        for event in events:
            if isinstance(event, ViewpointEntered):
                assert (states[event.viewpoint_id], event.state) in ALLOWED
                states[event.viewpoint_id] = str(event.state)
        stored = {event.viewpoint_id for event in events if isinstance(event, ViewpointStored)}
        assert stored <= self.disk.takes.keys()
        if control.state is RunState.PAUSED and self.run.steps.at == "paused":
            assert self.run.cell.shown == DARK
            assert any(isinstance(event, RunPaused) for event in events)
        if self.over():
            self.check_the_end(events, states)

    def check_the_end(self, events: list[object], states: dict[str, str]) -> None:
        assert isinstance(events[-1], RunEnded)
        assert sum(isinstance(event, RunEnded) for event in events) == 1
        assert self.run.control.state is RunState.ENDED
        assert set(states.values()) <= {"waiting", "stored", "skipped", "failed", "kept"}, "a viewpoint is still under way"
        on_disk = {name for name, state in states.items() if state in ("stored", "kept")}
        assert on_disk <= self.disk.takes.keys()
        missing = [name for name in NAMES if states[name] not in ("stored", "kept") and name in self.run.control.snapshot().viewpoints]
        assert all(name in events[-1].message for name in missing), "missing viewpoints are named"
        if events[-1].reason == "done":
            assert self.run.error is None
            assert "waiting" not in states.values()
        else:
            assert all(device.stops for device in self.run.rig.devices)

    def teardown(self) -> None:
        self.run.close()


def run_steps(examples: int, steps: int) -> int:
    EngineMachine.steps = 0
    run_state_machine_as_test(
        EngineMachine,
        settings=settings(
            max_examples=examples,
            stateful_step_count=steps,
            deadline=None,
            derandomize=True,
            database=None,
            suppress_health_check=list(HealthCheck),
        ),
    )
    return EngineMachine.steps


def test_two_thousand_random_requests_and_faults_meet_no_illegal_transition_and_no_deadlock():
    assert run_steps(50, 50) >= 2000


@pytest.mark.slow
def test_twenty_thousand_random_requests_and_faults_meet_no_illegal_transition_and_no_deadlock():
    assert run_steps(250, 100) >= 20_000
