"""Every input of every command, given rubbish: exit code 2, one sentence that names it with a remedy, nothing left behind."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.cli.command_names import ALL_COMMANDS
from tests.cli.refusal import filled, refused

JUNK = ("absent", "folder", "empty", "garbage")

# Every command with each of its inputs in turn as IN; the kind of file it is; OUT is where it may write.
INPUTS: list[tuple[str, str]] = [
    ("decode IN --out OUT", "toml"),
    ("reconstruct IN --cameras CAMERAS --out OUT.ply", "toml"),
    ("reconstruct MANIFEST --cameras IN --out OUT.ply", "json"),
    ("decode MANIFEST --noise IN --out OUT", "json"),
    ("decode MANIFEST --response IN --out OUT", "json"),
    ("why IN --cameras CAMERAS", "toml"),
    ("why MANIFEST --cameras IN", "json"),
    ("patterns check IN", "toml"),
    ("patterns export IN --out OUT", "json"),
    ("patterns export paper --response IN --out OUT", "json"),
    ("patterns compare three-close --part IN", "stl"),
    ("response IN --out OUT.json", "toml"),
    ("response IN --out OUT.json", "csv"),
    ("noise --images left=IN --out OUT.json", "png"),
    ("bracket IN --budget-s 3", "toml"),
    ("filter IN --radius-mm 1 --least 3 --out OUT.ply", "ply"),
    ("fit plane IN", "ply"),
    ("fit sphere IN --criterion minimum-zone", "xyz"),
    ("measure IN PROGRAM", "ply"),
    ("measure NOMINAL IN", "toml"),
    ("compare IN NOMINAL", "pcd"),
    ("compare NOMINAL IN", "obj"),
    ("compare NOMINAL NOMINAL --align IN", "json"),
    ("stitch IN --poses POSES --out OUT.ply", "ply"),
    ("stitch NOMINAL --poses IN --out OUT.ply", "csv"),
    ("demo --part IN --out OUT", "stl"),
    ("demo --part IN --out OUT", "ply"),
    ("scan IN --rig paper --project OUT", "json"),
    ("scan PLAN --rig IN --project OUT", "toml"),
    ("scan IN --rig paper --project OUT", "mpart"),
    ("plan check IN --rig paper", "toml"),
    ("plan check PLAN --rig IN", "toml"),
    ("plan check PLAN --rig paper --nominal IN", "stl"),
    ("plan show IN --rig paper --out OUT.png", "json"),
    ("plan show PLAN --rig IN", "toml"),
    ("plan show PLAN --rig paper --nominal IN --out OUT.svg", "ply"),
    ("plan edit IN --out OUT.toml", "toml"),
    ("plan edit PLAN --add a=0,0,40:0,60 --rig IN --out OUT.toml", "toml"),
    ("plan make IN --rig paper --out OUT.toml", "stl"),
    ("plan make NOMINAL --rig IN --out OUT.toml", "toml"),
    ("plan make NOMINAL --rig paper --pose IN --out OUT.toml", "txt"),
    ("program pack IN --out OUT.mpart", "json"),
    ("program pack PLAN --inspection IN --out OUT.mpart", "toml"),
    ("program pack PLAN --picture IN --out OUT.mpart", "png"),
    ("program release IN --by Nobody", "mpart"),
    ("campaign IN", "toml"),
    ("capacity IN", "json"),
    ("program show IN", "mpart"),
    ("program unpack IN --out OUT", "mpart"),
    ("plan predict IN", ""),
    ("plan predict IN --rig paper --program PROGRAM", "json"),
    ("plan predict PLAN --rig IN --program PROGRAM", "toml"),
    ("plan predict PLAN --rig paper --program IN", "toml"),
    ("plan predict PLAN --rig paper --program PROGRAM --calibration IN", ""),
    ("plan extend IN", ""),
    ("import IN --into OUT", "toml"),
    ("rig check IN", "toml"),
    ("rig latency IN", "toml"),
    ("rig teach IN guide", "toml"),
    ("rig peers OUT.toml --rig IN", "toml"),
    ("rig peers OUT.toml --part IN", "stl"),
    ("calibrate cameras --images left=IN --board 9x6 --square-mm 10 --out OUT.json", "png"),
    ("calibrate axis --corners IN --out OUT.json", "csv"),
    ("calibrate axis --images left=IMAGE --cameras IN --board 9x6 --square-mm 10 --out OUT.json", "json"),
    ("calibrate hand-eye --robot-poses IN --board-poses POSES --out OUT.json", "csv"),
    ("calibrate hand-eye --robot-poses POSES --board-poses IN --out OUT.json", "csv"),
    ("calibrate guide --robot-poses IN --guide-positions POSES --board-poses POSES --hand-eye POSES --out OUT.json", "csv"),
    ("calibrate guide --robot-poses POSES --guide-positions IN --board-poses POSES --hand-eye POSES --out OUT.json", "csv"),
    ("calibrate rig --robot-poses IN --guide-positions POSES --angles POSES --out OUT.json", "csv"),
    ("calibrate run --rig IN --project OUT", "toml"),
    ("calibrate run --rig paper --plan IN --project OUT", "json"),
    ("calibrate check --calibration POSES --robot-poses POSES --guide-positions IN --angles POSES", "csv"),
    ("calibrate check --project IN", ""),
    ("calibrate history IN", ""),
    ("calibrate again IN", "json"),
    ("calibrate projector IN --board 9x6 --square-mm 10 --out OUT.json", "toml"),
    ("calibrate projector MANIFEST --board 9x6 --square-mm 10 --cameras IN --out OUT.json", "json"),
    ("calibrate collect cameras --session OUT --images left=IN --board 9x6 --square-mm 10", "png"),
    ("calibrate collect axis --session OUT --images left=IMAGE --cameras IN --board 9x6 --square-mm 10", "json"),
    ("calibrate collect rig --session OUT --views IN", ""),
    ("rig check paper --calibration IN", ""),
    ("process IN", ""),
    ("verify IN", ""),
    ("exposures IN", ""),
    ("raw IN", ""),
    ("discard IN view01", ""),
    ("report IN --out OUT", ""),
    ("repeat IN IN --out OUT", ""),
    ("join IN PROJECT --out OUT", ""),
    ("scan PLAN --rig paper --project OUT --calibration IN", ""),
    ("program of IN --out OUT", ""),
    ("program start IN --project OUT", "mpart"),
    ("sample pack IN OUT --title Part", ""),
    ("series add IN", ""),
    ("series rebuild PROGRAM IN", ""),
]


def junk(kind: str, ending: str, folder: Path) -> Path:
    path = folder / (f"{kind}.{ending}" if ending else kind)
    if kind == "folder":
        path.mkdir()
    elif kind == "empty":
        path.touch()
    elif kind == "garbage":
        path.write_bytes(np.random.default_rng(3).integers(0, 256, 3000, np.uint8).tobytes())
    return path


@pytest.mark.parametrize("kind", JUNK)
@pytest.mark.parametrize(("line", "ending"), INPUTS)
def test_rubbish_is_refused_by_name(line: str, ending: str, kind: str, shelf: Path, tmp_path: Path, capsys) -> None:
    given = junk(kind, ending, tmp_path)
    before = sorted(tmp_path.rglob("*"))
    said = refused(capsys, filled(line, shelf, tmp_path / "out", str(given)))
    assert given.name in said
    assert sorted(tmp_path.rglob("*")) == before


def test_every_command_that_reads_something_is_given_rubbish() -> None:
    tried = {tuple(line.split()) for line, _ in INPUTS}
    untried = [command for command in ALL_COMMANDS if not any(words[: len(command)] == command for words in tried)]
    named = [("series", "list"), ("series", "report"), ("series", "show")]  # of a series by its name
    assert sorted(untried) == [
        ("board", "export"),
        ("gui",),
        ("patterns", "list"),
        ("plugins",),
        ("sample", "list"),
        ("sample", "open"),
        *named,
    ]  # without input, or tested elsewhere


@pytest.mark.parametrize(
    "line",
    [
        "calibrate axis --corners IN --out .",
        "noise --fringes IN --out /",
        "response IN --out .",
        "decode IN --out IN",
        "repeat IN IN --out IN",
    ],
)
def test_a_folder_in_the_place_of_a_file_is_refused_and_a_file_in_that_of_a_folder(line: str, shelf: Path, tmp_path: Path, capsys) -> None:
    given = junk("garbage", "toml", tmp_path)
    said = refused(capsys, filled(line, shelf, tmp_path / "out", str(given)))
    assert "is a directory" in said or "is a file" in said


def test_a_cloud_is_never_replaced_by_what_is_made_of_it(tmp_path: Path, capsys) -> None:
    cloud = tmp_path / "cloud.xyz"
    np.savetxt(cloud, np.eye(3))
    assert "is the cloud to be filtered" in refused(capsys, ["filter", str(cloud), "--box=-9,9,-9,9,-9,9", "--out", str(cloud)])
    poses = tmp_path / "poses.csv"
    poses.write_text("name,x_mm,y_mm,z_mm,qw,qx,qy,qz\ncloud,0,0,0,1,0,0,0\n", encoding="utf-8")
    assert "is one of the clouds" in refused(capsys, ["stitch", str(cloud), "--poses", str(poses), "--out", str(cloud)])
