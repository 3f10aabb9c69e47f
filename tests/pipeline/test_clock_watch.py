"""A clock that is set during a scan is noted in the journal, and changes nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest
from demo_fixture import Demo, linked_copy

from measureapp.pipeline.clock_watch import JUMP, ClockWatch
from measureapp.project import upkeep
from measureapp.project.journal import database


class Clocks:
    """A clock that somebody sets, and one that only runs."""

    def __init__(self) -> None:
        self.set_by_s = self.now_s = 0.0

    def watch(self) -> ClockWatch:
        return ClockWatch(lambda: 1e9 + self.now_s + self.set_by_s, lambda: self.now_s)


@pytest.mark.parametrize("jump_s", [3600.0, -86400.0])
def test_a_jump_is_found_once_in_both_directions(jump_s: float) -> None:
    clocks = Clocks()
    watch = clocks.watch()
    clocks.now_s += 30.0
    assert watch.jump_s() == 0.0
    clocks.set_by_s += jump_s
    clocks.now_s += 5.0
    assert watch.jump_s() == pytest.approx(jump_s)
    assert watch.jump_s() == 0.0


def test_slow_corrections_are_no_jumps() -> None:
    clocks = Clocks()
    watch = clocks.watch()
    clocks.set_by_s += 0.4
    assert watch.jump_s() == 0.0


def test_a_jump_is_in_the_journal_which_stays_whole(demo: Demo, tmp_path: Path) -> None:
    project, clocks = linked_copy(demo.folder, tmp_path / "p"), Clocks()
    watch = clocks.watch()
    clocks.set_by_s = -3600.0
    watch.note(project)
    line = database.last(project)
    assert line is not None and line.entry.kind == JUMP and line.entry.note == {"seconds": -3600.0}
    assert upkeep.verify(project).whole
