"""Whatever is given: exit code 2, one sentence that names it with a remedy, no traceback, and nothing left behind."""

from __future__ import annotations

import errno
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import cv2
import numpy as np
import pytest
import typer

from measureapp.cli import main
from measureapp.cli.main import build
from measureapp.data.mesh import Mesh
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.geometry_files import read_mesh, write_mesh
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource
from tests.cli.fringe_sets import write_paper_set

ROOT = Path(__file__).resolve().parents[2]
NOMINAL = str(resource("parts/gypsum/nominal.stl"))
PROGRAM = str(resource("parts/gypsum/program.toml"))
JUNK = ("absent", "folder", "empty", "garbage")
BOARD = ("--board", "9x6", "--square-mm", "10")

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
    ("rig check IN", "toml"),
    ("calibrate cameras --images left=IN --board 9x6 --square-mm 10 --out OUT.json", "png"),
    ("calibrate axis --corners IN --out OUT.json", "csv"),
    ("calibrate axis --images left=IMAGE --cameras IN --board 9x6 --square-mm 10 --out OUT.json", "json"),
    ("calibrate hand-eye --robot-poses IN --board-poses POSES --out OUT.json", "csv"),
    ("calibrate hand-eye --robot-poses POSES --board-poses IN --out OUT.json", "csv"),
    ("calibrate guide --robot-poses IN --guide-positions POSES --board-poses POSES --hand-eye POSES --out OUT.json", "csv"),
    ("calibrate guide --robot-poses POSES --guide-positions IN --board-poses POSES --hand-eye POSES --out OUT.json", "csv"),
    ("calibrate rig --robot-poses IN --guide-positions POSES --angles POSES --out OUT.json", "csv"),
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
    ("report IN --out OUT", ""),
    ("scan PLAN --rig paper --project OUT --calibration IN", ""),
]


@pytest.fixture(scope="module")
def shelf(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Sound files to go with the rubbish."""
    from measureapp.planning.viewpoints import plan_around_part

    folder = tmp_path_factory.mktemp("shelf")
    plan = plan_around_part(read_rig("paper"), "plan", radius_mm=100, height_mm=80, count=2)
    (folder / "plan.json").write_text(plan.model_dump_json(), encoding="utf-8")
    rows = [f"view{i:02d},{100 * i},20,300,1,0,0,0" for i in range(1, 7)]
    (folder / "poses.csv").write_text("\n".join(["name,x_mm,y_mm,z_mm,qw,qx,qy,qz", *rows]), encoding="utf-8")
    write_paper_set(folder)
    lens = {"width": 256, "height": 40, "matrix": [[400, 0, 128], [0, 400, 20], [0, 0, 1]], "distortion": [0] * 5}
    camera = {**lens, "reference_from_camera": np.eye(4).tolist()}
    (folder / "cameras.json").write_text(json.dumps({"schema_version": 1, "reference": "left", "cameras": {"left": camera}}))
    return folder


def refused(capsys: pytest.CaptureFixture[str], arguments: list[str], code: int = 2) -> str:
    """Run a command for people and for programs; return the sentence after all checks that every refusal must pass."""
    assert main(arguments) == code
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("measureapp: ") and said.err.endswith("\n") and said.err.count("\n") == 1, said.err
    assert "Traceback" not in said.err and "Errno" not in said.err
    assert main([*arguments, "--json"]) == code
    written = capsys.readouterr()
    assert written.err == ""
    document = json.loads(written.out)
    assert document.keys() == {"error"}
    assert document["error"].keys() == {"type", "message", "hint"}
    assert document["error"]["message"].endswith((".", "?", ")"))
    assert document["error"]["hint"].endswith(".")
    assert said.err == f"measureapp: {document['error']['message']} {document['error']['hint']}\n"
    return said.err


def filled(line: str, shelf: Path, out: Path, given: str) -> list[str]:
    known = {
        "NOMINAL": NOMINAL,
        "PROGRAM": PROGRAM,
        "PLAN": str(shelf / "plan.json"),
        "POSES": str(shelf / "poses.csv"),
        "CAMERAS": str(shelf / "cameras.json"),
        "MANIFEST": str(shelf / "MANIFEST.toml"),
        "left=IMAGE": f"left={shelf / 'left' / '1000_0.png'}",
        "IN": given,
        "left=IN": f"left={given}",
    }
    return [known.get(word, word.replace("OUT", str(out))) for word in line.split()]


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


def commands(group: object = None, before: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Every command of the command line, with the groups it lies in."""
    for name, command in (group or typer.main.get_command(build())).commands.items():  # type: ignore[attr-defined]
        if hasattr(command, "commands"):
            yield from commands(command, (*before, name))
        else:
            yield *before, name


ALL_COMMANDS = tuple(commands())


def test_every_command_that_reads_something_is_given_rubbish() -> None:
    tried = {tuple(line.split()) for line, _ in INPUTS}
    untried = [command for command in ALL_COMMANDS if not any(words[: len(command)] == command for words in tried)]
    assert sorted(untried) == [("board", "export"), ("gui",), ("patterns", "list"), ("plugins",)]  # without input, or tested elsewhere


@pytest.mark.parametrize("command", [command for command in ALL_COMMANDS if command != ("gui",)], ids=" ".join)
def test_an_unknown_option_is_refused(command: tuple[str, ...], capsys) -> None:
    assert "--no-such-option" in refused(capsys, [*command, "--no-such-option"])


def test_gui_refuses_what_is_no_project_and_an_unknown_option(tmp_path: Path, capsys) -> None:
    assert main(["gui", str(tmp_path / "absent")]) == main(["gui", "--no-such-option"]) == 2
    assert capsys.readouterr().err.count("\n") == 2


def test_an_unknown_command_is_refused(capsys) -> None:
    assert "nonsense" in refused(capsys, ["nonsense"])


def test_without_a_command_the_help_is_shown_and_a_program_is_told_what_is_missing(capsys) -> None:
    assert main([]) == 2
    assert "Commands:" in capsys.readouterr().err
    assert main(["calibrate", "--json"]) == 2
    assert main(["--json"]) == 2


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (["--part", "spanner"], "spanner"),
        (["--part", "spanner.step"], "spanner.step"),
        (["--viewpoints", "0"], "0 viewpoints"),
        (["--viewpoints", "-3"], "-3 viewpoints"),
        (["--viewpoints", "many"], "--viewpoints"),
        (["--resolution", "tiny"], "tiny"),
        (["--seed", "-1"], "--seed"),
    ],
)
def test_a_demo_of_something_impossible_is_refused(arguments: list[str], named: str, tmp_path: Path, capsys) -> None:
    assert named in refused(capsys, ["demo", *arguments, "--out", str(tmp_path / "out")])
    assert list(tmp_path.iterdir()) == []


def a_file(out: Path) -> None:
    out.write_text("dear reader")


def below_a_file(out: Path) -> None:
    out.parent.rmdir()
    out.parent.write_text("dear reader")


def something_else(out: Path) -> None:
    out.mkdir()
    (out / "letter.txt").write_text("dear reader")


def another_project(out: Path) -> None:
    ProjectFolder.create(out, ProjectSettings(name="another", part="gear", rig=read_rig("paper")))


def a_damaged_project(out: Path) -> None:
    another_project(out)
    (out / "project.json").write_text('{"schema_version": 1')


def not_writable(out: Path) -> None:
    if os.name != "posix" or os.geteuid() == 0:
        pytest.skip("everything can be written to")
    out.parent.chmod(0o500)


@pytest.mark.parametrize("prepared", [a_file, below_a_file, something_else, another_project, a_damaged_project, not_writable])
def test_a_demo_into_a_place_that_is_taken_leaves_it_as_it_was(prepared: Callable[[Path], None], tmp_path: Path, capsys) -> None:
    out = tmp_path / "folder" / "out"
    out.parent.mkdir()
    prepared(out)
    before = {path: path.read_bytes() if path.is_file() else None for path in tmp_path.rglob("*")}
    assert "out" in refused(capsys, ["demo", "--resolution", "quarter", "--viewpoints", "2", "--out", str(out)])
    assert {path: path.read_bytes() if path.is_file() else None for path in tmp_path.rglob("*")} == before


def test_a_demo_that_does_not_fit_on_the_disk_is_refused_before_anything_is_written(tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.setattr("shutil.disk_usage", lambda _: shutil._ntuple_diskusage(10**9, 10**9 - 10**6, 10**6))
    said = refused(capsys, ["demo", "--viewpoints", "2", "--out", str(tmp_path / "out")])
    assert "0.0 GB free" in said and "Free some space" in said
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "line",
    [
        "decode MANIFEST --out OUT",
        "calibrate hand-eye --robot-poses ROBOT --board-poses BOARD --out OUT/x.json",
    ],
)
def test_a_disk_that_runs_full_leaves_no_half_written_file(line: str, shelf: Path, tmp_path: Path, capsys, monkeypatch) -> None:
    if "ROBOT" in line:
        line = _hand_eye_tables(line, tmp_path)

    def full(_: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("os.fsync", full)
    said = refused(capsys, filled(line, shelf, tmp_path / "out", ""))
    assert "No space left on device" in said
    assert [path for path in (tmp_path / "out").rglob("*") if path.is_file()] == []


def _hand_eye_tables(line: str, folder: Path) -> str:
    from measureapp.geometry.transform import RigidTransform
    from measureapp.project.tables import write_poses

    rng = np.random.default_rng(4)
    robot, board = {}, {}
    flange_from_camera = RigidTransform.from_vector([0.1, 0.2, 0.3], [10, 20, 80], "flange", "camera")
    base_from_board = RigidTransform.from_vector([0.3, -0.2, 0.1], [600, 20, 80], "base", "board")
    for number in range(8):
        base_from_flange = RigidTransform.from_vector(rng.normal(0, 0.5, 3), rng.normal(0, 200, 3), "base", "flange")
        robot[f"p{number}"] = base_from_flange
        board[f"p{number}"] = (base_from_flange @ flange_from_camera).inverse() @ base_from_board
    write_poses(folder / "robot.csv", robot)
    write_poses(folder / "board.csv", board)
    return line.replace("ROBOT", str(folder / "robot.csv")).replace("BOARD", str(folder / "board.csv"))


@pytest.fixture
def fringes(tmp_path: Path) -> Path:
    return write_paper_set(tmp_path / "set")


def changed(manifest: Path, old: str, new: str) -> None:
    text = manifest.read_text(encoding="utf-8")
    assert old in text
    manifest.write_text(text.replace(old, new), encoding="utf-8")


@pytest.mark.parametrize(
    ("old", "new", "named"),
    [
        ("pitch_px = 33", "pitch_px = 32", "32"),  # two equal pitches
        ("pitch_px = 33", "pitch_px = 36", ""),  # their beat is shorter than the projector is wide
        ('"left/1000_3.png"', '"left/1000_2.png"', "more than once"),
        (', "left/1000_3.png"]', "]", "differ"),  # an image too few
        ("left/1000_3.png", "left/1000_9.png", "1000_9.png"),
        ('kind = "phase-shift"', 'kind = "moire"', "kind"),
        ("shift_sign = -1", "shift_sign = 0", "shift_sign"),
        ("pitch_px = 32", "pitch_px = nan", "pitch_px"),
        ("exposure_us = 500", "exposure_us = 1000", "exposure"),
        ("projector_px = 1024", "projector_px = 1024\nprojektor = 2", "projektor"),
    ],
)
def test_a_manifest_that_cannot_be_right_is_refused(old: str, new: str, named: str, fringes: Path, tmp_path: Path, capsys) -> None:
    changed(fringes, old, new)
    assert named in refused(capsys, ["decode", str(fringes), "--out", str(tmp_path / "out")])
    assert not (tmp_path / "out").exists()


def cut_in_half(path: Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


@pytest.mark.parametrize("ending", ["png", "tif", "bmp"])
def test_an_image_cut_in_half_is_refused(ending: str, fringes: Path, tmp_path: Path, capsys) -> None:
    image = fringes.parent / "left" / f"half.{ending}"
    cv2.imwrite(str(image), cv2.imread(str(fringes.parent / "left" / "1000_1.png"), cv2.IMREAD_UNCHANGED))
    changed(fringes, "left/1000_1.png", f"left/half.{ending}")
    assert main(["decode", str(fringes), "--out", str(tmp_path / "sound")]) == 0
    capsys.readouterr()
    cut_in_half(image)
    assert image.name in refused(capsys, ["decode", str(fringes), "--out", str(tmp_path / "out")])
    assert not (tmp_path / "out").exists()


def test_an_image_of_another_size_is_refused(fringes: Path, tmp_path: Path, capsys) -> None:
    cv2.imwrite(str(fringes.parent / "left" / "500_5.png"), np.zeros((40, 255), np.uint8))
    assert "500_5.png" in refused(capsys, ["decode", str(fringes), "--out", str(tmp_path / "out")])
    assert not (tmp_path / "out").exists()


def test_cameras_that_did_not_take_the_images_are_refused(fringes: Path, shelf: Path, tmp_path: Path, capsys) -> None:
    other = tmp_path / "cameras.json"
    other.write_text((shelf / "cameras.json").read_text().replace('"width": 256', '"width": 640'))
    said = refused(capsys, ["reconstruct", str(fringes), "--cameras", str(other), "--out", str(tmp_path / "out.ply")])
    assert "calibrated for 640 × 40 px" in said
    other.write_text((shelf / "cameras.json").read_text().replace('"left"', '"lower"'))
    said = refused(capsys, ["reconstruct", str(fringes), "--cameras", str(other), "--out", str(tmp_path / "out.ply")])
    assert "has no camera 'left'" in said
    assert not (tmp_path / "out.ply").exists()


@pytest.fixture(scope="module")
def halves(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """A mesh of every kind that says how long it is, cut in half."""
    import trimesh

    folder = tmp_path_factory.mktemp("halves")
    mesh: Mesh = read_mesh(Path(NOMINAL))
    files = {kind: folder / f"{kind}.{kind.split('_')[-1]}" for kind in ("binary_ply", "binary_stl", "ascii_ply", "ascii_stl")}
    write_mesh(files["binary_ply"], mesh)
    write_mesh(files["binary_stl"], mesh)
    plain = trimesh.Trimesh(mesh.vertices_mm, mesh.triangles, process=False)
    plain.export(files["ascii_ply"], encoding="ascii")
    plain.export(files["ascii_stl"], file_type="stl_ascii")
    for path in files.values():
        assert len(read_mesh(path).triangles) == len(mesh.triangles)
        cut_in_half(path)
    return files


@pytest.mark.parametrize("kind", ["binary_ply", "binary_stl", "ascii_ply", "ascii_stl"])
@pytest.mark.parametrize(
    "line",
    [
        "fit plane IN",
        "measure IN PROGRAM",
        "compare IN NOMINAL",
        "compare NOMINAL IN",
        "demo --part IN --out OUT",
    ],
)
def test_a_mesh_cut_in_half_is_refused(line: str, kind: str, halves: dict[str, Path], shelf: Path, tmp_path: Path, capsys) -> None:
    assert halves[kind].name in refused(capsys, filled(line, shelf, tmp_path / "out", str(halves[kind])))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("content", [b"", b"[]", b"{}", b"null", b'{"schema_version": 1', b"\xff\xfe\x00"])
@pytest.mark.parametrize(
    "damaged", ["project.json", "plan.json", "calibration/rig.json", "calibration/cameras.json", "results/measurement.json"]
)
def test_a_damaged_project_is_refused_by_the_name_of_the_file(damaged: str, content: bytes, demo, tmp_path: Path, capsys) -> None:
    project = tmp_path / "project"
    for name in ("project.json", "plan.json", "calibration/rig.json", "calibration/cameras.json", "results/measurement.json"):
        (project / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(demo.folder / name, project / name)
    (project / damaged).write_bytes(content)
    command = "report" if damaged.startswith(("calibration", "results")) else "process" if damaged == "project.json" else None
    if command is None:  # the plan is read by a scan only
        plan = shutil.copyfile(demo.folder / "plan.json", tmp_path / "plan.json")
        (project / "stacks" / "view01").mkdir(parents=True)
        shutil.copyfile(demo.folder / "stacks" / "view01" / "stack.json", project / "stacks" / "view01" / "stack.json")
        rig = tmp_path / "rig.toml"
        rig.write_text(resource("rigs/paper.toml").read_text().replace("= 2592", "= 648").replace("= 1944", "= 486"))
        said = refused(capsys, ["scan", str(plan), "--rig", str(rig), "--project", str(project), "--resume"])
    else:
        said = refused(capsys, [command, str(project)])
    assert Path(damaged).name in said or str(Path(damaged).parent) in said
    assert not (project / "report").exists()


def test_a_project_without_images_has_nothing_to_process(tmp_path: Path, capsys) -> None:
    another_project(tmp_path / "bare")
    said = refused(capsys, ["process", str(tmp_path / "bare")])
    assert "neither a calibration nor images of the board" in said


def test_a_path_that_no_system_can_have_is_refused(shelf: Path, capsys) -> None:
    for line in ("compare NOMINAL NOMINAL --align IN", "fit plane IN", "process IN"):
        refused(capsys, filled(line, shelf, Path("out"), "\0"))


def test_an_encoding_that_lacks_a_character_gets_a_question_mark(tmp_path: Path) -> None:
    points = tmp_path / "points.xyz"
    np.savetxt(points, np.random.default_rng(5).normal(0, [10, 10, 0.01], (50, 3)))
    code = "import sys; from measureapp.cli import main; sys.exit(main(['fit', 'plane', sys.argv[1]]))"
    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-c", code, str(points)], env=environment, capture_output=True, text=True, check=False, timeout=60
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "? position_mm" in done.stdout  # σ
