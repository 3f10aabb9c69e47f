"""The virtual rig as a file, small enough for tests."""

from __future__ import annotations

from pathlib import Path

from measureapp.resources import resource


def write_binned_rig(path: Path, driver_settings: str, binning: int = 4) -> Path:
    """Write the paper's rig at a share of its resolution, with settings of its driver as in TOML; returns the path.

    A quarter is that of the demo and its calibration; an eighth does where nothing is measured in the images.
    """
    text = resource("rigs/paper.toml").read_text(encoding="utf-8")
    for name, full in (("", 2592), ("", 1944), ("pixel_um ", 2.2)):
        text = text.replace(f"{name}= {full}", f"{name}= {round(full * binning, 1) if name else full // binning}")
    settings = f"driver_settings = {{ {driver_settings} }}\n"
    path.write_text(text.replace('reference = "left"\n', 'reference = "left"\n' + settings, 1), encoding="utf-8")
    return path
