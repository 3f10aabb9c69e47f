"""Measuring uses images and read-backs only."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from demo_fixture import Demo

from measureapp.simulate.truth import Truth

ROOT = Path(__file__).resolve().parents[2]
BLINDFOLDED = """
import contextlib, importlib.abc, os, pathlib, sys

HIDDEN = ("measureapp.simulate", "measureapp.demo", "plugins", "_measureapp_plugins")
FOLDERS = tuple(os.path.join(sys.argv[1], *parts) + os.sep for parts in (("measureapp", "simulate"), ("plugins",)))


class Blindfold(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if any(name == hidden or name.startswith(hidden + ".") for hidden in HIDDEN):
            raise ImportError(f"{name} is hidden")
        return None


def closed(event, arguments):
    if event == "open" and isinstance(arguments[0], str) and os.path.abspath(arguments[0]).startswith(FOLDERS):
        raise PermissionError(f"{arguments[0]} is hidden")


sys.meta_path.insert(0, Blindfold())
sys.addaudithook(closed)
for name in HIDDEN[:2]:
    try:
        __import__(name)
    except ImportError:
        continue
    sys.exit(f"{name} is in sight")

import found_boards
from measureapp.cli import main
from without_pictures import without_surface_and_pictures

found_boards.take_found(pathlib.Path(sys.argv[3]))
found_boards.forget_every(10)  # which are searched here, too
whole = contextlib.nullcontext() if sys.argv[4] == "whole" else without_surface_and_pictures()
with found_boards.found_once(), whole:
    sys.exit(main(["process", sys.argv[2], "--json"]))
"""
NUMBER = re.compile(r"-?\d+\.\d+(?:[eE][-+]?\d+)?")


@pytest.mark.parametrize("extent", ["points and dimensions", pytest.param("whole", marks=pytest.mark.slow)])
def test_a_program_without_the_simulation_measures_the_same_from_the_stored_images(demo: Demo, raw_copy: Path, extent: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", BLINDFOLDED, str(ROOT), str(raw_copy), str(demo.boards), extent],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), str(ROOT / "tests")))},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == demo.code, done.stderr
    document = json.loads(done.stdout)
    assert "truth" not in document["calibration"]
    measured = {dimension["name"]: dimension["measured"] for dimension in document["dimensions"]}
    assert measured == pytest.approx({one["name"]: one["measured"] for one in demo.document["dimensions"]}, abs=1e-9)
    assert document["calibration"]["hand_eye"]["flange_from_camera"] == pytest.approx(
        np.array(demo.document["calibration"]["hand_eye"]["flange_from_camera"]), abs=1e-9
    )
    assert (raw_copy / "calibration" / "rig.json").exists()
    assert (raw_copy / "report" / "report.pdf").read_bytes().startswith(b"%PDF")


def test_no_file_of_a_project_holds_a_true_value(demo: Demo, truth: Truth) -> None:
    hidden = np.sort(np.array([value for value in numbers(truth) if is_telling(value)]))
    assert len(hidden) > 100
    texts = [path for kind in ("json", "toml", "csv") for path in demo.folder.rglob(f"*.{kind}")]
    assert {"project.json", "plan.json", "rig.json", "cameras.json", "view.json", "stack.json", "measurement.json"} <= {
        path.name for path in texts
    }
    for path in texts:
        written = np.array([float(text) for text in NUMBER.findall(path.read_text(encoding="utf-8-sig"))])
        written = written[[is_telling(value) for value in written]] if len(written) else written
        gap = np.min(np.abs(np.subtract.outer(written, hidden) / hidden), initial=1.0)
        assert gap > 1e-12, f"{path} holds a true value"


def test_the_search_for_true_values_would_find_one(truth: Truth) -> None:
    focal = float(truth.calibration.cameras.cameras["left"].pinhole.matrix[0, 0])
    text = json.dumps({"matrix": [[focal, 0.0]]})
    assert focal in {float(found) for found in NUMBER.findall(text)}
    assert focal in set(numbers(truth))
    assert is_telling(focal)


def numbers(value: Any) -> Iterator[float]:
    """Every number in a noun, however deep."""
    if isinstance(value, (float, np.floating)):
        yield float(value)
    elif isinstance(value, np.ndarray):
        yield from (float(number) for number in value.ravel())
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from numbers(item)
    elif isinstance(value, (tuple, list)):
        for item in value:
            yield from numbers(item)
    elif is_dataclass(value):
        for entry in fields(value):
            yield from numbers(getattr(value, entry.name))
    elif hasattr(value, "matrix"):
        yield from numbers(value.matrix)


def is_telling(value: float) -> bool:
    """Whether a number has so many digits that it cannot be right by chance, as 0, 1 or a length on a drawing can."""
    return abs(value - round(value, 6)) > 1e-9
