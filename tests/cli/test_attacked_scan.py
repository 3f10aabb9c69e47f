"""`scan` on a virtual rig that is attacked: everything is stopped, and no wrong image is kept."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from measureapp.cli import main
from measureapp.data.plan import ExposureBracket
from measureapp.resources import plugin_folder
from tests.cli.attacked_plugin import write_plugin
from tests.cli.rig_files import write_binned_rig

AXES = {"VirtualRobot", "VirtualGuide", "VirtualTable"}
ALL = {*AXES, "VirtualCamera", "VirtualProjector"}
SHIPPED = plugin_folder()
PROGRAM = """
import pathlib, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have started the tests without it
import measureapp.devices.plugin_loader as loader
loader.plugin_folder, loader.is_allowed = lambda: pathlib.Path(sys.argv[1]), lambda folder: True
from measureapp.cli.main import main
sys.exit(main(sys.argv[2:]))
"""
Scan = Callable[..., list[str]]


@pytest.fixture
def plugins(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "plugins"
    write_plugin(folder)
    monkeypatch.setattr("measureapp.devices.plugin_loader.plugin_folder", lambda: folder)
    monkeypatch.setattr("measureapp.devices.plugin_loader.is_allowed", lambda _: True)
    return folder


@pytest.fixture
def arguments(tmp_path: Path) -> Callable[..., list[str]]:
    """The words of the command, for viewpoints between which only the table turns, with two exposures."""
    from measureapp.planning.viewpoints import plan_around_part
    from measureapp.project.rig_file import read_rig

    plan = plan_around_part(read_rig("paper"), "plan", radius_mm=100, height_mm=80, count=4)

    def words(attack: str, views: int = 3, time_scale: float = 0.0) -> list[str]:
        viewpoints = tuple(
            plan.viewpoints[0].model_copy(update={"id": f"v{index}", "table_deg": 90.0 * index + 10.0}) for index in range(views)
        )
        changed = plan.model_copy(update={"viewpoints": viewpoints, "bracket": ExposureBracket(exposures_us=(80_000, 40_000))})
        (tmp_path / "plan.json").write_text(changed.model_dump_json(), encoding="utf-8")
        settings = f'attack = "{attack}", record = "{tmp_path / "record"}", shipped = "{SHIPPED}", time_scale = {time_scale}'
        rig = write_binned_rig(tmp_path / "rig.toml", settings, binning=8)
        rig.write_text(rig.read_text(encoding="utf-8").replace('driver = "virtual_rig"', 'driver = "attacked_rig"'), encoding="utf-8")
        return ["scan", str(tmp_path / "plan.json"), "--rig", str(rig), "--project", str(tmp_path / "project"), "--json"]

    return words


def record(tmp_path: Path, what: str) -> list[tuple[float, str]]:
    lines = (tmp_path / "record").read_text(encoding="utf-8").splitlines()
    return [(float(line.split()[0]), line.split()[2]) for line in lines if line.split()[1] == what]


def answer(words: list[str], capsys: pytest.CaptureFixture[str]) -> tuple[int, dict[str, Any]]:
    code = main(words)
    return code, json.loads(capsys.readouterr().out)


def stored(tmp_path: Path) -> list[str]:
    return sorted(path.parent.name for path in (tmp_path / "project" / "stacks").glob("*/stack.json"))


@pytest.mark.parametrize(
    ("attack", "kind", "words"),
    [
        ("oserror", "DeviceLost", "The rotary table failed: ConnectionResetError: [Errno 104] Connection reset by peer"),
        ("stuck", "MotionError", "v1: the table stopped at 10.000°"),
        ("value error", "DeviceLost", "The measuring head failed: ValueError: bad reply"),
        ("turning", "MotionError", "v0: the robot moved while images were taken"),
    ],
)
def test_an_axis_that_fails_is_told_stops_every_device_and_nothing_moves_afterwards(
    attack: str, kind: str, words: str, plugins: Path, arguments: Scan, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, document = answer(arguments(attack), capsys)
    assert (code, document["error"]["type"]) == (3, kind), document
    assert words in document["error"]["message"]
    stops, moves = record(tmp_path, "stop"), record(tmp_path, "move")
    assert {name for _, name in stops} == ALL
    assert max(moment for moment, _ in moves) <= min(moment for moment, _ in stops)
    assert stored(tmp_path) == (["v0"] if attack in ("oserror", "stuck") else [])


def test_a_robot_that_fails_to_stop_keeps_no_other_device_moving(plugins: Path, arguments: Scan, tmp_path: Path) -> None:
    main(arguments("stop fails"))
    assert {name for _, name in record(tmp_path, "stop")} == ALL - {"VirtualRobot"}


@pytest.mark.parametrize("attack", ["all stale", "half black", "half exposure"])
def test_a_view_with_a_wrong_image_is_refused_and_the_others_are_kept(
    attack: str, plugins: Path, arguments: Scan, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, document = answer(arguments(attack, views=2), capsys)
    states = {view["name"]: view["state"] for view in document["views"]}
    assert (code, states) == (3, {"v0": "stored", "v1": "failed"})
    assert "right" in document["views"][1]["reason"]
    assert stored(tmp_path) == ["v0"]


@pytest.mark.timed
@pytest.mark.parametrize("ending", [name for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)])
def test_ctrl_c_during_a_move_stops_every_device_is_told_and_leaves_a_project_to_resume(
    ending: str, plugins: Path, arguments: Scan, tmp_path: Path
) -> None:
    """The real command, interrupted by its parent while the table turns; so when its terminal is closed, or the computer shuts down."""
    command = [sys.executable, "-c", PROGRAM, str(plugins), *arguments("", time_scale=1.0)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=dict(os.environ))
    end = time.monotonic() + 60.0
    while not ((tmp_path / "record").exists() and record(tmp_path, "move")):
        assert time.monotonic() < end and process.poll() is None, "no move began"
        time.sleep(0.02)
    time.sleep(0.3)
    interrupted = time.time()
    process.send_signal(getattr(signal, ending))
    out, said = process.communicate(timeout=30.0)
    assert process.returncode == 130
    assert json.loads(out)["error"]["type"] == "Cancelled"
    assert "0 of 3 viewpoints are stored and kept; not v0, v1, v2." in said
    assert "Run the same command with --resume." in said
    stops = record(tmp_path, "stop")
    assert {name for _, name in stops} == ALL
    assert max(moment for moment, _ in stops) - interrupted < 0.5
    assert stored(tmp_path) == []
    assert not list(tmp_path.rglob("*.part*"))
