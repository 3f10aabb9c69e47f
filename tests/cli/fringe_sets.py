"""Writes small recorded sets for the tests of `decode` and `reconstruct`."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from measureapp.data.fringe import PatternSet
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.patterns.draw import pattern_images


def write_paper_set(folder: Path, cameras: tuple[str, ...] = ("left",), exposures: tuple[int, ...] = (1000, 500), bits: int = 8) -> Path:
    """Write what cameras of 256 × 40 px see of a flat surface, and the manifest that says so."""
    drawn = _seen(PAPER_PATTERNS)
    lines = ["shift_sign = -1", "projector_px = 1024", f"saturation = {2**bits - 1}"]
    for exposure in exposures:
        lines += ["[[exposure]]", f"exposure_us = {exposure}"]
        for group in range(2):
            names = {camera: [f"{camera}/{exposure}_{4 * group + n}.png" for n in range(4)] for camera in cameras}
            listed = ", ".join(f"{camera} = {files!r}".replace("'", '"') for camera, files in names.items())
            lines += ["[[exposure.group]]", 'kind = "phase-shift"', f"pitch_px = {32 + group}", f"images = {{ {listed} }}"]
            for camera, files in names.items():
                (folder / camera).mkdir(parents=True, exist_ok=True)
                for n, file in enumerate(files):
                    grey = drawn[4 * group + n] * (exposure / exposures[0]) * (2**bits / 256)
                    cv2.imwrite(str(folder / file), np.rint(grey).astype(np.uint8 if bits == 8 else np.uint16))
    manifest = folder / "MANIFEST.toml"
    manifest.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return manifest


def _seen(patterns: PatternSet) -> np.ndarray:
    columns = np.linspace(10, 1000, 256).astype(int)
    return pattern_images(patterns, 1024, 40)[:, :, columns] * 0.7 + 20


def write_recorded_manifest(
    folder: Path, images: Path, cameras: dict[str, str], sinusoids: list[int], gray: list[int], periods: int
) -> Path:
    """Write a manifest of a set with one pitch over 1920 columns and complementary Gray code."""

    def listed(numbers: list[int]) -> str:
        entries = []
        for camera, place in cameras.items():
            files = ", ".join(f'"{images / place}/{n:02d}.png"' for n in numbers)
            entries.append(f"{camera} = [{files}]")
        return "{ " + ", ".join(entries) + " }"

    text = f"""
shift_sign = 1
saturation = 255
projector_px = 1920
[[exposure]]
exposure_us = 10000
  [[exposure.group]]
  kind = "phase-shift"
  periods = {periods}
  images = {listed(sinusoids)}
  [[exposure.group]]
  kind = "gray-code"
  complementary = true
  images = {listed(gray)}
"""
    manifest = folder / "MANIFEST.toml"
    manifest.write_text(text, encoding="utf-8")
    return manifest
