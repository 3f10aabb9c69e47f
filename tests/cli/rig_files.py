"""The virtual rig as a file, small enough for tests."""

from __future__ import annotations

from pathlib import Path

from measureapp.resources import resource


def write_quarter_rig(path: Path, driver_settings: str) -> Path:
    """Write the paper's rig at a quarter of its resolution, with settings of its driver as in TOML; returns the path."""
    text = resource("rigs/paper.toml").read_text(encoding="utf-8")
    for full, quarter in (("= 2592", "= 648"), ("= 1944", "= 486"), ("pixel_um = 2.2", "pixel_um = 8.8")):
        text = text.replace(full, quarter)
    settings = f"driver_settings = {{ {driver_settings} }}\n"
    path.write_text(text.replace('reference = "left"\n', 'reference = "left"\n' + settings, 1), encoding="utf-8")
    return path
