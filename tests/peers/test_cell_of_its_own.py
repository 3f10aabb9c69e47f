"""A virtual cell in a program of its own: the true drivers move it, and the simulated head in another program sees what it should see."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from measureapp.acquire.jog import jog
from measureapp.devices.connect import connect_rig
from measureapp.devices.projector import PLAIN_LIGHT
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceLost
from measureapp.peers.positions import CellPositions, PositionsAsked, tell_positions
from measureapp.progress import NoProgress
from measureapp.project.rig_file import read_rig

COMMAND = "import sys; from measureapp.cli.main import main; sys.exit(main(sys.argv[1:]))"


@pytest.fixture
def cell(tmp_path: Path) -> Iterator[tuple[subprocess.Popen[str], Path]]:
    path, pipe = tmp_path / "cell.toml", subprocess.PIPE
    command = [sys.executable, "-u", "-c", COMMAND, "rig", "peers", str(path), "--quick"]
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe, text=True) as process:
        assert process.stdout is not None
        assert "Robot controller" in process.stdout.readline()
        while "Ctrl+C" not in process.stdout.readline():
            assert process.poll() is None
        yield process, path
        process.kill()


def seen(rig: Rig) -> np.ndarray:
    """An image of the reference camera under uniform light."""
    camera = rig.cameras[rig.description.reference]
    rig.projector.show(PLAIN_LIGHT, timeout_s=5.0)
    camera.arm(1, "software")
    camera.trigger()
    return camera.next_frame(timeout_s=5.0).pixels.astype(float)


def test_the_head_sees_what_lies_on_the_table_and_where_the_axes_moved_to(cell) -> None:
    process, path = cell
    rig = connect_rig(read_rig(path))
    try:
        empty = seen(rig)
        process.stdin.write("nonsense\npart\n")
        process.stdin.flush()
        assert "There is no 'nonsense'" in process.stderr.readline()
        assert process.stderr.readline() == "On the table: part.\n"
        part = seen(rig)
        assert abs(part - empty).max() > 20.0
        reached = jog(rig, "table", 10.0, NoProgress())
        assert reached.table_rad == pytest.approx(np.radians(10.0), abs=1e-4)
        assert abs(seen(rig) - part).max() > 20.0
        process.kill()
        process.wait()
        with pytest.raises(DeviceLost, match=r"virtual cell at 127\.0\.0\.1:\d+ does not answer.*measureapp rig peers"):
            seen(rig)
    finally:
        rig.close()


def test_an_address_where_nothing_answers_is_named() -> None:
    with tell_positions(CellPositions()) as address:
        asked = PositionsAsked(address)
        assert asked.ask()["table_holds"] == "empty"
        asked.close()
    for wrong in (address, "nowhere", "127.0.0.1:99999"):
        with pytest.raises(DeviceLost, match=f"virtual cell at {wrong}"):
            PositionsAsked(wrong)
