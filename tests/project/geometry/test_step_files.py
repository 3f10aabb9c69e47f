"""STEP files as nominals: units and chords where the library is there, words where it is not, and limits in any case."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import numpy as np
import pytest

from measureapp.data.length_unit import LengthUnit
from measureapp.errors import InputError
from measureapp.project.geometry import step_files
from measureapp.project.geometry.files import read_mesh, read_points
from measureapp.project.geometry.step_files import StepLimits, read_step
from tests.project.geometry.step_part import cylinder

WITH_LIBRARY = pytest.mark.skipif(importlib.util.find_spec("cascadio") is None, reason="the optional library cascadio is not installed")
RADIUS, HEIGHT = 10.0, 20.0
SINGLE = 2.0**-23  # numbers in glTF


@pytest.fixture
def part(tmp_path: Path) -> Path:
    path = tmp_path / "part.step"
    path.write_text(cylinder(RADIUS, HEIGHT))
    return path


@pytest.fixture
def library(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a worker of the test stand in for one that needs the library."""
    monkeypatch.setattr(step_files, "find_spec", lambda _: True)


def worker(folder: Path, code: str) -> Path:
    path = folder / "worker.py"
    path.write_text(code, encoding="utf-8")
    return path


def test_without_the_library_a_step_file_is_refused_with_the_remedy(part: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(step_files, "find_spec", lambda _: None)
    with pytest.raises(InputError, match=r"part\.step is a STEP file; the library that reads it is not installed") as caught:
        read_mesh(part)
    assert "pip install cascadio" in caught.value.hint and "STL" in caught.value.hint


def test_what_is_no_step_file_is_refused_whether_the_library_is_there_or_not(tmp_path: Path) -> None:
    path = tmp_path / "part.stp"
    path.write_bytes(b"solid part\n" * 100)
    with pytest.raises(InputError, match="is not a STEP file"):
        read_mesh(path)
    with pytest.raises(InputError, match="unknown kind"):
        read_points(path)


def test_a_step_file_states_its_unit_itself(part: Path) -> None:
    with pytest.raises(InputError, match="states its unit itself"):
        read_mesh(part, unit=LengthUnit.INCH)


def test_a_worker_that_takes_too_long_is_ended(part: Path, library: None, tmp_path: Path) -> None:
    slow = worker(tmp_path, "import time\ntime.sleep(60)")
    with pytest.raises(InputError, match=r"not tessellated within 0\.5 s") as caught:
        read_step(part, StepLimits(longest_s=0.5), slow)
    assert "STL" in caught.value.hint


@pytest.mark.parametrize(
    ("code", "complaint"),
    [
        ("import sys; sys.exit(3)", "of memory"),
        ("import sys; sys.exit(4)", "contains no surface, or is damaged"),
        ("raise ValueError('bad face')", r"ended with code 1 \(ValueError: bad face\)"),
        ("import os; os.abort()", "was ended by signal"),
        ("pass", "ended with code 0"),
    ],
)
def test_a_worker_that_fails_is_reported_in_words(code: str, complaint: str, part: Path, library: None, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=complaint):
        read_step(part, StepLimits(), worker(tmp_path, code))


@WITH_LIBRARY
@pytest.mark.parametrize("inches", [False, True])
def test_a_cylinder_has_its_size_in_millimetres_and_keeps_the_chord(inches: bool, tmp_path: Path) -> None:
    path = tmp_path / "part.step"
    path.write_text(cylinder(RADIUS, HEIGHT, inches=inches))
    mesh = read_mesh(path)
    scale = 25.4 if inches else 1.0
    radius, height = RADIUS * scale, HEIGHT * scale
    assert np.ptp(mesh.vertices_mm[:, 2]) == pytest.approx(height, abs=4 * SINGLE * height)
    round_it = np.hypot(*mesh.vertices_mm[:, :2].T)
    assert round_it.max() == pytest.approx(radius, abs=4 * SINGLE * radius)
    corners = mesh.vertices_mm[mesh.triangles]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    side = np.abs(cross[:, 2]) < 1e-6 * np.linalg.norm(cross, axis=1).max()
    middles = (corners[side] + np.roll(corners[side], 1, axis=1)) / 2
    assert radius - np.hypot(*middles.reshape(-1, 3)[:, :2].T).min() < StepLimits().chord_mm
    volume = np.einsum("nd,nd->n", corners[:, 0], cross).sum() / 6  # positive: corners counter-clockwise seen from outside
    assert 0 < np.pi * radius**2 * height - volume < 2 * np.pi * radius * height * StepLimits().chord_mm


@WITH_LIBRARY
def test_a_step_file_cut_short_or_without_surface_is_refused(part: Path) -> None:
    part.write_text(part.read_text()[:900])
    with pytest.raises(InputError, match="could not be tessellated"):
        read_mesh(part)


@WITH_LIBRARY
def test_memory_beyond_the_limit_is_refused(part: Path) -> None:
    with pytest.raises(InputError, match="could not be tessellated"):
        read_step(part, StepLimits(memory_bytes=2**26))
