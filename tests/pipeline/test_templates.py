"""Templates: a project without its data is the start of a new one."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from demo_fixture import Demo, linked_copy

from measureapp.cli import main
from measureapp.data.identification import Identification
from measureapp.errors import InputError
from measureapp.pipeline.templates import calibration_of, new_project, template_of_project
from measureapp.project import upkeep
from measureapp.project.documents import calibration_id
from measureapp.project.folder import ProjectFolder
from measureapp.project.identification_file import read_identification, save_identification
from measureapp.project.part_program_file import read_part_program, write_part_program


@pytest.fixture
def source(demo: Demo, tmp_path: Path) -> ProjectFolder:
    return ProjectFolder.open(linked_copy(demo.folder, tmp_path / "source"))


def test_a_new_project_starts_with_everything_but_the_data(source: ProjectFolder, tmp_path: Path) -> None:
    with source.lock():
        save_identification(source.path, Identification(drawing="D-1", customer="Works", serial_number="0815", operator="Ada"))
    template = read_part_program(write_part_program(template_of_project(source, part_number="7"), tmp_path / "gypsum"))
    made = new_project(template, tmp_path / "new", name="second")
    assert (made.name, made.settings.part, made.rig()) == ("second", source.settings.part, source.rig())
    assert made.plan() == source.plan() and made.settings.board == source.settings.board
    assert made.program is not None and source.program is not None
    assert made.program.read_bytes() == source.program.read_bytes()
    assert made.nominal is not None
    known = read_identification(made.path)
    assert (known.drawing, known.customer, known.part_number) == ("D-1", "Works", "7")
    assert not known.serial_number and not known.operator
    assert not made.stored_viewpoints() and made.measurement() is None and not made.board_views()
    assert calibration_id(made.require_calibration()) == calibration_id(source.require_calibration())
    assert upkeep.verify(made.path).whole


def test_a_template_whose_calibration_is_gone_starts_without_one(source: ProjectFolder, tmp_path: Path) -> None:
    template = template_of_project(source)
    source.path.rename(tmp_path / "elsewhere")
    assert calibration_of(template) is None
    made = new_project(template, tmp_path / "new")
    assert made.calibration() is None and made.plan() is not None


def test_a_folder_with_something_in_it_and_a_program_without_a_rig_are_refused(source: ProjectFolder, tmp_path: Path) -> None:
    from dataclasses import replace

    template = template_of_project(source)
    with pytest.raises(InputError, match="not an empty folder"):
        new_project(template, source.path)
    with pytest.raises(InputError, match="no rig"):
        new_project(replace(template, rig=None), tmp_path / "new")


def test_the_commands_make_a_template_and_start_a_project(source: ProjectFolder, tmp_path: Path, capsys) -> None:
    assert main(["program", "of", str(source.path), "--out", str(tmp_path / "t.mpart"), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["rig"] == source.rig().name and document["calibration"]["folder"] == str(source.path.resolve())
    assert main(["program", "start", str(tmp_path / "t.mpart"), "--project", str(tmp_path / "new"), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["calibrated"] and document["name"] == "new"
