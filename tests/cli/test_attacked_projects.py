"""Every row of the table of attacks that concerns a project on disk, held by a test named after its row; the others are in its neighbours.

Rows 1, 3, 7, 8 and 9 are in `test_attacked_scan`; row 10 in `tests/project/journal/test_flipped_bits`,
row 4 and 17 in `tests/project/journal/test_every_write_fails_once`, row 16 in `tests/project/journal/test_kill`.
"""

from __future__ import annotations

import errno
import io
import json
import os
import shutil
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

from measureapp.cli import main
from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.plan import FlangePose, ScanPlan, Viewpoint
from measureapp.errors import DiskFailed, StorageError
from measureapp.project import upkeep
from measureapp.project.array_files import read_npz
from measureapp.project.folder import ProjectFolder
from measureapp.project.journal import database, publish
from measureapp.project.rig_file import read_rig
from measureapp.report.csv import csv_text
from measureapp.report.model import Details
from tests.cli.refusal import refused
from tests.project.journal.whole_project import copied, stack, whole_project

AT_ORIGIN = FlangePose(position_mm=(0.0, 0.0, 0.0), quaternion_wxyz=(1.0, 0.0, 0.0, 0.0))
NESTED = "[" * 100_000


@pytest.fixture(scope="module")
def template(tmp_path_factory: pytest.TempPathFactory) -> ProjectFolder:
    return whole_project(tmp_path_factory.mktemp("whole") / "project")


@pytest.fixture
def project(template: ProjectFolder, tmp_path: Path) -> ProjectFolder:
    return copied(template, tmp_path / "project")


@pytest.fixture
def old(project: ProjectFolder) -> ProjectFolder:
    """Without a journal, as the version before left it: nothing but the readers themselves can notice what is wrong."""
    for path in (project.path / database.JOURNAL, project.path / publish.SEAL):
        path.unlink()
    return ProjectFolder.open(project.path)


def change(path: Path, **fields: object) -> None:
    path.write_text(json.dumps(json.loads(path.read_text(encoding="utf-8")) | fields), encoding="utf-8")


def test_row_2_images_and_read_backs_that_were_changed_are_not_loaded(project: ProjectFolder) -> None:
    description = project.path / "stacks" / "view02" / "stack.json"
    document = json.loads(description.read_text(encoding="utf-8"))
    document["readback"]["table_rad"] += 0.0192
    description.write_text(json.dumps(document, indent=2) + "\n", encoding="utf-8")
    for load in (project.frames.load, project.frames.readback, project.frames.conditions, project.frames.approach):
        with pytest.raises(StorageError, match=r"stack\.json is not what was stored.*measureapp discard PROJECT view02"):
            load("view02")
    assert project.frames.load("view01").viewpoint_id == "view01"


def test_row_4_results_are_replaced_only_when_the_new_ones_are_written_completely(project: ProjectFolder, monkeypatch) -> None:
    measured = project.measurement()
    assert measured is not None

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    before = {path: path.read_bytes() for path in sorted(project.results.rglob("*")) if path.is_file()}
    for writer in ("write_cloud", "write_json"):
        with monkeypatch.context() as patch, pytest.raises(StorageError, match="No space left"):
            patch.setattr(f"measureapp.project.results.{writer}", full)
            project.save_measurement(replace(measured, project="another"))
        assert {path: path.read_bytes() for path in sorted(project.results.rglob("*")) if path.is_file()} == before
    assert project.measurement() is not None


@pytest.mark.parametrize("name", ["..", ".", "", "../x", "a/b", "/etc", ".hidden", "a\n", "C:\\x", "x" * 101])
def test_row_5_a_viewpoint_whose_id_is_no_name_of_a_folder_is_refused(name: str) -> None:
    with pytest.raises(ValidationError):
        ScanPlan(name="plan", viewpoints=(Viewpoint(id=name, flange=AT_ORIGIN, guide_mm=0.0, table_deg=0.0),))


@pytest.mark.parametrize("name", ["../../../evil", "/evil", "", "..", "a/b", "x" * 70])
def test_row_6_a_camera_whose_name_is_no_name_of_a_file_is_refused(name: str) -> None:
    rig = read_rig("paper").model_dump()
    rig["cameras"][0]["name"] = name
    with pytest.raises(ValidationError):
        type(read_rig("paper")).model_validate(rig | {"reference": name})


@pytest.mark.parametrize(
    "file", ["project.json", "plan.json", "calibration/rig.json", "calibration/cameras.json", "results/measurement.json"]
)
def test_row_11_a_deeply_nested_document_is_refused_in_words(file: str, old: ProjectFolder, capsys) -> None:
    (old.path / file).write_text(NESTED, encoding="utf-8")
    command = ["report"] if file.startswith(("calibration", "results")) else ["process", "--check"]
    if file == "plan.json":
        with pytest.raises(StorageError, match=r"plan\.json cannot be read"):
            old.plan()
    else:
        assert Path(file).name in refused(capsys, [command[0], str(old.path), *command[1:]]) or file.startswith(("calibration", "results"))
    upkeep.verify(old.path)


def test_row_11_a_face_of_an_obj_beyond_64_bits_is_refused_in_words(tmp_path: Path, capsys) -> None:
    path = tmp_path / "huge.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999999\n", encoding="utf-8")
    assert "huge.obj" in refused(capsys, ["fit", "sphere", str(path)])


def test_row_12_documents_of_a_newer_version_are_refused_in_words(old: ProjectFolder) -> None:
    change(old.path / "stacks" / "view01" / "stack.json", schema_version=99)
    change(old.path / "results" / "measurement.json", schema_version=99)
    for use in (lambda: old.frames.load("view01"), old.measurement):
        with pytest.raises(StorageError, match="written by a newer version"):
            use()
    change(old.path / "calibration" / "rig.json", schema_version=99)
    with pytest.raises(StorageError, match="written by a newer version"):
        old.calibration()


def test_row_13_a_description_that_names_files_outside_its_folder_is_refused(old: ProjectFolder) -> None:
    outside = old.path.parent / "outside.npy"
    shutil.copyfile(old.path / "stacks" / "view01" / "left.npy", outside)
    for name in ("../../../outside.npy", str(outside), "..\\outside.npy", "left"):
        change(old.path / "stacks" / "view01" / "stack.json", checksums={name: "0"})
        with pytest.raises(StorageError, match="no image file of this viewpoint"):
            old.frames.load("view01")
    document = json.loads((old.path / "results" / "measurement.json").read_text(encoding="utf-8"))
    document["views"][0]["viewpoint_id"] = "../../outside"
    (old.path / "results" / "measurement.json").write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(StorageError, match="not the id of a viewpoint"):
        old.measurement()
    change(old.path / "calibration" / "views" / "board01" / "view.json", cameras=["../../../../outside"])
    with pytest.raises(StorageError, match="not names"):
        old.board_views()


@pytest.mark.parametrize("name", ['=HYPERLINK("http://x")', "+cmd|' /C calc'!A0", "@SUM(1)", "-1+1", "\t=1"])
def test_row_14_a_name_that_a_spreadsheet_would_carry_out_is_a_text_in_the_table(name: str) -> None:
    dimension = Dimension(name, 180.0, 180.02, 0.04, -0.1, 0.1, Verdict.PASS)
    lines = csv_text(_Model((dimension,))).splitlines()  # type: ignore[arg-type]
    assert lines[1].lstrip('"').startswith(f"'{name[0]}")


class _Model:
    """The part of a report that the table uses."""

    def __init__(self, dimensions: tuple[Dimension, ...]) -> None:
        self.dimensions, self.details = dimensions, Details()


def test_row_15_a_project_that_was_deleted_during_a_scan_is_reported_and_not_made_anew(project: ProjectFolder) -> None:
    shutil.rmtree(project.path)
    with pytest.raises(DiskFailed, match="is gone"):
        project.frames.store(stack("view03"))
    assert not project.path.exists()


def test_row_16_files_of_a_program_that_was_killed_are_swept_at_the_next_change(project: ProjectFolder) -> None:
    left = (
        project.path / "stacks" / "view01" / ".left.4194303.part.npy",  # of the version before; no process has this number
        project.path / "stacks" / "view02" / ".left.4194303-0a1b2c-3d4e5f.part.npy",
        project.path / ".results.4194303-0a1b2c-3d4e5f.part" / "clouds" / "view01.ply",
        project.path / "stacks" / "view01" / f".left.{os.getpid()}-000000-3d4e5f.part.npy",  # of another program that had our number
    )
    running = project.path / "stacks" / "view01" / f".right.{os.getppid()}-0a1b2c-3d4e5f.part.npy"
    for path in (*left, running):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"half")
    assert upkeep.verify(project.path).whole
    with project.lock():
        pass
    assert [path for path in left if path.exists() or (path.parent.name.startswith(".") and path.parent.exists())] == []
    assert running.exists()


def test_row_17_a_full_disk_is_named_with_its_file_in_words(project: ProjectFolder, monkeypatch) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("os.write", full)
    with pytest.raises(StorageError, match=r"view03.*cannot be written: No space left on device\.") as refusal:
        project.frames.store(stack("view03"))
    assert "Free some space" in refusal.value.hint


def test_row_18_an_archive_that_unpacks_to_gigabytes_is_refused_at_once(tmp_path: Path, old: ProjectFolder) -> None:
    bomb = tmp_path / "bomb.npz"
    with zipfile.ZipFile(bomb, "w", zipfile.ZIP_DEFLATED) as archive, archive.open("covariance.npy", "w", force_zip64=True) as stream:
        np.lib.format.write_array_header_1_0(stream, {"descr": "<f8", "fortran_order": False, "shape": (20_000, 20_000)})
        zeros = bytes(2**20)
        for _ in range(1100):
            stream.write(zeros)
    assert bomb.stat().st_size < 3_000_000
    with pytest.raises(ValueError, match="unpacks to more than"):
        read_npz(bomb)
    shutil.copyfile(bomb, old.path / "calibration" / "rig_uncertainty.npz")
    with pytest.raises(StorageError, match="unpacks to more than"):
        old.rig_uncertainty()


def test_row_18_an_array_that_announces_more_than_its_file_holds_reserves_no_memory(tmp_path: Path) -> None:
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(head, {"descr": "<f8", "fortran_order": False, "shape": (2**40,)})
    with zipfile.ZipFile(tmp_path / "liar.npz", "w") as archive:
        archive.writestr("a.npy", head.getvalue() + bytes(100))
    with pytest.raises(ValueError, match="cut off"):
        read_npz(tmp_path / "liar.npz")


def test_a_changed_program_is_refused_until_it_is_accepted(project: ProjectFolder, capsys) -> None:
    program = project.path / "inspection" / "program.toml"
    program.write_text(program.read_text(encoding="utf-8") + "\n# checked by hand\n", encoding="utf-8")
    with pytest.raises(StorageError, match=r"program\.toml is not what was stored.*--accept inspection/program\.toml"):
        assert ProjectFolder.open(project.path).program
    assert main(["verify", str(project.path)]) == 1
    assert main(["verify", str(project.path), "--accept", "inspection/program.toml"]) == 0
    assert ProjectFolder.open(project.path).program is not None
    capsys.readouterr()
    assert "stacks" in refused(capsys, ["verify", str(project.path), "--accept", "stacks/view01/stack.json"])
