from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from recorded import recorded

from measureapp.cli.main import main
from tests.cli.fringe_sets import write_paper_set, write_recorded_manifest
from tests.cli.refusal import refused_with


def test_decode_answers_with_the_figures_and_writes_the_phase_map(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = write_paper_set(tmp_path, ("left", "right"))
    assert main(["decode", str(manifest), "--out", str(tmp_path / "out"), "--json"]) == 0
    left = json.loads(capsys.readouterr().out)["cameras"]["left"]
    assert left["valid_ratio"] == {"exposures": [1.0, 1.0], "composite": 1.0}
    assert left["decoded_ratio"] > 0.98
    assert left["order_conflicts"] == 0
    assert left["modulation_median"] == pytest.approx(0.7 * 127.5, abs=1)
    assert 0.005 < left["phase_sigma_median"] < 0.02
    with np.load(left["file"]) as arrays:
        assert set(arrays) >= {"phase_rad", "modulation", "sigma_rad", "mask", "exposure_index"}
        columns = np.linspace(10, 1000, 256).astype(int)
        error = arrays["phase_rad"] * 32 / (2 * np.pi) - columns
        assert np.abs(error[arrays["mask"] == 0]).max() < 0.1


def test_sixteen_bit_images_give_the_same_phase(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = write_paper_set(tmp_path, bits=12)
    assert main(["decode", str(manifest), "--out", str(tmp_path / "out"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["cameras"]["left"]["decoded_ratio"] > 0.98
    manifest.write_text(manifest.read_text().replace("saturation = 4095\n", ""))
    assert "need `saturation`" in refused_with(capsys, "decode", manifest, "--out", tmp_path / "other")


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("shift_sign = -1", "shift_sign = 2", "shift_sign"),
        ("projector_px = 1024", "projector_px = 1100", "beat of the pitches"),
        ("projector_px = 1024", "projektor_px = 1024", "projektor_px: is not a known field"),
        ("projector_px = 1024", "projector_px = ", "is not valid TOML"),
        ("pitch_px = 33", "pitch_px = 32", "beat|repeats|single pitch|not determine"),
        ("pitch_px = 33", "periods = 32\npitch_px = 33", "either pitch_px or periods"),
        ('kind = "phase-shift"', 'kind = "phase-shifts"', "phase-shifts"),
        ("left/1000_3.png", "left/1000_2.png", "more than once"),
        ("left/1000_3.png", "left/none.png", "none.png cannot be read"),
        ('"left/1000_2.png", "left/1000_3.png"', '"left/1000_2.png"', "differs from the group|differ"),
        ('"left/1000_1.png", "left/1000_2.png", "left/1000_3.png"', '"left/1000_1.png"', "needs at least 3"),
        ("exposure_us = 500", "exposure_us = 1000", "same exposure_us"),
        ("saturation = 255", "saturation = 4095", "have 8 bit"),
    ],
)
def test_a_manifest_that_cannot_be_right_is_refused_by_the_place(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], old: str, new: str, expected: str
) -> None:
    manifest = write_paper_set(tmp_path)
    text = manifest.read_text()
    assert old in text
    manifest.write_text(text.replace(old, new, 1) if "pitch_px = 33" not in old else text.replace(old, new))
    said = refused_with(capsys, "decode", manifest, "--out", tmp_path / "out")
    assert any(part in said for part in expected.split("|")), said
    assert not (tmp_path / "out").exists()


def test_images_that_are_damaged_or_do_not_fit_each_other_are_refused_by_name(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = write_paper_set(tmp_path)
    image = tmp_path / "left" / "1000_2.png"
    whole = image.read_bytes()
    for damage, expected in (
        (whole[: len(whole) // 2], "truncated"),
        (b"no image", "not a readable image"),
        (b"", "not a readable image"),
        (cv2.imencode(".png", np.zeros((40, 255), np.uint8))[1].tobytes(), "255 × 40 px"),
        (cv2.imencode(".png", np.zeros((40, 256), np.uint16))[1].tobytes(), "16 bit"),
    ):
        image.write_bytes(damage)
        said = refused_with(capsys, "decode", manifest, "--out", tmp_path / "out")
        assert "1000_2.png" in said
        assert expected in said
    assert not (tmp_path / "out").exists()
    assert "cannot be read" in refused_with(capsys, "decode", tmp_path / "none.toml", "--out", tmp_path / "out")


def test_without_projector_px_the_beat_is_the_range(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = write_paper_set(tmp_path)
    manifest.write_text(manifest.read_text().replace("projector_px = 1024\n", ""))
    assert main(["decode", str(manifest), "--out", str(tmp_path / "out"), "--json"]) == 0
    with np.load(json.loads(capsys.readouterr().out)["cameras"]["left"]["file"]) as arrays:
        assert arrays["projector_px"] == 1056


def test_the_recorded_real_set_decodes_from_its_manifest(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = write_recorded_manifest(tmp_path, recorded("slmaster_real_mono"), {"one": "."}, list(range(12)), list(range(12, 18)), 32)
    command = ["decode", str(manifest), "--out", str(tmp_path / "out"), "--json"]
    assert main([*command, "--min-modulation", "10"]) == 0
    assert json.loads(capsys.readouterr().out)["cameras"]["one"]["decoded_px"] == pytest.approx(214_654, rel=0.001)
    assert main(command) == 0
    found = json.loads(capsys.readouterr().out)["cameras"]["one"]
    assert found["decoded_px"] > 216_000  # fainter ones, too
    assert found["noise"]["from_images"]
    assert found["noise"]["scatter"] == pytest.approx(1.0, abs=0.15)
    stated = manifest.read_text()
    manifest.write_text(stated.replace("  complementary = true\n", ""))
    assert "the code is complementary" in refused_with(capsys, "decode", manifest, "--out", tmp_path / "other")
    manifest.write_text(stated.replace("shift_sign = 1", "shift_sign = -1"))
    assert "decreases where the Gray code increases" in refused_with(capsys, "decode", manifest, "--out", tmp_path / "other")


def test_the_guard_against_blooming_is_chosen_from_the_images_or_refused_in_words(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    manifest = write_paper_set(tmp_path / "images")
    asked = ["decode", str(manifest), "--out", str(tmp_path / "maps"), "--json", "--blooming-px"]
    assert main([*asked, "auto"]) == 0
    assert json.loads(capsys.readouterr().out)["settings"]["blooming_radius_px"] == 0
    for wrong in ("17", "-1", "far"):
        assert main([*asked, wrong]) != 0
        assert "not a radius" in json.loads(capsys.readouterr().out)["error"]["message"]
