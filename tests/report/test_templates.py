from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from measureapp.data.identification import Identification
from measureapp.data.part_program import PartProgramFacts
from measureapp.data.plan import ScanPlan
from measureapp.data.report_template import ReportTemplate
from measureapp.errors import InputError
from measureapp.pipeline.part_program import store_part_program
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.part_program_file import pack_part_program, read_part_program, unpack_part_program, write_part_program
from measureapp.project.rig_file import read_rig
from measureapp.report.compose import compose
from measureapp.report.csv import dimension_rows
from measureapp.report.model import Details
from measureapp.report.pdf import pdf_bytes
from measureapp.report.printed import typst_document
from measureapp.report.project import project_details
from measureapp.report.template import read_template
from measureapp.resources import resource

TEXT = """
name = "Works 7"
version = "3.2"
company = "Müller & Söhne #1"
logo = "logo.png"
title = "Test certificate"
fields = ["serial_number", "customer"]
signatures = ["Inspector", "Quality"]
pages = ["summary", "table"]
[balloons.length]
number = "12"
zone = "B3"
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "template"
    made.mkdir()
    (made / "template.toml").write_text(TEXT, encoding="utf-8")
    (made / "logo.png").write_bytes(cv2.imencode(".png", np.full((20, 60, 3), 128, np.uint8))[1].tobytes())
    return made


def test_a_template_decides_company_logo_fields_signatures_and_pages(folder: Path, measured) -> None:
    details = Details(Identification(serial_number="7", order="not asked for"), read_template(folder))
    model = compose(measured(), details=details, pictures=False)
    printed = typst_document(model)
    assert (printed["company"], printed["logo"], printed["heading"]) == ("Müller & Söhne #1", "logo.png", "Test certificate")
    assert printed["signatures"] == ["Inspector", "Quality"] and printed["pages"] == ["summary", "table"]
    assert "template Works 7, version 3.2" in printed["footer"]
    names = [fact["name"] for fact in printed["header"]]
    assert names[0] == "Serial number" and "Order" not in names and "Customer" not in names  # not filled in
    assert pdf_bytes(model).startswith(b"%PDF-")
    assert [row["balloon"] + row["zone"] for row in dimension_rows(model)][:2] == ["12B3", ""]


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ('fields = ["weight"]', "weight"),
        ('logo = "../secret.png"', "logo"),
        ('logo = "missing.png"', "missing.png"),
        ('layout = "none.typ"', "none.typ"),
        ('pages = ["poem"]', "pages"),
        ("colour = 1", "colour"),
    ],
)
def test_what_a_template_asks_for_in_vain_is_named(change: str, named: str, folder: Path) -> None:
    (folder / "template.toml").write_text(change, encoding="utf-8")
    with pytest.raises(InputError, match=named):
        read_template(folder)


def test_a_file_that_is_no_picture_is_no_logo(folder: Path) -> None:
    (folder / "logo.png").write_bytes(b"MZ")
    with pytest.raises(InputError, match="not a logo"):
        read_template(folder)


def test_a_part_program_brings_its_template_and_its_identification_to_a_project(folder: Path, tmp_path: Path) -> None:
    plan = tmp_path / "plan.json"
    plan.write_text(ScanPlan.model_validate_json(_any_plan()).model_dump_json(), encoding="utf-8")
    facts = PartProgramFacts(name="Gypsum", part_number="G-17", identification=Identification(drawing="D-1"))
    packed = write_part_program(pack_part_program(facts, plan, report_template=folder), tmp_path / "p.mpart")
    settings = ProjectSettings(name="p", part="part", rig=read_rig(resource("rigs/paper.toml")))
    project = ProjectFolder.create(tmp_path / "project", settings)
    store_part_program(project, read_part_program(packed))
    details = project_details(ProjectFolder.open(project.path))
    assert details.template.description == ReportTemplate.model_validate(read_template(folder).description)
    assert details.template.logo == read_template(folder).logo
    assert (details.identification.part_number, details.identification.drawing) == ("G-17", "D-1")
    unpacked = unpack_part_program(read_part_program(packed), tmp_path / "edit")
    assert read_template(unpacked["report"]).logo is not None


def _any_plan() -> str:
    from measureapp.project.plan_file import read_plan

    return read_plan(next(iter(sorted(resource("plans").glob("*.toml"))))).model_dump_json()
