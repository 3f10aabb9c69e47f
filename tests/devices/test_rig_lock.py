"""Row N4 of the table of faults: two programs on one cell; the second one is told who has it, and sends nothing."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from measureapp.data.rig import RigDescription
from measureapp.devices.connect import connect_rig
from measureapp.devices.rig_lock import folder_of_locks, hold_rig, places
from measureapp.errors import DeviceError
from measureapp.project.rig_file import read_rig

from .test_connect import DEVICE, composed, make_plugin

HOLDER = """
import sys, time
from measureapp.data.rig import RigDescription
from measureapp.devices.rig_lock import hold_rig
release = hold_rig(RigDescription.model_validate_json(sys.stdin.readline()))
print("held", flush=True)
sys.stdin.readline()
release()
print("released", flush=True)
sys.stdin.readline()
"""


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


@contextmanager
def another_program(rig: RigDescription) -> Iterator[subprocess.Popen[str]]:
    """A second process that holds ``rig``."""
    pipe = subprocess.PIPE
    with subprocess.Popen([sys.executable, "-c", HOLDER], stdin=pipe, stdout=pipe, text=True, env=dict(os.environ)) as process:
        try:
            tell(process, rig.model_dump_json(), "held")
            yield process
        finally:
            process.kill()


def tell(process: subprocess.Popen[str], line: str, answer: str) -> None:
    assert process.stdin is not None and process.stdout is not None
    process.stdin.write(line + "\n")
    process.stdin.flush()
    assert process.stdout.readline() == answer + "\n"


def cell(address: str = "http://192.168.125.1", name: str = "cell 1") -> RigDescription:
    robot = {"driver": "robot_abb", "settings": {"address": address}}
    return composed({"robot": robot}, {"bus": {"port": "COM3"}}).model_copy(update={"name": name})


def test_a_second_program_is_told_process_user_and_time_of_the_first_and_connects_nothing(tmp_path: Path) -> None:
    make_plugin(tmp_path, "thing", "def connect(request): raise AssertionError('something was sent')")
    rig = composed({}, {"bus": {"port": "COM3"}})
    with another_program(rig) as first:
        with pytest.raises(
            DeviceError, match=rf"is in use: another program, process {first.pid} \(user .+ at .+, since 20\d\d-.*has connected"
        ) as told:
            connect_rig(rig, tmp_path)
        assert "Projects can be opened" in told.value.hint
        tell(first, "", "released")
        hold_rig(rig)()


def test_the_lock_of_a_program_that_was_killed_is_taken_over(tmp_path: Path) -> None:
    with another_program(cell()) as first:
        first.kill()
        first.wait()
        release = hold_rig(cell())
        holders = {json.loads(path.read_text())["process"] for path in folder_of_locks().glob("*.json")}
        assert holders == {os.getpid()}
        release()


def test_a_rig_that_is_closed_or_fails_to_connect_is_free_again(tmp_path: Path) -> None:
    make_plugin(tmp_path, "thing", DEVICE)
    make_plugin(tmp_path, "dead", "def connect(request): raise TimeoutError('silent')")
    for _ in range(2):
        rig = connect_rig(composed({}), tmp_path)
        with pytest.raises(DeviceError, match="in use: this program"):
            connect_rig(composed({}), tmp_path)
        rig.close()
        with pytest.raises(DeviceError, match="silent"):
            connect_rig(composed({"robot": {"driver": "dead"}}), tmp_path)


def test_two_descriptions_of_one_robot_exclude_each_other_and_two_cells_do_not() -> None:
    other_cameras = tuple(camera.model_copy(update={"serial": f"other {camera.serial}"}) for camera in cell().cameras)
    beside = cell("http://192.168.125.2").model_copy(update={"cameras": other_cameras, "links": {}})
    release = hold_rig(cell())
    with pytest.raises(DeviceError, match=r"Rig copy is in use.*address http://192\.168\.125\.1"):
        hold_rig(cell(name="copy").model_copy(update={"cameras": other_cameras, "links": {}}))
    hold_rig(beside)()
    release()


def test_simulated_rigs_are_never_locked_and_one_without_addresses_by_its_name() -> None:
    assert places(read_rig("paper")) == ()
    cameras = tuple(camera.model_copy(update={"serial": ""}) for camera in cell().cameras)
    assert places(composed({}).model_copy(update={"cameras": cameras, "name": "cell 7"})) == ("cell 7",)


def test_a_folder_that_cannot_be_written_to_is_told_and_keeps_nobody_from_the_rig(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "file"))
    hold_rig(cell())()
    assert "cannot be locked" in caplog.text
