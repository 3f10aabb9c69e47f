"""A project written as a recording of another rig: PNG files, manifests and RECORDING.toml, by code of its own."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from math import degrees
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import cv2
import numpy as np

from measureapp.data.board import BoardView
from measureapp.data.fringe import AxisReadback, FringeStack, GrayCodeGroup
from measureapp.project.calibration import board_views
from measureapp.project.folder import ProjectFolder
from measureapp.resources import resource

BOARD_14_11 = '[board]\nkind = "checkerboard"\ninner_corners = [14, 11]\nsquare_mm = 15.0'


@dataclass(frozen=True)
class Chosen:
    """What of a project is recorded."""

    board_views: tuple[str, ...] | None = None  # None: all
    viewpoints: tuple[str, ...] | None = None
    axes: tuple[str, ...] = ("base_from_flange", "guide_mm", "table_deg")
    rig: bool = True
    known_cameras: bool = False
    part: bool = True


def write_recording(project: ProjectFolder, folder: Path, chosen: Chosen = Chosen()) -> Path:
    """Write images and read-backs of ``project`` into ``folder``; return the RECORDING.toml."""
    folder.mkdir(parents=True)
    lines = ["schema_version = 1"]
    if chosen.rig:
        write_rig(project, folder / "rig.toml")
        lines.append('rig = "rig.toml"')
    if chosen.known_cameras:
        (folder / "cameras.json").write_text(json.dumps(_cameras(project)), encoding="utf-8")
        lines.append('cameras = "cameras.json"')
    views = project.board_views() if chosen.board_views is None else views_named(project, chosen.board_views)
    lines += [BOARD_14_11] if views else []
    for view in views:
        lines += _board_view(view, folder, chosen.axes)
    for name in project.stored_viewpoints():
        if chosen.viewpoints is None or name in chosen.viewpoints:
            lines += _viewpoint(project.frames.load(name), folder, chosen.axes)
    if chosen.part:
        for kind in ("program.toml", "nominal.stl"):
            (folder / kind).write_bytes(resource(f"parts/gypsum/{kind}").read_bytes())
        lines += ["[part]", 'nominal = "nominal.stl"', 'program = "program.toml"']
    path = folder / "RECORDING.toml"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def views_named(project: ProjectFolder, names: tuple[str, ...]) -> tuple[BoardView, ...]:
    """Load these views of the board, in the order of acquisition; no other image is read."""
    with TemporaryDirectory() as place:
        for name in names:
            (Path(place) / name).symlink_to(project.path / "calibration" / "views" / name, target_is_directory=True)
        return board_views.load_all(Path(place))


def write_rig(project: ProjectFolder, path: Path) -> None:
    """Write the rig as a description with driver "recorded"."""
    document = project.rig().model_dump(mode="json", exclude_none=True)
    document = {name: value for name, value in document.items() if name not in ("driver_settings", "devices", "links", "head", "motion")}
    document["driver"] = "recorded"
    path.write_text("\n".join(_toml(document)) + "\n", encoding="utf-8")


def _board_view(view: BoardView, folder: Path, axes: tuple[str, ...]) -> list[str]:
    named = {}
    for camera, image in view.images.items():
        named[camera] = f"board/{view.viewpoint_id}_{camera}.png"
        _write_png(folder / named[camera], image)
    pictures = ", ".join(f'{camera} = "{name}"' for camera, name in named.items())
    return ["[[board_view]]", f"images = {{ {pictures} }}", *_readback(view.readback, axes), "on_table = true"]


def _viewpoint(stack: FringeStack, folder: Path, axes: tuple[str, ...]) -> list[str]:
    manifest = folder / stack.viewpoint_id / "manifest.toml"
    lines = [
        f"shift_sign = {stack.patterns.shift_sign}",
        f"saturation = {stack.saturation}",
        f"projector_px = {stack.patterns.projector_px}",
    ]
    for level, exposure_us in enumerate(stack.exposures_us):
        lines += ["[[exposure]]", f"exposure_us = {exposure_us}"]
        number = 0
        for group in stack.patterns.groups:
            lines += ["[[exposure.group]]", f'kind = "{group.kind}"']
            lines.append(
                f"complementary = {str(group.complementary).lower()}"
                if isinstance(group, GrayCodeGroup)
                else f"pitch_px = {group.pitch_px!r}"
            )
            images = {}
            for camera, pixels in stack.images.items():
                images[camera] = [f"{camera}/e{level}_{number + n}.png" for n in range(group.count)]
                for n, name in enumerate(images[camera]):
                    _write_png(manifest.parent / name, pixels[level, number + n])
            lines.append("images = { " + ", ".join(f"{camera} = {json.dumps(names)}" for camera, names in images.items()) + " }")
            number += group.count
    manifest.write_text("\n".join(lines) + "\n", encoding="utf-8")
    named = f"{stack.viewpoint_id}/manifest.toml"
    assert stack.readback is not None
    return ["[[viewpoint]]", f'id = "{stack.viewpoint_id}"', f'manifest = "{named}"', *_readback(stack.readback, axes)]


def _readback(readback: AxisReadback, axes: tuple[str, ...]) -> Iterator[str]:
    if "base_from_flange" in axes:
        place, turn = (
            list(map(float, value)) for value in (readback.base_from_flange.translation_mm, readback.base_from_flange.quaternion_wxyz)
        )
        yield f"base_from_flange = {{ position_mm = {place}, quaternion_wxyz = {turn} }}"
    if "guide_mm" in axes:
        yield f"guide_mm = {float(readback.guide_mm)!r}"
    if "table_deg" in axes:
        yield f"table_deg = {degrees(readback.table_rad)!r}"


def _cameras(project: ProjectFolder) -> dict[str, Any]:
    known = project.require_calibration().cameras
    return {
        "schema_version": 1,
        "reference": known.reference,
        "cameras": {
            name: {
                "width": camera.pinhole.width_px,
                "height": camera.pinhole.height_px,
                "matrix": camera.pinhole.matrix.tolist(),
                "distortion": camera.pinhole.distortion.tolist(),
                "reference_from_camera": camera.reference_from_camera.matrix.tolist(),
            }
            for name, camera in known.cameras.items()
        },
    }


def _write_png(path: Path, pixels: Any) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(str(path), np.asarray(pixels), [cv2.IMWRITE_PNG_COMPRESSION, 1])


def _toml(document: dict[str, Any], prefix: str = "") -> Iterator[str]:
    """Write plain values first, then tables and lists of tables."""
    tables = {name: value for name, value in document.items() if _is_table(value)}
    yield from (f"{name} = {json.dumps(value)}" for name, value in document.items() if name not in tables)
    for name, value in tables.items():
        for one in value if isinstance(value, list) else [value]:
            yield f"[[{prefix}{name}]]" if isinstance(value, list) else f"[{prefix}{name}]"
            yield from _toml(one, f"{prefix}{name}.")


def _is_table(value: Any) -> bool:
    return isinstance(value, dict) or (isinstance(value, list) and bool(value) and isinstance(value[0], dict))
