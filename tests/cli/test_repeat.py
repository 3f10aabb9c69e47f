"""`measureapp repeat` on projects that differ as repeated measurements do."""

from __future__ import annotations

import csv
import json
import shutil
from pathlib import Path

import pytest

from measureapp.cli import main
from measureapp.project.atomic import write_text
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.results import DOCUMENT
from measureapp.project.rig_file import read_rig
from measureapp.project.upkeep import accept_changes
from measureapp.resources import resource
from tests.cli.refusal import refused

PART = resource("parts/gypsum")
NAMES = {"a": 180.0, "b": 140.0, "c": 60.0, "d": 40.0}


def inspected(folder: Path, offset_mm: float, uncertainty_mm: float = 0.02, part: str = "gypsum") -> Path:
    """Make a project as far as `repeat` reads it: without images and clouds."""
    project = ProjectFolder.create(folder, ProjectSettings(name=folder.name, part=part, rig=read_rig("paper")))
    project.save_inspection(PART / "program.toml", PART / "nominal.stl")
    dimensions = [
        {
            "name": name,
            "nominal": nominal,
            "measured": nominal + offset_mm,
            "uncertainty": uncertainty_mm,
            "lower_tolerance": -0.1,
            "upper_tolerance": 0.1,
            "verdict": "pass",
        }
        for name, nominal in NAMES.items()
    ]
    placed = {"to": "nominal", "from": "part", "matrix": [[1, 0, 0, 2], [0, 1, 0, 3], [0, 0, 1, 0], [0, 0, 0, 1]]}
    alignment = {"name": "best fit", "nominal_from_part": placed, "rms_mm": 0.01, "undetermined": []}
    inspection = {"program": "gypsum", "alignment": alignment, "features": [], "dimensions": dimensions}
    project.results.mkdir()
    document = {"measured_at": "2026-05-04T10:20:30+00:00", "inspection": inspection}
    (project.results / DOCUMENT).write_text(json.dumps(document), encoding="utf-8")
    return folder


@pytest.fixture
def three(tmp_path: Path) -> list[str]:
    return [str(inspected(tmp_path / f"day{n}", offset)) for n, offset in enumerate((0.01, 0.02, 0.03))]


def test_the_answer_has_mean_spread_and_deviation_of_every_dimension(three, capsys) -> None:
    assert main(["repeat", *three, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    first = document["dimensions"][0]
    assert {name: first[name] for name in ("name", "nominal", "n")} == {"name": "a", "nominal": 180.0, "n": 3}
    assert first["mean"] == pytest.approx(180.02)
    assert first["std"] == pytest.approx(0.01)
    assert first["deviation"] == pytest.approx(0.02)
    assert first["relative"] == pytest.approx(0.02 / 180)
    assert list(first["values"]) == ["day0", "day1", "day2"]


def test_the_tables_are_written_as_pdf_csv_and_json(three, tmp_path, capsys) -> None:
    assert main(["repeat", *three, "--out", str(tmp_path / "tables")]) == 0
    assert (tmp_path / "tables" / "repeats.pdf").read_bytes().startswith(b"%PDF")
    rows = list(csv.DictReader((tmp_path / "tables" / "repeats.csv").read_text(encoding="utf-8-sig").splitlines()))
    assert [(row["name"], row["n"], row["mean"], row["day2"]) for row in rows][1] == ("b", "3", "140.02", "140.03")
    assert json.loads((tmp_path / "tables" / "repeats.json").read_text(encoding="utf-8"))["part"] == "gypsum"
    assert "No spread contradicts the stated uncertainty" in capsys.readouterr().out


def test_a_spread_beyond_the_stated_uncertainty_is_a_negative_verdict(tmp_path, capsys) -> None:
    folders = [str(inspected(tmp_path / f"day{n}", offset, 0.002)) for n, offset in enumerate((0.01, 0.02, 0.03))]
    assert main(["repeat", *folders, "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["contradictions"] == list(NAMES)


def test_projects_of_different_parts_are_refused_unless_they_are_stated_to_be_one(three, tmp_path, capsys) -> None:
    other = str(inspected(tmp_path / "other", 0.015, part="gypsum 2"))
    assert "different parts: 'gypsum' and 'gypsum 2'" in refused(capsys, ["repeat", three[0], other])
    assert main(["repeat", three[0], other, "--one-part", "--json"]) == 0


def test_projects_with_different_programs_or_nominals_are_refused(three, tmp_path, capsys) -> None:
    program = Path(three[1]) / "inspection" / "program.toml"
    program.write_text(program.read_text(encoding="utf-8").replace("nominal = 180", "nominal = 181"), encoding="utf-8")
    accept_changes(Path(three[1]), ["inspection/program.toml"])
    assert "different inspection programs (dimension 'a')" in refused(capsys, ["repeat", *three])
    (Path(three[1]) / "inspection" / "nominal.stl").write_bytes(b"solid other")
    accept_changes(Path(three[1]), ["inspection/nominal.stl"])
    assert "different nominals" in refused(capsys, ["repeat", *three])


def test_the_report_of_repeats_is_written_in_a_language_and_tables_stay(three, tmp_path, capsys) -> None:
    for language in ("en", "zh_CN"):
        assert main(["repeat", *three, "--out", str(tmp_path / language), "--language", language]) == 0
    names = ("repeats.pdf", "repeats.csv", "repeats.json")
    english, chinese = ({name: (tmp_path / language / name).read_bytes() for name in names} for language in ("en", "zh_CN"))
    assert english["repeats.csv"] == chinese["repeats.csv"] and english["repeats.json"] == chinese["repeats.json"]
    assert english["repeats.pdf"] != chinese["repeats.pdf"]
    capsys.readouterr()
    assert "no language 'fr'" in refused(capsys, ["repeat", *three, "--language", "fr"])


def test_one_project_given_twice_or_copied_is_refused(three, tmp_path, capsys) -> None:
    assert "named twice" in refused(capsys, ["repeat", three[0], three[1], three[0]])
    shutil.copytree(three[0], tmp_path / "copy")
    assert "the same measurement" in refused(capsys, ["repeat", three[0], str(tmp_path / "copy")])


def test_a_project_without_results_or_with_damaged_ones_is_refused(three, capsys) -> None:
    results = Path(three[1]) / "results" / DOCUMENT
    text = results.read_text(encoding="utf-8")
    results.write_text(text[:100], encoding="utf-8")
    assert f"{results} cannot be read" in refused(capsys, ["repeat", *three])
    write_text(results, text)  # with an entry in the journal
    results.write_text(text.replace("1", "2", 1), encoding="utf-8")
    assert f"{results} is not what was stored" in refused(capsys, ["repeat", *three])
    results.unlink()
    assert "has no results" in refused(capsys, ["repeat", *three])


def test_a_single_project_is_refused(three, capsys) -> None:
    assert "at least two measurements" in refused(capsys, ["repeat", three[0]])
