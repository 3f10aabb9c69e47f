"""Every kernel and its statement in NumPy agree on the inputs that a reconstruction gives them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.reconstruct import kernels
from measureapp.reconstruct.kernels import reference
from measureapp.reconstruct.projector.depth import triangulate_with_projector
from measureapp.reconstruct.reconstruct import reconstruct
from measureapp.reconstruct.settings import ReconstructSettings
from tests.reconstruct.conftest import make_head, nearest, plane, sphere
from tests.reconstruct.projector_scene import make_head as make_projector_head

SIGMA_RAD, BLUR_PX = 0.012, 0.75
EXACT = 0.0
FLOAT32 = 1e-5  # relative to the scale of an output
DECISIONS = 1e-3  # share of pixels at which rounding may decide otherwise
TOLERANCES = {  # by kernel: relative difference of floating-point outputs
    "correct_blur": 2e-6,
    "measure_gradients": FLOAT32,
    "rectify_pixels": FLOAT32,
    "match_and_fuse": 2e-4,  # a place of phase near 200 rad is rounded to 1e-4 px
    "keep_new": 2e-4,
    "check_orthogonal": 2e-4,
    "invert_depth": 2e-7,
    "reject_points": 2e-3,  # of normals: sums of float32
    "refit_normals": 2e-3,
    "gather_points": FLOAT32,
    "resample_phase": FLOAT32,
    "triangulate": 2e-4,
}
Scene = tuple[dict[str, PhaseMap], CameraArrayCalibration]


@pytest.fixture(scope="module")
def scene() -> Scene:
    """Spheres before a wall with noise, uneven light, holes, wrong fringe orders, and fringes of both directions."""
    head = make_head(16)
    cameras = {name: replace(camera, blur_px=BLUR_PX) for name, camera in head.cameras.cameras.items()}
    surface = nearest(sphere((20, -10, 500), 40), sphere((-60, 0, 470), 30), plane(560))
    random, maps = np.random.default_rng(6), {}
    horizontal = head.phase_maps(surface, SIGMA_RAD, 3, horizontal=True)
    for name, seen in head.phase_maps(surface, SIGMA_RAD, 2).items():
        phase, state, rows, columns = seen.phase_rad.copy(), seen.state.copy(), *np.mgrid[: seen.state.shape[0], : seen.state.shape[1]]
        for row, column in random.integers(0, (120, 160), (30, 2)):
            phase[row : row + 3, column : column + 3] += np.float32(2 * np.pi * random.choice([-1, 1]))
            state[row + 9 : row + 9 + random.integers(1, 5), column : column + random.integers(1, 5)] = PixelState.SHADOW
        grey = (100 + 40 * np.sin(columns / 5) + 10 * np.cos(rows / 3)).astype(np.uint16)
        maps[name] = replace(seen, phase_rad=phase, state=state, grey=grey, orthogonal=replace(horizontal[name], direction="horizontal"))
    return maps, replace(head.cameras, cameras=cameras)


def copied(value: Any) -> Any:
    """Return an argument of a kernel whose arrays are copies."""
    if isinstance(value, np.ndarray):
        return value.copy()
    if isinstance(value, tuple):
        parts = [copied(each) for each in value]
        return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    return value


def arrays(value: Any) -> list[np.ndarray]:
    """Return all arrays of an argument."""
    if isinstance(value, np.ndarray):
        return [value]
    return [array for each in value for array in arrays(each)] if isinstance(value, tuple) else []


@pytest.fixture
def compared(monkeypatch: pytest.MonkeyPatch) -> dict[str, int]:
    """Compare every call of a kernel with its reference; returns how often each was called."""
    calls: dict[str, int] = {}

    def comparing(name: str, kernel: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any) -> None:
            calls[name] = calls.get(name, 0) + 1
            others = tuple(copied(each) for each in arguments)
            kernel(*arguments)
            getattr(reference, name)(*others)
            if name in ("reject_points", "refit_normals"):  # normals without a point are undefined
                for surface, normals in ((each[0], each[-1 if name == "refit_normals" else -2]) for each in (arguments, others)):
                    normals[:, surface.inverse[surface.radius : -surface.radius, surface.radius : -surface.radius] == 0] = 0
            for number, (made, expected) in enumerate(zip(arrays(arguments), arrays(others), strict=True)):
                agree(f"{name}, array {number}", made, expected, TOLERANCES.get(name, EXACT))

        return call

    monkeypatch.setattr("measureapp.arrays.processors", lambda: 1)
    monkeypatch.setattr(kernels, "_COMPILED", {name: comparing(name, kernel) for name, kernel in kernels._COMPILED.items()})
    return calls


def agree(name: str, made: np.ndarray, expected: np.ndarray, tolerance: float) -> None:
    """Whole numbers must be equal and others within a tolerance of their scale, but for a share of DECISIONS."""
    if made.dtype.kind != "f":
        assert np.count_nonzero(made != expected) <= DECISIONS * made.size, name
        return
    known = np.isfinite(made) & np.isfinite(expected)
    scale = max(float(np.abs(expected[known]).max(initial=0.0)), 1e-30)
    off = np.abs(made[known] - expected[known]) / scale
    assert np.count_nonzero(off > tolerance) <= DECISIONS * made.size, f"{name}: {np.sort(off)[-5:]}"


PAIR, THREE = ("left", "right"), ("left", "right", "upper")


@pytest.mark.parametrize(
    ("names", "both"),  # every kernel runs in one of the first two
    [(PAIR, True), (THREE, False), *(pytest.param(*one, marks=pytest.mark.slow) for one in ((PAIR, False), (THREE, True)))],
)
def test_the_kernels_of_a_reconstruction_agree_with_their_references(
    scene: Scene, compared: dict[str, int], names: tuple[str, ...], both: bool
) -> None:
    maps, cameras = scene
    used = {name: maps[name] if both else replace(maps[name], orthogonal=None) for name in names}
    made = reconstruct(used, cameras, ReconstructSettings(max_sigma_mm=1.0))
    assert len(made.cloud) > 5_000
    expected = set(kernels._COMPILED) - {"triangulate"}
    expected -= set() if both else {"check_orthogonal"}
    expected -= {"resample_phase"} if len(names) > 2 else {"keep_new"}
    assert set(compared) == expected


def test_triangulation_with_the_projector_agrees_with_its_reference(compared: dict[str, int]) -> None:
    head = make_projector_head()
    for across in (False, True):
        seen = head.phase_maps(plane(550, 0.2, 0.1), across=across)["left"]
        assert head.cameras.projector is not None
        triangulate_with_projector(seen, head.cameras.cameras["left"], head.cameras.projector)
    assert compared["triangulate"] > 1


def test_a_reconstruction_runs_on_the_references_alone(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    maps, cameras = scene
    compiled = reconstruct(maps, cameras)
    monkeypatch.setenv("MEASUREAPP_KERNELS", "reference")
    monkeypatch.setattr(kernels, "_COMPILED", dict.fromkeys(kernels._COMPILED))
    stated = reconstruct(maps, cameras)
    places = [
        each.cloud.pixel[:, 0] * 10_000 + each.cloud.pixel[:, 1] + (each.cloud.cameras.astype(int) & 1) * 10**8
        for each in (compiled, stated)
    ]
    _, ours, theirs = np.intersect1d(*places, return_indices=True)
    assert len(ours) > 0.998 * max(len(compiled.cloud), len(stated.cloud))
    off = np.linalg.norm(compiled.cloud.points_mm[ours] - stated.cloud.points_mm[theirs], axis=1) / compiled.cloud.sigma_mm[ours]
    assert np.percentile(off, 99.8) < 0.05
