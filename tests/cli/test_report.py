from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli import main
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, HandEye, LinearGuide, RigCalibration, RotationAxis
from measureapp.data.cloud import StitchedCloud
from measureapp.data.measurement import Measurement
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.measured_points import sample_mesh
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.geometry.files import read_mesh
from measureapp.project.program_file import read_program
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource

PART = resource("parts/gypsum")


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A measured project, without images: what `report` needs of it."""
    folder = ProjectFolder.create(
        tmp_path_factory.mktemp("measured") / "project", ProjectSettings(name="order 7", part="gypsum", rig=read_rig("paper"))
    )
    pinhole = PinholeCamera(640, 480, np.array([[900, 0, 320], [0, 900, 240], [0, 0, 1]]), np.zeros(5))
    camera = CameraCalibration("left", pinhole, RigidTransform.identity("camera", "left"), rms_px=0.05)
    calibration = RigCalibration(
        CameraArrayCalibration("left", {"left": camera}),
        HandEye(RigidTransform.identity("flange", "camera")),
        LinearGuide(np.array([0, 1, 0]), 1.0),
        RotationAxis(np.array([600, 0, 100]), np.array([0, 0, 1]), "guide"),
    )
    nominal = read_mesh(PART / "nominal.stl")
    points = sample_mesh(nominal, 30_000)
    assert points.normals is not None
    count = len(points)
    cloud = StitchedCloud(points.points_mm, points.normals, np.full(count, 0.02), np.full(count, 0.5), np.zeros(count), ())
    inspection = inspect(cloud, read_program(PART / "program.toml"), nominal)
    folder.save_calibration(calibration)
    folder.save_inspection(PART / "program.toml", PART / "nominal.stl")
    folder.save_measurement(
        Measurement(
            "order 7",
            "gypsum",
            "paper",
            "2026-05-04T10:20:30+00:00",
            calibration,
            (),
            cloud,
            nominal.seen_from(RigidTransform.identity("part", "nominal")),
            inspection,
        )
    )
    return folder.path


def test_the_documents_asked_for_are_written_where_asked(project: Path, tmp_path: Path, capsys) -> None:
    assert main(["report", str(project), "--pdf", "--csv", "--out", str(tmp_path), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["report.csv", "report.pdf"]
    assert answer["files"] == {"pdf": str(tmp_path / "report.pdf"), "csv": str(tmp_path / "report.csv")}
    assert answer["verdict"] == "pass"
    rows = list(csv.DictReader((tmp_path / "report.csv").read_text(encoding="utf-8-sig").splitlines()))
    assert [row["name"] for row in rows] == ["a", "b", "c", "d"]
    assert float(rows[0]["measured"]) == pytest.approx(180, abs=1e-3)


def test_without_a_choice_pdf_csv_and_json_go_into_the_project(project: Path, capsys) -> None:
    assert main(["report", str(project)]) == 0
    assert "All 4 dimensions pass." in capsys.readouterr().out
    assert {path.name for path in (project / "report").iterdir()} == {"report.pdf", "report.csv", "report.json"}


def test_the_language_is_chosen_and_numbers_and_names_stay(project: Path, tmp_path: Path, capsys) -> None:
    for language in ("en", "zh_CN"):
        assert main(["report", str(project), "--html", "--csv", "--language", language, "--out", str(tmp_path / language)]) == 0
    pages = {language: (tmp_path / language / "report.html").read_text(encoding="utf-8") for language in ("en", "zh_CN")}
    assert '<html lang="en">' in pages["en"] and '<html lang="zh-CN">' in pages["zh_CN"]
    assert "<th>Verdict</th>" in pages["en"] and "<th>判定</th>" in pages["zh_CN"] and "全部 4 个尺寸合格。" in pages["zh_CN"]
    assert (tmp_path / "en" / "report.csv").read_bytes() == (tmp_path / "zh_CN" / "report.csv").read_bytes()
    assert "All 4 dimensions pass." in capsys.readouterr().out  # the command line speaks English


def test_an_unknown_language_is_one_sentence_with_those_there_are(project: Path, tmp_path: Path, capsys) -> None:
    assert main(["report", str(project), "--language", "klingon", "--out", str(tmp_path / "out")]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and "'klingon'" in said and "en, zh_CN" in said and not (tmp_path / "out").exists()


def test_a_folder_is_not_given_the_name_of_a_document(project: Path, tmp_path: Path, capsys) -> None:
    assert main(["report", str(project), "--out", str(tmp_path / "mine.pdf")]) == 2
    assert "--out is a folder" in capsys.readouterr().err and not (tmp_path / "mine.pdf").exists()


def test_a_project_without_measurement_is_refused(tmp_path: Path, capsys) -> None:
    ProjectFolder.create(tmp_path / "empty", ProjectSettings(name="n", part="gypsum", rig=read_rig("paper")))
    assert main(["report", str(tmp_path / "empty")]) == 2
    assert "no measurement" in capsys.readouterr().err


def test_a_folder_that_is_no_project_is_refused(tmp_path: Path, capsys) -> None:
    assert main(["report", str(tmp_path)]) == 2
    assert "not a MeasureApp project" in capsys.readouterr().err
