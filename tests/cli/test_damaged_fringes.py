"""Recorded fringe sets whose manifest, images or cameras cannot be right."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from measureapp.cli import main
from tests.cli.refusal import cut_in_half, refused


def changed(manifest: Path, old: str, new: str) -> None:
    text = manifest.read_text(encoding="utf-8")
    assert old in text
    manifest.write_text(text.replace(old, new), encoding="utf-8")


@pytest.mark.parametrize(
    ("old", "new", "named"),
    [
        ("pitch_px = 33", "pitch_px = 32", "32"),  # two equal pitches
        ("pitch_px = 33", "pitch_px = 36", ""),  # their beat is shorter than the projector is wide
        ('"left/1000_3.png"', '"left/1000_2.png"', "more than once"),
        (', "left/1000_3.png"]', "]", "differ"),  # an image too few
        ("left/1000_3.png", "left/1000_9.png", "1000_9.png"),
        ('kind = "phase-shift"', 'kind = "moire"', "kind"),
        ("shift_sign = -1", "shift_sign = 0", "shift_sign"),
        ("pitch_px = 32", "pitch_px = nan", "pitch_px"),
        ("exposure_us = 500", "exposure_us = 1000", "exposure"),
        ("projector_px = 1024", "projector_px = 1024\nprojektor = 2", "projektor"),
    ],
)
def test_a_manifest_that_cannot_be_right_is_refused(old: str, new: str, named: str, fringes: Path, tmp_path: Path, capsys) -> None:
    changed(fringes, old, new)
    assert named in refused(capsys, ["decode", str(fringes), "--out", str(tmp_path / "out")])
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("ending", ["png", "tif", "bmp"])
def test_an_image_cut_in_half_is_refused(ending: str, fringes: Path, tmp_path: Path, capsys) -> None:
    image = fringes.parent / "left" / f"half.{ending}"
    cv2.imwrite(str(image), cv2.imread(str(fringes.parent / "left" / "1000_1.png"), cv2.IMREAD_UNCHANGED))
    changed(fringes, "left/1000_1.png", f"left/half.{ending}")
    assert main(["decode", str(fringes), "--out", str(tmp_path / "sound")]) == 0
    capsys.readouterr()
    cut_in_half(image)
    assert image.name in refused(capsys, ["decode", str(fringes), "--out", str(tmp_path / "out")])
    assert not (tmp_path / "out").exists()


def test_an_image_of_another_size_is_refused(fringes: Path, tmp_path: Path, capsys) -> None:
    cv2.imwrite(str(fringes.parent / "left" / "500_5.png"), np.zeros((40, 255), np.uint8))
    assert "500_5.png" in refused(capsys, ["decode", str(fringes), "--out", str(tmp_path / "out")])
    assert not (tmp_path / "out").exists()


def test_cameras_that_did_not_take_the_images_are_refused(fringes: Path, shelf: Path, tmp_path: Path, capsys) -> None:
    other = tmp_path / "cameras.json"
    other.write_text((shelf / "cameras.json").read_text().replace('"width": 256', '"width": 640'))
    said = refused(capsys, ["reconstruct", str(fringes), "--cameras", str(other), "--out", str(tmp_path / "out.ply")])
    assert "calibrated for 640 × 40 px" in said
    other.write_text((shelf / "cameras.json").read_text().replace('"left"', '"lower"'))
    said = refused(capsys, ["reconstruct", str(fringes), "--cameras", str(other), "--out", str(tmp_path / "out.ply")])
    assert "has no camera 'left'" in said
    assert not (tmp_path / "out.ply").exists()
