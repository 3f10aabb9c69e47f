"""Every write, sync and rename fails once: nothing that was stored is harmed, and the same step succeeds when the disk is well again."""

from __future__ import annotations

import builtins
import errno
import io
import os
import pathlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from measureapp.errors import DiskFailed, DiskFull, StorageError
from measureapp.project import raw_images, upkeep
from measureapp.project.folder import ProjectFolder
from measureapp.project.journal import disk
from tests.project.journal.whole_project import board_view, contents_of, copied, stack

Step = Callable[[ProjectFolder], None]


class FailingDisk:
    """Lets the operation with a given number fail with an error, once."""

    def __init__(self, fails_at: int, code: int) -> None:
        self.fails_at, self.code, self.done = fails_at, code, 0

    def count(self) -> None:
        self.done += 1
        if self.done == self.fails_at:
            raise OSError(self.code, os.strerror(self.code))


class WatchedFile:
    """A file whose writes are counted."""

    def __init__(self, file: Any, failing: FailingDisk) -> None:
        self._file, self._failing = file, failing

    def write(self, data: Any) -> int:
        self._failing.count()
        return self._file.write(data)

    def writelines(self, lines: Any) -> None:
        self._failing.count()
        self._file.writelines(lines)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._file, name)

    def __enter__(self) -> WatchedFile:
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def __iter__(self) -> Iterator[Any]:
        return iter(self._file)


@contextmanager
def failing_disk(fails_at: int, code: int = errno.ENOSPC) -> Iterator[FailingDisk]:
    """Watch writes, syncs, renames and new folders of this process."""
    failing = FailingDisk(fails_at, code)
    real_open, real_write, real_fsync, real_replace, real_mkdir = io.open, os.write, os.fsync, pathlib.Path.replace, pathlib.Path.mkdir

    def opened(file: Any, mode: str = "r", *arguments: Any, **options: Any) -> Any:
        found = real_open(file, mode, *arguments, **options)
        return WatchedFile(found, failing) if set(mode) & set("wax+") and ".lock" not in str(file) else found

    def counted(function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any, **options: Any) -> Any:
            failing.count()
            return function(*arguments, **options)

        return call

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(io, "open", opened)
        patch.setattr(builtins, "open", opened)
        patch.setattr(os, "write", counted(real_write))
        patch.setattr(os, "fsync", counted(real_fsync))
        patch.setattr(pathlib.Path, "replace", counted(real_replace))
        patch.setattr(pathlib.Path, "mkdir", counted(real_mkdir))
        yield failing


def store_new(project: ProjectFolder) -> None:
    project.frames.store(stack("view03"))


def retake(project: ProjectFolder) -> None:
    project.frames.store(stack("view01", seed=5))


def save_results(project: ProjectFolder) -> None:
    measured = project.measurement()
    assert measured is not None
    project.save_measurement(replace(measured, views=measured.views[:2], project="another"))


def save_calibration(project: ProjectFolder) -> None:
    project.save_calibration(project.require_calibration())


def save_board(project: ProjectFolder) -> None:
    project.save_board_view(board_view("board03"))


def compress(project: ProjectFolder) -> None:
    raw_images.compress(project.journal, "view02")


STEPS = {
    "a new viewpoint": store_new,
    "a viewpoint that is retaken": retake,
    "results": save_results,
    "a calibration": save_calibration,
    "a view of the board": save_board,
    "compressed images": compress,
}


def steps_of(step: Step, template: ProjectFolder, place: Path) -> int:
    """How many operations of the disk a step takes."""
    project = copied(template, place)
    with project.lock(), failing_disk(0) as counting:
        step(project)
    return counting.done


@pytest.mark.parametrize("name", STEPS)
@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EIO])
def test_a_step_that_fails_at_any_operation_harms_nothing_and_succeeds_the_second_time(
    name: str, code: int, template: ProjectFolder, tmp_path: Path
) -> None:
    """At a selection of operations; at every one with the slow test below."""
    attempts = every_operation(STEPS[name], code, template, tmp_path, at_most=4)
    assert attempts >= 4


@pytest.mark.slow
@pytest.mark.parametrize("name", STEPS)
@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EIO, errno.EDQUOT])
def test_a_step_that_fails_at_each_of_its_operations_harms_nothing(name: str, code: int, template: ProjectFolder, tmp_path: Path) -> None:
    assert every_operation(STEPS[name], code, template, tmp_path, at_most=10_000) >= 8


def every_operation(step: Step, code: int, template: ProjectFolder, tmp_path: Path, at_most: int) -> int:
    """Let the step fail at its operations in turn, at most so many of them; return at how many."""
    total = steps_of(step, template, tmp_path / "counted")
    numbers = sorted({1 + round(index * (total - 1) / max(min(at_most, total) - 1, 1)) for index in range(min(at_most, total))})
    for number in numbers:
        place = tmp_path / f"fails at {number}"
        project = copied(template, place)
        before = contents_of(place)
        with project.lock():
            with failing_disk(number, code), pytest.raises(StorageError) as refused:
                step(project)
            assert isinstance(refused.value, DiskFull if code != errno.EIO else DiskFailed), (number, refused.value)
            assert upkeep.verify(place).whole, number
            stored = set(project.stored_viewpoints())
            assert {"view01", "view02"} <= stored
            step(project)
        with project.lock():  # finishes what the failure has interrupted, as the next command does
            pass
        assert upkeep.verify(place).whole, number
        assert not [path for path in place.rglob("*") if ".part" in path.name], number
        unchanged = {file for file, content in contents_of(place).items() if before.get(file) == content}
        assert {"project.json", "stacks/view02/stack.json"} <= unchanged
        assert ProjectFolder.open(place).frames.load("view02").viewpoint_id == "view02"
    return len(numbers)


def test_a_write_of_numpy_that_came_short_is_a_full_disk_in_words(tmp_path: Path) -> None:
    with pytest.raises(DiskFull, match="cannot be written completely") as refused, disk.explained(tmp_path / "left.npy"):
        raise OSError("5038848 requested and 3145600 written")
    assert "requested" not in str(refused.value)
