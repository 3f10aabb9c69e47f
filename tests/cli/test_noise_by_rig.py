"""`noise --rig`: a rig measures its cameras, and its projects are decoded with what was found."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo
from without_pictures import without_surface_and_pictures

from measureapp.cli.main import main
from measureapp.data.plan import ExposureBracket
from measureapp.errors import CalibrationError, InputError
from measureapp.fringe.noise.photon_transfer import estimate_noise
from measureapp.pipeline.restitch import restitch
from measureapp.planning.viewpoints import plan_around_part
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig
from tests.cli.refusal import refused_with
from tests.cli.rig_files import write_binned_rig

CAMERAS = ("left", "right", "upper")
FULL_WELL_E, READ_NOISE_E = 1500.0, 3.5  # of the usual model a quarter of the electrons, so twice the noise
SENSOR = f"world = {{ sensor = {{ full_well_e = {FULL_WELL_E}, read_noise_e = {READ_NOISE_E} }} }}"


@pytest.fixture(scope="module", autouse=True)
def _without_surface_and_pictures() -> Iterator[None]:
    with without_surface_and_pictures():
        yield


@pytest.fixture
def rig(tmp_path: Path) -> Path:
    """The demo's rig with noisier cameras than the usual model."""
    return write_binned_rig(tmp_path / "noisy.toml", f'part = "gypsum", seed = 1, {SENSOR}')


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """One viewpoint at one exposure."""
    made = plan_around_part(read_rig("paper"), "one view", radius_mm=100, height_mm=80, count=4)
    one = made.model_copy(update={"viewpoints": made.viewpoints[:1], "bracket": ExposureBracket(exposures_us=(40_000,))})
    path = tmp_path / "plan.json"
    path.write_text(one.model_dump_json(), encoding="utf-8")
    return path


def done(capsys: pytest.CaptureFixture[str], *arguments: object) -> dict:
    assert main([*map(str, arguments), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def median_sigma_mm(project: Path) -> float:
    measurement = ProjectFolder.open(project).measurement()
    assert measurement is not None
    return float(np.median(measurement.views[0].cloud.sigma_mm))


def noise_in_report(project: Path) -> dict[str, str]:
    return json.loads((project / "report" / "report.json").read_text(encoding="utf-8"))["settings"]["noise"]


def test_a_project_is_decoded_with_the_noise_its_rig_measured(demo: Demo, rig: Path, plan: Path, tmp_path: Path, capsys) -> None:
    project, other = tmp_path / "project", tmp_path / "other"
    done(capsys, "scan", plan, "--rig", rig, "--project", project, "--calibration", demo.folder)
    before = median_sigma_mm(project)
    assert all(
        re.fullmatch(r"from the fringe images: full well 1[3-7]\d\d e, read noise (\d\.\d e|less than their grey levels show)", said)
        for said in noise_in_report(project).values()
    )
    found = done(capsys, "noise", "--rig", rig, "--plan", plan, "--project", project, "--out", tmp_path / "noise.json")["cameras"]
    for camera in CAMERAS:
        assert abs(found[camera]["noise"]["full_well_e"] - FULL_WELL_E) < 4 * found[camera]["full_well_sd_e"]
        assert found[camera]["full_well_sd_e"] < 0.05 * FULL_WELL_E
    assert (tmp_path / "noise.json").read_bytes() == (project / "calibration" / "noise.json").read_bytes()

    opened = ProjectFolder.open(project)
    restitch(opened, opened.view_choices(), lambda _: None, NoProgress())  # of the clouds as they were decoded
    assert all(said.startswith("from the fringe images") for said in noise_in_report(project).values())
    done(capsys, "process", project)
    said = noise_in_report(project)
    assert all(re.fullmatch(r"measured: full well 1[45]\d\d e, read noise \d\.\d e", said[name]) for name in CAMERAS), said
    # the images had shown the same noise by themselves, although another was assumed
    assert 0.9 < median_sigma_mm(project) / before < 1.1
    done(capsys, "scan", plan, "--rig", rig, "--project", other, "--calibration", project)
    assert ProjectFolder.open(other).noise() == ProjectFolder.open(project).noise()
    assert median_sigma_mm(other) == pytest.approx(median_sigma_mm(project), rel=0.02)


def test_noise_that_cannot_be_measured_or_kept_is_refused(rig: Path, plan: Path, tmp_path: Path, capsys) -> None:
    out = ("--out", tmp_path / "noise.json")
    assert "one of --images, --rig and --fringes" in refused_with(capsys, "noise", *out)
    assert "one of --images, --rig and --fringes" in refused_with(capsys, "noise", "--rig", rig, "--images", "left=*.png", *out)
    assert "no destination" in refused_with(capsys, "noise", "--rig", rig)
    assert "--plan needs --rig" in refused_with(capsys, "noise", "--images", "left=*.png", "--plan", plan, *out)
    assert "--dark and --saturation" in refused_with(capsys, "noise", "--rig", rig, "--saturation", 255, *out)
    assert "not a MeasureApp project" in refused_with(capsys, "noise", "--rig", rig, "--project", tmp_path)
    assert not (tmp_path / "noise.json").exists()


def test_noise_is_kept_of_cameras_alone_that_the_rig_has_and_that_fit_the_model(tmp_path: Path) -> None:
    settings = ProjectSettings(name="one view", part="one view", rig=read_rig("paper"))
    project = ProjectFolder.create(tmp_path / "project", settings)
    light = np.random.default_rng(1)
    flats = [light.poisson(grey * 24.0, (2, 80, 80)) // 24 for grey in (4, 20, 60, 120, 200)]
    sound = estimate_noise([pair.astype(np.uint8) for pair in flats], 255, "left")
    with pytest.raises(InputError, match="has no camera middle"):
        project.save_noise({"left": sound, "middle": sound})
    with pytest.raises(CalibrationError, match="does not fit: left: sound"):
        project.save_noise({"left": replace(sound, accepted=False)})
    assert project.noise() == {}
    project.save_noise({"left": sound})
    assert project.noise() == {"left": sound.noise}


def test_a_damaged_noise_file_of_a_project_is_refused_before_anything_moves(
    rig: Path, plan: Path, demo: Demo, tmp_path: Path, capsys
) -> None:
    settings = ProjectSettings(name="one view", part="one view", rig=read_rig(str(rig)))
    project = ProjectFolder.create(tmp_path / "project", settings)
    (project.path / "calibration").mkdir(exist_ok=True)
    (project.path / "calibration" / "noise.json").write_text("{", encoding="utf-8")
    said = refused_with(capsys, "scan", plan, "--rig", rig, "--project", project.path, "--calibration", demo.folder)
    assert "noise.json is not JSON" in said
    assert project.stored_viewpoints() == ()
