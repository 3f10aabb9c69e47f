"""`noise` and `bracket` answer with figures and refuse bad input in words."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from measureapp.cli.main import main
from measureapp.errors import InputError
from measureapp.fringe.noise.model import CameraNoise
from measureapp.project.fringes.noise_file import read_noise
from tests.cli.fringe_sets import write_paper_set
from tests.cli.refusal import refused_with


def answer(capsys: pytest.CaptureFixture[str], *arguments: object) -> dict[str, object]:
    capsys.readouterr()
    assert main([str(argument) for argument in (*arguments, "--json")]) == 0
    return json.loads(capsys.readouterr().out)


def write_flats(folder: Path, camera: CameraNoise, shares: tuple[float, ...] = (0.03, 0.1, 0.3, 0.6, 0.9), bits: int = 8) -> str:
    """Write two flats of every brightness; returns the pattern that matches them."""
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(4)
    gain = camera.electrons_per_grey(2**bits - 1)
    shading = np.linspace(0.7, 1.0, 240)[None, :] * np.linspace(0.8, 1.0, 160)[:, None]
    for number, share in enumerate(shares):
        for copy in range(2):
            electrons = random.poisson(share * (2**bits - 1) * shading * gain) + random.normal(0, camera.read_noise_e, shading.shape)
            grey = np.clip(np.rint(camera.black_grey + electrons / gain), 0, 2**bits - 1)
            cv2.imwrite(str(folder / f"{number}_{copy}.png"), grey.astype(np.uint8 if bits == 8 else np.uint16))
    return str(folder / "*.png")


def test_noise_of_two_cameras_is_written_and_read_back(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    left, right = CameraNoise(full_well_e=6000, read_noise_e=7), CameraNoise(full_well_e=11_000, read_noise_e=30)
    flats = {name: write_flats(tmp_path / name, camera) for name, camera in (("left", left), ("right", right))}
    images = [argument for name, pattern in flats.items() for argument in ("--images", f"{name}={pattern}")]
    file = tmp_path / "noise.json"
    said = answer(capsys, "noise", *images, "--out", file)["cameras"]
    read = read_noise(file)
    for name, truth in (("left", left), ("right", right)):
        entry = said[name]
        assert entry["noise"]["full_well_e"] == pytest.approx(truth.full_well_e, abs=4 * entry["full_well_sd_e"])
        assert entry["noise"]["read_noise_e"] == pytest.approx(truth.read_noise_e, abs=4 * entry["read_noise_sd_e"])
        assert entry["verdict"].startswith("sound")
        assert len(entry["points"]) >= 5
        assert read[name].full_well_e == pytest.approx(entry["noise"]["full_well_e"])
        assert read[name].read_noise_e == pytest.approx(entry["noise"]["read_noise_e"])
    assert json.loads(file.read_text())["schema_version"] == 1
    assert main(["noise", *images, "--out", str(file)]) == 0
    assert "electrons per grey level" in capsys.readouterr().out


def test_dark_images_give_the_black_level_of_a_twelve_bit_camera(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    camera = CameraNoise(full_well_e=10_000, read_noise_e=8, black_grey=64)
    flats = write_flats(tmp_path / "flats", camera, bits=12)
    dark = write_flats(tmp_path / "dark", camera, (0.0,), bits=12)
    common = ("noise", "--images", f"one={flats}", "--out", tmp_path / "noise.json")
    assert "need a saturation level" in refused_with(capsys, *common)
    assert "black level" in refused_with(capsys, *common, "--saturation", 4095)
    found = answer(capsys, *common, "--saturation", 4095, "--dark", f"one={dark}")["cameras"]["one"]
    assert found["noise"]["black_grey"] == pytest.approx(64, abs=0.1)
    assert found["noise"]["full_well_e"] == pytest.approx(10_000, rel=0.02)
    assert found["noise"]["read_noise_e"] == pytest.approx(8, rel=0.03)


def write_noisy_fringes(folder: Path, camera: CameraNoise, steps: int) -> Path:
    """Write fringes of two pitches on a surface of uneven albedo, and the manifest that says so."""
    random = np.random.default_rng(6)
    columns, albedo = np.linspace(0, 1023, 400), np.linspace(0.15, 1.0, 240)[:, None]
    gain = camera.electrons_per_grey(255)
    lines = ["shift_sign = -1", "projector_px = 1024", "saturation = 255", "[[exposure]]", "exposure_us = 1000"]
    for pitch in (32, 33):
        names = [f"{pitch}_{n}.png" for n in range(steps)]
        for n, name in enumerate(names):
            grey = albedo * (20 + 100 * (1 + np.cos(2 * np.pi * (columns / pitch - n / steps))))
            electrons = random.poisson(grey * gain) + random.normal(0, camera.read_noise_e, grey.shape)
            cv2.imwrite(str(folder / name), np.clip(np.rint(electrons / gain), 0, 255).astype(np.uint8))
        listed = ", ".join(f'"{name}"' for name in names)
        lines += ["[[exposure.group]]", 'kind = "phase-shift"', f"pitch_px = {pitch}", f"images = {{ left = [{listed}] }}"]
    (folder / "MANIFEST.toml").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return folder / "MANIFEST.toml"


def test_recorded_fringes_determine_the_noise_where_there_are_no_flats(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    camera = CameraNoise(full_well_e=4000, read_noise_e=12)
    manifest = write_noisy_fringes(tmp_path, camera, 6)
    found = answer(capsys, "noise", "--fringes", manifest, "--out", tmp_path / "noise.json")["cameras"]["left"]
    assert found["noise"]["full_well_e"] == pytest.approx(4000, abs=4 * found["full_well_sd_e"])
    assert found["noise"]["read_noise_e"] == pytest.approx(12, abs=4 * found["read_noise_sd_e"])
    assert read_noise(tmp_path / "noise.json")["left"].full_well_e == pytest.approx(found["noise"]["full_well_e"])
    three = write_noisy_fringes(tmp_path, camera, 3)
    assert "no group of four steps or more" in refused_with(capsys, "noise", "--fringes", three, "--out", tmp_path / "none.json")
    out = ("--out", tmp_path / "none.json")
    assert "one of --images, --rig and --fringes" in refused_with(capsys, "noise", *out)
    assert "one of --images, --rig and --fringes" in refused_with(capsys, "noise", "--fringes", manifest, "--rig", "paper", *out)
    assert "need --images" in refused_with(capsys, "noise", "--fringes", manifest, "--saturation", 255, *out)
    assert not (tmp_path / "none.json").exists()


def test_flats_that_cannot_be_used_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    flats = write_flats(tmp_path / "flats", CameraNoise())
    out = ("--out", tmp_path / "noise.json")
    assert "does not name a camera" in refused_with(capsys, "noise", "--images", flats, *out)
    assert "camera left twice" in refused_with(capsys, "noise", "--images", f"left={flats}", "--images", f"left={flats}", *out)
    assert "No file matches" in refused_with(capsys, "noise", "--images", f"left={tmp_path}/none*.png", *out)
    (tmp_path / "flats" / "2_1.png").unlink()
    assert "2_0.png is the only image of its brightness" in refused_with(capsys, "noise", "--images", f"left={flats}", *out)
    cv2.imwrite(str(tmp_path / "flats" / "2_1.png"), np.zeros((5, 5), np.uint8))
    assert "2_1.png differs from" in refused_with(capsys, "noise", "--images", f"left={flats}", *out)
    assert not (tmp_path / "noise.json").exists()


def test_a_noise_file_that_is_none_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "noise.json"
    for text, words in (
        ("no", "is not JSON"),
        ("{}", "cameras: Field required"),
        ('{"schema_version": 9, "cameras": {}}', "schema_version"),
    ):
        file.write_text(text)
        with pytest.raises(InputError, match=words):
            read_noise(file)
    with pytest.raises(InputError, match="cannot be read"):
        read_noise(tmp_path / "none.json")


def test_bracket_proposes_exposures_from_a_recorded_probe(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = write_paper_set(tmp_path, ("left", "right"), (40_000, 10_000))
    said = answer(capsys, "bracket", manifest, "--budget-s", 3, "--max-exposures", 3)
    assert 1 <= len(said["exposures_us"]) <= 3
    assert said["exposures_us"] == said["figures"]["exposures_us"]
    assert said["figures"]["time_s"] <= 3
    assert set(said["figures"]["decodable"]) == {"left", "right"}
    assert set(said["compared"]) == {"paper", "probe"}
    assert said["figures"]["decodable_share"] > 0.99
    assert said["compared"]["paper"]["decodable_share"] > 0.99
    assert said["compared"]["probe"]["worth"] < said["figures"]["worth"]
    assert main(["bracket", str(manifest)]) == 0
    assert "proposed:" in capsys.readouterr().out
    assert "do not suffice" in refused_with(capsys, "bracket", manifest, "--budget-s", 0.1)
    assert "cannot be read" in refused_with(capsys, "bracket", manifest, "--noise", tmp_path / "none.json")


def test_bracket_takes_the_noise_of_the_cameras(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = write_paper_set(tmp_path, ("left",), (40_000, 10_000))
    flats = write_flats(tmp_path / "flats", CameraNoise(full_well_e=1500, read_noise_e=20))
    answer(capsys, "noise", "--images", f"left={flats}", "--out", tmp_path / "noise.json")
    plain = answer(capsys, "bracket", manifest)["compared"]["probe"]["median_sigma_rad"]
    noisy = answer(capsys, "bracket", manifest, "--noise", tmp_path / "noise.json")["compared"]["probe"]["median_sigma_rad"]
    assert noisy > 1.6 * plain
