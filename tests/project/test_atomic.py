"""What is told where a file cannot be written."""

from __future__ import annotations

import errno
from pathlib import Path

import pytest

from measureapp.errors import StorageError
from measureapp.project.atomic import require_writable, write_text
from measureapp.project.journal.disk import storage_error
from measureapp.project.journal.publish import part_of


@pytest.mark.parametrize(
    ("number", "remedy"),
    [(errno.ENOSPC, "Free some space, or"), (errno.EROFS, "Check the permissions, or"), (errno.EACCES, "Check the perm")],
)
def test_the_remedy_is_for_what_went_wrong_and_the_old_file_stays(tmp_path, monkeypatch, number, remedy):
    path = tmp_path / "a.txt"
    write_text(path, "before")

    def refuse(*_arguments, **_options):
        raise OSError(number, "refused")

    monkeypatch.setattr(Path, "write_text", refuse)
    with pytest.raises(StorageError, match="cannot be written: refused") as told:
        write_text(path, "after")
    assert told.value.hint.startswith(remedy)
    assert path.read_bytes() == b"before"
    assert [one.name for one in tmp_path.iterdir()] == ["a.txt"]


def test_an_error_names_the_file_that_is_written_and_not_its_temporary_name(tmp_path):
    part = part_of(tmp_path / "calibration") / "cameras.json"
    assert str(storage_error(part, OSError(28, "No space left on device"))).startswith(
        f"{tmp_path / 'calibration' / 'cameras.json'} cannot"
    )


def test_before_a_long_job_it_is_tried_whether_its_file_can_be_written_and_nothing_is_left(tmp_path):
    (tmp_path / "a file").write_text("")
    for path in (tmp_path / "a file" / "plan.toml", tmp_path):
        with pytest.raises(StorageError):
            require_writable(path)
    require_writable(tmp_path / "new folder" / "plan.toml")
    assert sorted(one.name for one in tmp_path.rglob("*")) == ["a file", "new folder"]
