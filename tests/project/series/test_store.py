from __future__ import annotations

import sqlite3
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest

from measureapp.data.dimension import Verdict
from measureapp.errors import Damaged, InputError
from measureapp.project.series.store import SeriesStore, list_programs, series_folder

PROGRAM = "impeller 叶轮"
WRITER = """
import sys
from pathlib import Path
from measureapp.data.identification import Identification
from measureapp.data.series import SeriesRun
from measureapp.project.series.store import SeriesStore
store = SeriesStore("both", Path(sys.argv[1]))
for n in range(8):
    serial = Identification(serial_number=f"{sys.argv[2]}-{n}")
    run = SeriesRun(run_id=f"{int(sys.argv[2]):04x}{n:028x}", program="both", identification=serial, verdict=None, values=(), project="",
                    measured_at="2026-05-04T10:20:30+00:00")
    store.add(run)
"""


def test_runs_are_listed_by_program_serial_number_and_time(run, tmp_path: Path) -> None:
    store = SeriesStore(PROGRAM, tmp_path)
    assert store.runs() == () and list_programs(tmp_path) == ()
    runs = [run(n) for n in range(4)]
    for one in reversed(runs):
        store.add(one)
    assert store.runs() == tuple(runs)
    assert store.runs(serial_number="SN-002") == (runs[2],)
    assert store.runs(since="2026-05-03T00:00:00+00:00") == tuple(runs[2:])
    assert list_programs(tmp_path) == (PROGRAM,)
    with pytest.raises(InputError, match="yesterday"):
        store.runs(since="yesterday")


def test_the_same_run_stored_twice_is_one(run, tmp_path: Path) -> None:
    store = SeriesStore(PROGRAM, tmp_path)
    store.add(run(1))
    store.add(run(1))
    assert store.runs() == (run(1),)


def test_a_part_is_measured_again_only_with_a_reason(run, tmp_path: Path) -> None:
    store = SeriesStore(PROGRAM, tmp_path)
    store.add(run(1, Verdict.FAIL, serial="A"))
    with pytest.raises(InputError, match="Serial number A was measured before"):
        store.add(run(2, serial="A"))
    store.add(run(2, serial="A", repeat_reason="part was not clean"))
    assert [one.repeat_reason for one in store.runs(serial_number="A")] == ["", "part was not clean"]
    store.add(run(3, serial=""))
    store.add(run(4, serial=""))  # parts without a serial number cannot be told apart


def test_a_failed_run_can_be_neither_deleted_nor_changed(run, tmp_path: Path) -> None:
    store = SeriesStore(PROGRAM, tmp_path)
    store.add(run(1, Verdict.FAIL))
    with closing(sqlite3.connect(store.path)) as connection:
        for statement in ("DELETE FROM run", "UPDATE run SET verdict = 'pass'"):
            with pytest.raises(sqlite3.IntegrityError, match="never"):
                connection.execute(statement)


def test_a_run_changed_behind_the_back_is_named(run, tmp_path: Path) -> None:
    store = SeriesStore(PROGRAM, tmp_path)
    store.add(run(1, Verdict.FAIL))
    with closing(sqlite3.connect(store.path)) as connection:
        connection.executescript("DROP TRIGGER run_is_final; UPDATE run SET document = replace(document, '\"fail\"', '\"pass\"');")
    with pytest.raises(Damaged, match="run 1 is not what was stored"):
        store.runs()


def test_a_damaged_store_is_named_and_rebuilt_from_projects_and_from_what_is_left(run, tmp_path: Path) -> None:
    store = SeriesStore(PROGRAM, tmp_path)
    runs = [run(n) for n in range(12)]
    for one in runs[:11]:
        store.add(one)
    content = bytearray(store.path.read_bytes())
    middle = content.index(b'number":"SN-007') + 9
    content[middle : middle + 3] = b"XXX"
    store.path.write_bytes(content)
    with pytest.raises(Damaged, match=r"results\.sqlite is damaged: run 8"):
        store.runs()
    rebuilt = store.rebuild((runs[7], runs[11]))
    assert (rebuilt.runs, rebuilt.from_damaged, rebuilt.from_projects) == (12, 10, 2)
    assert store.runs() == tuple(runs)
    assert rebuilt.kept_as is not None and rebuilt.kept_as.read_bytes() == bytes(content)


@pytest.mark.parametrize(
    "content", [b"", b"not a database at all, but long enough to look like one" * 10, b"SQLite format 3\0" + bytes(4080)]
)
def test_a_store_that_is_no_database_is_named_and_rebuilt_from_projects(content: bytes, run, tmp_path: Path) -> None:
    store = SeriesStore(PROGRAM, tmp_path)
    store.add(run(1))
    store.path.write_bytes(content)
    with pytest.raises(Damaged, match=r"results\.sqlite"):
        store.runs()
    with pytest.raises(Damaged, match="results") as caught:
        store.add(run(2))
    assert "series rebuild" in caught.value.hint
    store.rebuild((run(1),))
    assert store.runs() == (run(1),)


def test_two_programs_write_at_a_time_and_no_run_is_lost(tmp_path: Path) -> None:
    writers = [subprocess.Popen([sys.executable, "-c", WRITER, str(tmp_path), str(k)]) for k in (1, 2)]
    assert [writer.wait(60) for writer in writers] == [0, 0]
    assert len(SeriesStore("both", tmp_path).runs()) == 16


def test_programs_whose_names_differ_only_in_forbidden_letters_have_folders_of_their_own(tmp_path: Path) -> None:
    folders = {series_folder(name, tmp_path) for name in ("a/b", "a:b", "a b", "con", "x" * 300)}
    assert len(folders) == 5
    assert all(folder.parent == tmp_path and len(folder.name) < 110 for folder in folders)
