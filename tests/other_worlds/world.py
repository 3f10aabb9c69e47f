"""Recordings of a rig that this project did not simulate: images of a path-tracing renderer, described as `measureapp import` wants them."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.resources import resource
from tests.other_worlds.render import BRIGHT_US, FAINT_US

RENDERER, CACHE = "MEASUREAPP_PATH_TRACER", "MEASUREAPP_PATH_TRACED"
RENDER = Path(__file__).with_name("render.py")
OWN_PART = "artefact"  # of the renderer: spheres on posts, a cylinder and a step on a plate
OWN_PROGRAM = Path(__file__).with_name("artefact_program.toml")
FOCAL_MM, PIXEL_UM, FULL_PX = 9.0, 2.2, (2592, 1944)
AS_RENDERED = ("--scale", "0.25", "--spp", "25", "--boards", "14", "--axis", "7", "--seed", "1")


def rendered(name: str, views: int, own: Path) -> Path:
    """Return the folder of a rendered part: that of the cache, or rendered into it, or into ``own`` without a cache; else skip the test.

    ``MEASUREAPP_PATH_TRACER`` is the renderer's Python and its program, with a space between; ``MEASUREAPP_PATH_TRACED`` the cache.
    """
    folder = Path(os.environ.get(CACHE, own)) / name
    if not (folder / "truth.json").is_file():
        if RENDERER not in os.environ:
            pytest.skip(f"neither {RENDERER} (Python and program of the renderer) nor {CACHE} with a folder {name!r} is set")
        part = name if name == OWN_PART else str(resource(f"parts/{name}/nominal.stl"))
        python, program = os.environ[RENDERER].split()
        subprocess.run([python, str(RENDER), program, str(folder), *AS_RENDERED, "--views", str(views), "--part", part], check=True)
    return folder


def describe(folder: Path, name: str, exposures_us: tuple[int, ...], part: str) -> Path:
    """Write a RECORDING.toml with these exposures of all views beside the images; return it."""
    truth = json.loads((folder / "truth.json").read_text(encoding="utf-8"))
    _write_rig(folder / "rig.toml", truth, exposures_us)
    own = part == OWN_PART
    documents = {
        "program.toml": OWN_PROGRAM if own else resource(f"parts/{part}/program.toml"),
        "nominal.stl": folder / "part.stl" if own else resource(f"parts/{part}/nominal.stl"),
    }
    for kind, source in documents.items():
        (folder / kind).write_bytes(source.read_bytes())
    columns, rows = truth["board"]["inner_corners"]
    lines = ["schema_version = 1", 'rig = "rig.toml"', "[board]", 'kind = "checkerboard"', f"inner_corners = [{columns}, {rows}]"]
    lines += [f"square_mm = {truth['board']['square_mm']}"]
    cameras = list(truth["cameras"]["cameras"])
    for file in sorted((folder / "boards" / "left").glob("*.png")):
        lines += _board_view(f"boards/{{}}/{file.name}", cameras, 0.0, on_table=False)
    for file, angle in zip(sorted((folder / "axis" / "left").glob("*.png")), truth["axis_angles_deg"], strict=True):
        lines += _board_view(f"axis/{{}}/{file.name}", cameras, angle, on_table=True)
    for view in truth["views"]:
        manifest = folder / view["name"] / f"{name}.toml"
        manifest.write_text(_manifest(cameras, exposures_us), encoding="utf-8")
        lines += [
            "[[viewpoint]]",
            f'id = "{view["name"]}"',
            f'manifest = "{view["name"]}/{name}.toml"',
            f"table_deg = {view['table_deg']!r}",
        ]
    lines += ["[part]", 'nominal = "nominal.stl"', 'program = "program.toml"']
    path = folder / f"{name}.toml"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def _board_view(pattern: str, cameras: list[str], angle_deg: float, on_table: bool) -> list[str]:
    images = ", ".join(f'{camera} = "{pattern.format(camera)}"' for camera in cameras)
    return ["[[board_view]]", f"images = {{ {images} }}", f"table_deg = {angle_deg!r}", f"on_table = {str(on_table).lower()}"]


def _manifest(cameras: list[str], exposures_us: tuple[int, ...]) -> str:
    lines = ["shift_sign = -1", "saturation = 255", "projector_px = 1024"]
    for exposure in exposures_us:
        level = (*BRIGHT_US, *FAINT_US).index(exposure)
        lines += ["[[exposure]]", f"exposure_us = {exposure}"]
        for group, pitch in enumerate((32, 33)):
            files = {camera: [f"{camera}/e{level}_{4 * group + step}.png" for step in range(4)] for camera in cameras}
            lines += ["[[exposure.group]]", 'kind = "phase-shift"', f"pitch_px = {pitch}"]
            lines.append("images = { " + ", ".join(f"{camera} = {json.dumps(names)}" for camera, names in files.items()) + " }")
    return "\n".join(lines) + "\n"


def _write_rig(path: Path, truth: dict[str, Any], exposures_us: tuple[int, ...]) -> None:
    """Describe cameras and table as a data sheet would: nominal values, rounded."""
    lines = ["schema_version = 2", 'name = "Path-traced rig"', 'driver = "recorded"', 'reference = "left"', "standoff_mm = 550.0"]
    lines += [f"exposures_us = {list(exposures_us)}"]
    for name, camera in truth["cameras"]["cameras"].items():
        pose = np.array(camera["reference_from_camera"])
        turn = Rotation.from_matrix(pose[:3, :3]).as_euler("XYZ", degrees=True).round(0).tolist()
        pixel_um = PIXEL_UM * FULL_PX[0] / camera["width"]
        lines += ["[[cameras]]", f'name = "{name}"', 'model = "rendered"', f'serial = "{name}"', "bit_depth = 8", f"focal_mm = {FOCAL_MM}"]
        lines += [f"width_px = {camera['width']}", f"height_px = {camera['height']}", f"pixel_um = {pixel_um!r}"]
        lines += [f"head_from_camera = {{ position_mm = {pose[:3, 3].round(0).tolist()}, rotation_deg = {turn} }}"]
    lines += ["[projector]", 'name = "projector"', 'model = "rendered"', "width_px = 1024", "height_px = 768", "focal_px = 1576.0"]
    lines += ["head_from_projector = { position_mm = [175.0, 0.0, 0.0], rotation_deg = [0.0, 0.0, 0.0] }"]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
