from __future__ import annotations

from pathlib import Path

import pytest
from pydantic import ValidationError

from measureapp.data.identification import FIELDS, LABELS, Identification
from measureapp.errors import Damaged
from measureapp.project.file_names import LONGEST, safe_file_name
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.identification_file import IDENTIFICATION, read_identification, save_identification
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource

FILLED = Identification(
    part_name="Laufrad Größe 2", serial_number="件-7", temperature_c=20.4, temperature_source="thermometer 3", remarks="a\nb"
)


@pytest.fixture
def project(tmp_path: Path) -> ProjectFolder:
    rig = read_rig(resource("rigs/paper.toml"))
    return ProjectFolder.create(tmp_path / "p", ProjectSettings(name="p", part="part", rig=rig))


def test_an_identification_is_stored_with_its_project_and_journalled(project: ProjectFolder) -> None:
    assert read_identification(project.path) == Identification()
    save_identification(project.path, FILLED)
    assert read_identification(project.path) == FILLED
    contents = ProjectFolder.open(project.path).journal.contents()
    assert contents is not None and IDENTIFICATION in contents.files


def test_an_identification_changed_behind_the_back_is_refused(project: ProjectFolder) -> None:
    save_identification(project.path, FILLED)
    path = project.path / IDENTIFICATION
    path.write_text(path.read_text(encoding="utf-8").replace("Größe 2", "Größe 3"), encoding="utf-8")
    with pytest.raises(Damaged, match="identification"):
        read_identification(project.path)


def test_empty_fields_take_defaults_but_a_temperature_never_takes_a_foreign_source() -> None:
    defaults = Identification(customer="Works", temperature_c=21.0, temperature_source="air conditioning")
    assert FILLED.with_defaults(defaults).customer == "Works"
    own = Identification(temperature_c=0.0).with_defaults(defaults)
    assert (own.temperature_c, own.temperature_source) == (0.0, "")
    assert Identification().with_defaults(defaults).temperature_source == "air conditioning"


def test_what_a_scanner_sends_becomes_one_line_of_sane_length() -> None:
    assert Identification(serial_number="[)>\x1e06\x1dS77\r\n").serial_number == "[)> 06 S77"
    with pytest.raises(ValidationError):
        Identification(order="1" * 201)
    with pytest.raises(ValidationError):
        Identification(temperature_c=float("nan"))


def test_every_field_has_a_label() -> None:
    assert tuple(LABELS) == FIELDS


@pytest.mark.parametrize(
    "name", ["NUL", "com1.txt", "a" * 500, "件" * 300, "trailing. ", "tab\there", "x\u202ey", "ä/ö\\ü", "", "...", "a\u0308"]
)
def test_file_names_are_valid_on_every_system(name: str) -> None:
    made = safe_file_name(name, ".pdf")
    assert made.endswith(".pdf") and len(made) <= LONGEST and len(made.encode()) < 255
    assert not set(made) & set('<>:"/\\|?*\t\u202e') and not made.startswith((".", " ")) and made[:-4].rstrip(". ") == made[:-4]
    assert made.split(".")[0].lower() not in ("nul", "com1", "con")
