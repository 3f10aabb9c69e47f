"""States of a run and of its viewpoints, and which may follow which."""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum


class RunState(StrEnum):
    """State of a whole run."""

    IDLE = "idle"  # not started
    RUNNING = "running"
    PAUSING = "pausing"  # a pause is requested, and the rig on its way to a safe state
    PAUSED = "paused"  # projector dark, nothing moves, the rig is kept
    ENDED = "ended"


class ViewpointState(StrEnum):
    """State of one viewpoint of a run, in the order in which they follow."""

    WAITING = "waiting"
    MOVING = "moving"
    CONFIRMING = "confirming"  # the axes are read back
    SETTLING = "settling"
    CAPTURING = "capturing"
    CHECKING = "checking"  # nothing moved meanwhile, and the images agree with the patterns and each other
    STORING = "storing"
    STORED = "stored"  # completely and durably
    SKIPPED = "skipped"
    FAILED = "failed"
    KEPT = "kept"  # taken again in vain, or skipped then: the images stored before remain


ACTIVE = (
    ViewpointState.MOVING,
    ViewpointState.CONFIRMING,
    ViewpointState.SETTLING,
    ViewpointState.CAPTURING,
    ViewpointState.CHECKING,
    ViewpointState.STORING,
)
"""A viewpoint passes through these one after the other."""

CLOSED = (ViewpointState.STORED, ViewpointState.SKIPPED, ViewpointState.FAILED, ViewpointState.KEPT)
"""A viewpoint rests in one of these until it is queued again."""

_LEFT = {ViewpointState.WAITING, ViewpointState.SKIPPED, ViewpointState.FAILED, ViewpointState.KEPT}

VIEWPOINT_TRANSITIONS: Mapping[ViewpointState, frozenset[ViewpointState]] = {
    ViewpointState.WAITING: frozenset({ViewpointState.MOVING, ViewpointState.SKIPPED, ViewpointState.KEPT}),
    **{state: frozenset({following, *_LEFT}) for state, following in zip(ACTIVE, (*ACTIVE[1:], ViewpointState.STORED), strict=True)},
    **{state: frozenset({ViewpointState.WAITING}) for state in CLOSED},
}

RUN_TRANSITIONS: Mapping[RunState, frozenset[RunState]] = {
    RunState.IDLE: frozenset({RunState.RUNNING, RunState.ENDED}),
    RunState.RUNNING: frozenset({RunState.PAUSING, RunState.ENDED}),
    RunState.PAUSING: frozenset({RunState.PAUSED, RunState.RUNNING, RunState.ENDED}),
    RunState.PAUSED: frozenset({RunState.RUNNING, RunState.ENDED}),
    RunState.ENDED: frozenset(),
}


class IllegalTransition(RuntimeError):
    """A state followed one that it must not follow: an error of this program, never of a device or a user."""


def check_run_transition(before: RunState, after: RunState) -> None:
    """Raise IllegalTransition where ``after`` must not follow ``before``."""
    if after not in RUN_TRANSITIONS[before]:
        raise IllegalTransition(f"a run that is {before} cannot become {after}")


def check_viewpoint_transition(viewpoint_id: str, before: ViewpointState, after: ViewpointState) -> None:
    """Raise IllegalTransition where ``after`` must not follow ``before``."""
    if after not in VIEWPOINT_TRANSITIONS[before]:
        raise IllegalTransition(f"viewpoint {viewpoint_id}, which is {before}, cannot become {after}")
