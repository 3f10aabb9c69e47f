"""Uncertainty of a rig calibration as a file next to it: numbers only, no pickled objects."""

from __future__ import annotations

import zlib
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np

from measureapp.calibrate.motions.chain import Chain, Free
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.calibrate.motions.error_motions import MotionModel
from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty
from measureapp.data.calibration import LabelledCovariance, RigCalibration
from measureapp.errors import StorageError
from measureapp.project.array_files import read_npz
from measureapp.project.atomic import replacing
from measureapp.project.documents import noise_document, noise_from

SCHEMA_VERSION = 1
_NOT_ARRAYS = ("noise", "free", "motions")
_STORED = {"camera_jacobian": "by_cameras"}  # field of the chain -> its name in the file


def write_rig_uncertainty(path: Path, rig: RigUncertainty) -> None:
    """Write all but the calibration as npz: ``chain.…``, ``state.…``, ``noise.…``, ``free.…``, ``motions.…``, ``cameras.…``, ``by_cameras``, ``covariance``."""
    arrays: dict[str, Any] = {"schema_version": SCHEMA_VERSION, "covariance": rig.covariance}
    for part, noun in (("chain", rig.chain), ("state", rig.state)):
        not_arrays = _NOT_ARRAYS if part == "chain" else ()
        values = {field.name: getattr(noun, field.name) for field in fields(noun) if field.name not in not_arrays}
        arrays |= {f"{part}.{_STORED.get(name, name)}": value for name, value in values.items() if value is not None}
    for part, settings in (("noise", noise_document(rig.chain.noise)), ("free", asdict(rig.chain.free))):
        arrays |= {f"{part}.{name}": value for name, value in settings.items()}
    if rig.chain.motions is not None:
        arrays |= {f"motions.{name}": value for name, value in asdict(rig.chain.motions).items()}
    if rig.cameras is not None and rig.camera_jacobian is not None:
        arrays |= {
            "by_cameras": rig.camera_jacobian,
            "cameras.covariance": rig.cameras.covariance,
            "cameras.parameters": rig.cameras.parameters,
        }
    with replacing(Path(path)) as temporary, temporary.open("wb") as file:
        np.savez_compressed(file, **arrays)


def read_rig_uncertainty(path: Path, calibration: RigCalibration) -> RigUncertainty:
    """Read what `write_rig_uncertainty` wrote for ``calibration``. Raises StorageError when the file is damaged."""
    try:
        arrays = read_npz(Path(path))
        noise = noise_from(_part(arrays, "noise"))
        free = Free(**{name: bool(value) for name, value in _part(arrays, "free").items()})
        state = _part(arrays, "state")
        state["guide_scale"] = float(state["guide_scale"])
        parts = _part(arrays, "chain")
        jacobian = parts.pop("by_cameras", None)
        model = _part(arrays, "motions")
        chain = Chain(**parts, camera_jacobian=jacobian, noise=noise, free=free, motions=MotionModel(**model) if model else None)
        cameras = _part(arrays, "cameras")
        known = LabelledCovariance(tuple(map(str, cameras["parameters"])), cameras["covariance"]) if cameras else None
        return RigUncertainty(calibration, chain, ChainState(**state), arrays["covariance"], known, arrays.get("by_cameras"))
    except (OSError, ValueError, KeyError, TypeError, EOFError, BadZipFile, zlib.error) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Calibrate again, or delete this file to continue without it.") from error


def _part(arrays: dict[str, Any], part: str) -> dict[str, Any]:
    return {name.removeprefix(f"{part}."): value for name, value in arrays.items() if name.startswith(f"{part}.")}
