"""The journal: append-only, chained, and of one format."""

from __future__ import annotations

import shutil
import sqlite3
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from pathlib import Path

import pytest

from measureapp.errors import Damaged, DiskFull, StorageError
from measureapp.project import upkeep
from measureapp.project.folder import ProjectFolder
from measureapp.project.journal import database, publish
from measureapp.project.journal.entries import Entry
from tests.project.journal.whole_project import bare_project, stack, whole_project


def execute(project: Path, *statements: str) -> None:
    with closing(sqlite3.connect(project / database.JOURNAL, isolation_level=None)) as connection:
        for statement in statements:
            connection.execute(statement)


@pytest.fixture
def project(tmp_path: Path) -> ProjectFolder:
    made = bare_project(tmp_path / "project")
    with made.lock():
        made.frames.store(stack("view01"))
        made.frames.store(stack("view02"))
    return made


def test_what_was_stored_stands_in_the_journal_in_order(project: ProjectFolder) -> None:
    lines = database.read(project.path)
    assert [(line.number, line.entry.kind, line.entry.viewpoint) for line in lines] == [
        (1, "project created", ""),
        (2, "viewpoint stored", "view01"),
        (3, "viewpoint stored", "view02"),
    ]
    assert sorted(lines[1].entry.files) == ["stacks/view01/left.npy", "stacks/view01/right.npy", "stacks/view01/stack.json"]


def test_the_journal_is_a_write_ahead_log_of_its_own_application(project: ProjectFolder) -> None:
    with closing(sqlite3.connect(project.path / database.JOURNAL)) as connection:
        assert connection.execute("PRAGMA journal_mode").fetchone() == ("wal",)
        assert connection.execute("PRAGMA application_id").fetchone() == (database.APPLICATION_ID,)
        assert connection.execute("PRAGMA user_version").fetchone() == (1,)
    with closing(database._connect(project.path)) as connection:
        assert connection.execute("PRAGMA synchronous").fetchone() == (2,)  # FULL
        assert connection.execute("PRAGMA busy_timeout").fetchone() == (database.BUSY_MS,)


@pytest.mark.parametrize("statement", ["UPDATE journal SET kind = 'x'", "DELETE FROM journal WHERE number = 3"])
def test_the_journal_refuses_to_be_changed(statement: str, project: ProjectFolder) -> None:
    with pytest.raises(sqlite3.IntegrityError, match="append-only"):
        execute(project.path, statement)


@pytest.mark.parametrize(
    "statement",
    [
        "UPDATE journal SET kind = 'viewpoint dropped' WHERE number = 2",
        "UPDATE journal SET content = replace(content, '0', '1') WHERE number = 2",
        "UPDATE journal SET at = '2020-01-01' WHERE number = 1",
        "DELETE FROM journal WHERE number = 2",
    ],
)
def test_a_line_changed_behind_the_triggers_breaks_the_chain_and_nothing_is_used(statement: str, project: ProjectFolder) -> None:
    execute(project.path, "DROP TRIGGER never_changed", "DROP TRIGGER never_deleted", statement)
    with pytest.raises(Damaged, match=r"journal\.sqlite is damaged: line \d"):
        ProjectFolder.open(project.path)
    found = upkeep.verify(project.path)
    assert [one.file for one in found.damage] == ["journal.sqlite"]


def test_last_lines_that_were_cut_off_are_revealed_by_the_seal(project: ProjectFolder) -> None:
    execute(project.path, "DROP TRIGGER never_deleted", "DELETE FROM journal WHERE number = 3")
    assert "ends at line 2 of 3" in upkeep.verify(project.path).damage[0].problem


def test_a_journal_that_was_deleted_is_missed(project: ProjectFolder) -> None:
    (project.path / database.JOURNAL).unlink()
    with pytest.raises(Damaged, match=r"journal\.sqlite is missing"):
        ProjectFolder.open(project.path)


def test_a_damaged_journal_is_renewed_from_what_is_there_and_kept(project: ProjectFolder) -> None:
    execute(project.path, "DROP TRIGGER never_changed", "UPDATE journal SET kind = 'x' WHERE number = 2")
    upkeep.renew_journal(project.path)
    found = upkeep.verify(project.path)
    assert found.whole and found.viewpoints == ("view01", "view02")
    assert list(project.path.glob("journal.damaged-*.sqlite"))


def test_a_journal_of_a_newer_version_is_refused_in_words(project: ProjectFolder) -> None:
    execute(project.path, "PRAGMA user_version = 99")
    with pytest.raises(StorageError, match="written by a newer version"):
        ProjectFolder.open(project.path)


def test_another_database_is_not_taken_for_a_journal(project: ProjectFolder) -> None:
    execute(project.path, "PRAGMA application_id = 7")
    with pytest.raises(Damaged, match="not the journal of a project"):
        ProjectFolder.open(project.path)


def test_a_journal_that_a_backup_holds_is_waited_for_and_then_named(project: ProjectFolder, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(database, "BUSY_MS", 50)
    with closing(sqlite3.connect(project.path / database.JOURNAL, isolation_level=None)) as backup:
        backup.execute("BEGIN IMMEDIATE")
        with pytest.raises(StorageError, match="locked by another program, for example a backup"):
            project.frames.store(stack("view03"))
    project.frames.store(stack("view03"))
    assert project.stored_viewpoints() == ("view01", "view02", "view03")


def test_a_journal_without_room_is_a_full_disk_and_the_viewpoint_is_stored_when_there_is_room_again(
    project: ProjectFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    connect = database._connect

    def narrow(place: Path) -> sqlite3.Connection:
        connection = connect(place)
        connection.execute("PRAGMA max_page_count = 1")
        return connection

    large = Entry("note", {}, "", {"text": "x" * 20_000})
    with monkeypatch.context() as patch:
        patch.setattr(database, "_connect", narrow)
        with pytest.raises(DiskFull, match="the disk is full"):
            publish.record(project.path, large)
    publish.record(project.path, large)
    assert database.read(project.path)[-1].entry == large


def test_many_threads_write_one_after_the_other(project: ProjectFolder) -> None:
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(lambda number: project.frames.store(stack(f"many{number:02}")), range(12)))
    assert len(project.stored_viewpoints()) == 14
    assert [line.number for line in database.read(project.path)] == list(range(1, 16))
    assert upkeep.verify(project.path).whole


def test_a_project_that_cannot_be_written_to_is_read_from_a_copy_of_its_journal(
    project: ProjectFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    connect = database._connect

    def read_only(place: Path) -> sqlite3.Connection:
        if place == project.path:
            raise sqlite3.OperationalError("attempt to write a readonly database")
        return connect(place)

    monkeypatch.setattr(database, "_connect", read_only)
    again = ProjectFolder.open(project.path)
    assert again.stored_viewpoints() == ("view01", "view02")
    assert upkeep.verify(project.path).whole


def test_a_project_of_the_version_before_opens_without_being_written_to_and_gets_its_journal_with_the_first_change(tmp_path: Path) -> None:
    from tests.project.journal.whole_project import ARCHIVE

    shutil.unpack_archive(ARCHIVE, tmp_path / "older")
    before = sorted(tmp_path.rglob("*"))
    older = ProjectFolder.open(tmp_path / "older")
    assert older.measurement() is not None and not upkeep.verify(older.path).journal
    assert sorted(tmp_path.rglob("*")) == before
    with older.lock():
        pass
    found = upkeep.verify(older.path)
    assert found.journal and found.whole and found.files == len([path for path in before if path.is_file()])
    assert ProjectFolder.open(older.path).measurement() is not None


def test_stacks_of_the_version_before_are_taken_over_with_the_checksums_they_have(tmp_path: Path) -> None:
    project = whole_project(tmp_path / "project")
    for path in (project.path / database.JOURNAL, project.path / publish.SEAL):
        path.unlink()
    image = project.path / "stacks" / "view02" / "left.npy"
    image.write_bytes(image.read_bytes()[:-1] + b"\x01")
    again = ProjectFolder.open(project.path)
    assert not upkeep.verify(project.path).whole
    with again.lock():
        pass
    damage = upkeep.verify(project.path).damage
    assert [(one.file, one.viewpoint) for one in damage] == [("stacks/view02/left.npy", "view02")]
    with pytest.raises(Damaged, match=r"left\.npy"):
        again.frames.load("view02")
    assert again.frames.load("view01").viewpoint_id == "view01"
