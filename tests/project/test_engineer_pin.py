"""The engineer's PIN: salted scrypt, slower after wrong attempts, removed by a command."""

from __future__ import annotations

import json

import pytest

from measureapp.cli import main
from measureapp.errors import InputError, StorageError
from measureapp.project.engineer_pin import FREE_ATTEMPTS, LONGEST_WAIT_S, check_pin, has_pin, pin_file, set_pin


def test_only_the_right_pin_is_accepted_and_it_is_nowhere_in_the_file(tmp_path):
    file = tmp_path / "pin.json"
    set_pin(file, "Überprüfung 1")
    assert check_pin(file, "Überprüfung 1", 0.0) and not check_pin(file, "überprüfung 1", 0.0)
    stored = file.read_text()
    assert "berpr" not in stored and json.loads(stored)["cost"] >= 2**14


def test_two_files_of_one_pin_differ(tmp_path):
    for name in ("one", "two"):
        set_pin(tmp_path / name, "123456")
    assert json.loads((tmp_path / "one").read_text())["key"] != json.loads((tmp_path / "two").read_text())["key"]


def test_wrong_attempts_slow_down_and_a_restart_does_not_help(tmp_path):
    file, now_s = tmp_path / "pin.json", 1e9
    set_pin(file, "123456")
    for _ in range(FREE_ATTEMPTS):
        assert not check_pin(file, "wrong", now_s)
    waits = []
    for _ in range(9):
        with pytest.raises(InputError, match="Too many wrong attempts"):
            check_pin(file, "123456", now_s)  # not even the right one
        wait_s = 1.0
        while True:
            try:
                assert not check_pin(file, "wrong", now_s + wait_s)
                break
            except InputError:
                wait_s += 1.0
        waits.append(wait_s)
        now_s += wait_s
    assert waits[:4] == [2.0, 4.0, 8.0, 16.0] and max(waits) <= LONGEST_WAIT_S
    assert check_pin(file, "123456", now_s + LONGEST_WAIT_S)
    assert not check_pin(file, "wrong", now_s + LONGEST_WAIT_S)  # counted anew


def test_a_clock_that_was_set_back_locks_nobody_out(tmp_path):
    file = tmp_path / "pin.json"
    set_pin(file, "123456")
    for _ in range(FREE_ATTEMPTS):
        check_pin(file, "wrong", 1e9)
    with pytest.raises(InputError, match="Wait 2 s"):
        check_pin(file, "123456", 1e8)


def test_a_short_pin_and_a_damaged_file_are_refused(tmp_path):
    file = tmp_path / "pin.json"
    with pytest.raises(InputError, match="fewer than 4"):
        set_pin(file, "123")
    assert not has_pin(file)
    file.write_text("{}")
    assert has_pin(file)  # damaging it opens nothing
    with pytest.raises(StorageError, match="damaged") as found:
        check_pin(file, "123456", 0.0)
    assert "--reset-engineer-pin" in found.value.hint


def test_a_forgotten_pin_is_removed_by_a_command(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("HOME", str(tmp_path))
    set_pin(pin_file(), "123456")
    assert main(["gui", "--reset-engineer-pin", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["pin_removed"] is True and not has_pin(pin_file())
    assert main(["gui", "--reset-engineer-pin"]) == 0
    assert "No PIN was set." in capsys.readouterr().out
