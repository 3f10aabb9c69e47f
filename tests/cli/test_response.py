from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from measureapp.cli.main import main
from measureapp.project.fringes.response_file import read_response
from tests.cli.refusal import refused_with
from tests.cli.test_patterns import answered

TAU = 2 * np.pi


def dense_set(folder: Path, steps: int = 12, gamma: float = 1.8) -> Path:
    """What two cameras see of a curved surface under two pitches of a projector without gamma correction."""
    random = np.random.default_rng(8)
    y, x = np.mgrid[:160, :240]
    column = 4.0 * x + 30 * np.sin(y / 40) + 20
    lines = ["projector_px = 1024", "[[exposure]]", "exposure_us = 1000"]
    for pitch in (32, 33):
        lines += ["[[exposure.group]]", 'kind = "phase-shift"', f"pitch_px = {pitch}", "[exposure.group.images]"]
        for camera in ("left", "right"):
            names = [f"{camera}_{pitch}_{n}.png" for n in range(steps)]
            lines.append(f"{camera} = {json.dumps(names)}")
            for n, name in enumerate(names):
                light = ((1 + np.cos(TAU * column / pitch - TAU * n / steps)) / 2) ** gamma
                cv2.imwrite(str(folder / name), np.rint(20 + 180 * light + random.normal(0, 1.0, light.shape)).astype(np.uint8))
    manifest = folder / "MANIFEST.toml"
    manifest.write_text("\n".join(lines))
    return manifest


def test_a_dense_capture_determines_gamma_harmonics_and_what_few_steps_keep(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = dense_set(tmp_path)
    answer = answered(capsys, "response", manifest, "--out", tmp_path / "response.json", "--camera", "right")
    assert answer["camera"] == "right"
    assert answer["gamma"] == pytest.approx(1.8, abs=0.02)
    harmonics = answer["pitches"][0]["harmonics"]
    assert harmonics[0]["share"] == pytest.approx(0.8 / 3.8, abs=0.002)
    kept = {entry["steps"]: entry for entry in answer["pitches"][0]["phase_error"]}
    assert kept[3]["measured_with_rad"] < kept[3]["measured_without_rad"] / 10
    assert kept[5]["measured_with_rad"] is None
    response = read_response(tmp_path / "response.json")
    assert response.gamma == pytest.approx(1.8, abs=0.02)
    assert main(["response", str(manifest), "--out", str(tmp_path / "response.json")]) == 0
    said = capsys.readouterr().out
    assert "gamma 1.80" in said and "3 steps: phase error" in said


def test_three_steps_determine_their_own_error_but_no_curve(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    answer = answered(capsys, "response", dense_set(tmp_path, steps=3), "--out", tmp_path / "response.json")
    assert answer["gamma"] is None
    assert answer["pitches"][0]["harmonics"][0]["share"] == pytest.approx(0.8 / 3.8, rel=0.15)


def test_a_grey_ramp_determines_the_curve(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    levels = np.arange(0, 256, 15)
    rows = [f"{level},{12 + 150 * (level / 255) ** 2.2}" for level in levels]
    (tmp_path / "ramp.csv").write_text("\n".join(["level,grey", *rows]))
    answer = answered(capsys, "response", tmp_path / "ramp.csv", "--out", tmp_path / "response.json")
    assert answer["gamma"] == pytest.approx(2.2, abs=0.01)
    assert answer["pitches"] == []


def test_what_determines_nothing_is_refused_and_nothing_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = dense_set(tmp_path, steps=4, gamma=1.0)
    out = tmp_path / "response.json"
    assert "no error of the projector" in refused_with(capsys, "response", manifest, "--out", out)
    assert "no camera 'upper'" in refused_with(capsys, "response", manifest, "--out", out, "--camera", "upper")
    assert "absent.toml" in refused_with(capsys, "response", tmp_path / "absent.toml", "--out", out)
    (tmp_path / "ramp.csv").write_text("level,grey\n0,1\n255,200\n")
    assert "2 different levels" in refused_with(capsys, "response", tmp_path / "ramp.csv", "--out", out)
    assert not out.exists()
