"""Part programs: what is packed comes back, and what is damaged is refused."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

from measureapp.data.part_program import PartProgramFacts
from measureapp.data.plan import FlangePose, ScanPlan, Viewpoint
from measureapp.errors import InputError
from measureapp.pipeline.part_program import store_part_program
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.part_program_file import (
    PNG,
    is_part_program,
    pack_part_program,
    read_part_program,
    unpack_part_program,
    write_part_program,
)
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource

POSE = FlangePose(position_mm=(500.0, 0.0, 600.0), quaternion_wxyz=(0.0, 1.0, 0.0, 0.0))
PLAN = ScanPlan(name="gypsum", viewpoints=(Viewpoint(id="top", flange=POSE, guide_mm=0.0, table_deg=0.0),))
FACTS = PartProgramFacts(name="Gypsum", part_number="G-17", remarks="Flat side down.")


@pytest.fixture
def sources(tmp_path: Path) -> dict[str, Path]:
    """Files of a part program."""
    files = {"plan": tmp_path / "plan.json", "report_template": tmp_path / "own.typ", "picture": tmp_path / "part.png"}
    files["plan"].write_text(PLAN.model_dump_json())
    files["report_template"].write_text('#let r = json("report.json")\n= Works report: #r.title\n')
    files["picture"].write_bytes(PNG + b"rest")
    return files | {"inspection": resource("parts/gypsum/program.toml")}


@pytest.fixture
def packed(tmp_path: Path, sources: dict[str, Path]) -> Path:
    """A part program on disk."""
    return write_part_program(pack_part_program(FACTS, **sources), tmp_path / "gypsum")


def test_what_is_packed_comes_back(packed: Path, sources: dict[str, Path]) -> None:
    found = read_part_program(packed)
    assert is_part_program(packed)
    assert (found.facts.name, found.facts.part_number, found.facts.remarks) == ("Gypsum", "G-17", "Flat side down.")
    assert found.plan == PLAN
    assert found.inspection == sources["inspection"].read_bytes()
    assert found.nominal == (".stl", resource("parts/gypsum/nominal.stl").read_bytes())
    assert found.report_template == sources["report_template"].read_bytes()
    assert found.picture == sources["picture"].read_bytes()


def test_the_files_can_be_edited_and_packed_again(packed: Path, tmp_path: Path) -> None:
    files = unpack_part_program(read_part_program(packed), tmp_path / "edit")
    again = pack_part_program(FACTS, files["plan"], files["program"], files["report"], files["picture"])
    assert read_part_program(write_part_program(again, tmp_path / "again.mpart")).facts == read_part_program(packed).facts
    with pytest.raises(InputError, match="not an empty folder"):
        unpack_part_program(read_part_program(packed), tmp_path / "edit")


def test_a_plan_alone_is_a_part_program(tmp_path: Path, sources: dict[str, Path]) -> None:
    found = read_part_program(write_part_program(pack_part_program(FACTS, sources["plan"]), tmp_path / "p.mpart"))
    assert (found.inspection, found.nominal, found.report_template, found.picture) == (None, None, None, None)


def test_its_parts_become_those_of_a_project(packed: Path, tmp_path: Path, sources: dict[str, Path]) -> None:
    project = ProjectFolder.create(tmp_path / "project", ProjectSettings(name="n", part="p", rig=read_rig("paper")))
    store_part_program(project, read_part_program(packed))
    assert project.program is not None
    assert project.program.read_bytes() == sources["inspection"].read_bytes()
    assert project.nominal is not None
    assert project.report_template is not None
    assert project.report_template.read_bytes() == sources["report_template"].read_bytes()


def rewritten(packed: Path, change: dict[str, bytes | None]) -> Path:
    """Return a copy in which files are replaced, added, or left out where they are None."""
    with zipfile.ZipFile(packed) as archive:
        files: dict[str, bytes | None] = {name: archive.read(name) for name in archive.namelist()}
    copy = packed.with_name("changed.mpart")
    with zipfile.ZipFile(copy, "w") as archive:
        for name, data in (files | change).items():
            if data is not None:
                archive.writestr(name, data)
    return copy


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"plan.json": None}, "no plan.json"),
        ({"part_program.json": None}, "no part_program.json"),
        ({"program.toml": b"name = 'other'"}, "program.toml does not match its checksum"),
        ({"picture.png": None}, "picture.png is missing"),
        ({"../evil.toml": b""}, "'../evil.toml', which no part program has"),
        ({"nominal/../../x.stl": b""}, "which no part program has"),
        ({"part_program.json": b'{"schema_version": 99, "name": "x"}'}, "schema_version"),
        ({"part_program.json": b"{" * 5000}, "part program"),
    ],
)
def test_a_changed_file_is_refused(packed: Path, change: dict[str, bytes | None], told: str) -> None:
    with pytest.raises(InputError, match=told):
        read_part_program(rewritten(packed, change))


def test_every_byte_that_is_cut_off_is_noticed(packed: Path) -> None:
    whole = packed.read_bytes()
    for length in (0, 10, len(whole) // 2, len(whole) - 1):
        packed.write_bytes(whole[:length])
        with pytest.raises(InputError, match="cannot be read as a part program"):
            read_part_program(packed)


def test_a_file_that_would_fill_the_memory_is_refused(packed: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("measureapp.project.part_program_file.LARGEST_BYTES", 1000)
    with pytest.raises(InputError, match="unpacks to more than"):
        read_part_program(packed)


def test_what_is_packed_must_be_what_it_should_be(tmp_path: Path, sources: dict[str, Path]) -> None:
    sources["picture"].write_bytes(b"no picture")
    with pytest.raises(InputError, match="not a PNG image"):
        pack_part_program(FACTS, **sources)
    lost = tmp_path / "lost.toml"
    lost.write_text('name = "x"\nnominal = "lost.stl"\n')
    with pytest.raises(InputError, match=r"lost\.stl cannot be read"):
        pack_part_program(FACTS, sources["plan"], lost)
