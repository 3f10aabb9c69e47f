"""`cameras.json`: the cameras of a head and, if calibrated, its projector; also the exchange format."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, LabelledCovariance, ProjectorCalibration, Provenance
from measureapp.data.certificate import BoardLengths
from measureapp.data.conditions import LensSetting
from measureapp.data.model import first_problem
from measureapp.errors import FrameMismatch, InputError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.atomic import write_json
from measureapp.project.text_document import reason_of

SCHEMA_VERSION = 2  # since 2 with optional `covariance`, and the command in `provenance`; version 1 is read as well
READABLE_VERSIONS = (1, 2)
WIDEST_BLUR_PX = 20.0  # more than any blur at which a board is still detected
DISTORTION_LENGTHS = (4, 5, 8, 12, 14)
FILE_FIELDS = {"schema_version", "reference", "cameras", "pair_rms_px", "provenance", "projector"}
FILE_FIELDS_SINCE_2 = {"covariance", "board_lengths", "board_marks_rms_mm"}
COVARIANCE_FIELDS = {"parameters", "matrix"}
LENS_FIELDS = ("width", "height", "matrix", "distortion")
CAMERA_FIELDS = {*LENS_FIELDS, "reference_from_camera", "standard_deviations", "rms_px", "serial", "focus_mm", "f_number", "blur_px"}
PROJECTOR_FIELDS = {*LENS_FIELDS, "reference_from_projector", "name", "standard_deviations", "rms_px", "provenance"}
PROVENANCE_FIELDS = {"created", "method", "inputs", "temperature_c", "valid_days", "arguments", "folder"}


def write_cameras(path: Path, calibration: CameraArrayCalibration) -> None:
    """Write ``calibration``, atomically."""
    write_json(Path(path), cameras_document(calibration))


def read_cameras(path: Path) -> CameraArrayCalibration:
    """Read the cameras of a head.

    Raises
    ------
    InputError
        The file is missing, is not JSON, lacks a field or has an unknown one, or a value is invalid; the message names
        file and field.
    """
    path = Path(path)
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(
            f"{path} cannot be read: {error.strerror or error}.",
            "Give the path of a cameras.json: `measureapp calibrate cameras --out` writes it, `measureapp process` that of a project.",
        ) from error
    except (ValueError, RecursionError) as error:
        raise InputError(
            f"{path} is not JSON: {reason_of(error)}.", "Give a cameras.json written by `measureapp calibrate cameras`."
        ) from error
    return cameras_from(document, str(path))


def cameras_document(calibration: CameraArrayCalibration) -> dict[str, Any]:
    """Return the JSON document of ``calibration``."""
    document = {
        "schema_version": SCHEMA_VERSION,
        "reference": calibration.reference,
        "cameras": {name: _camera_document(calibration.cameras[name]) for name in calibration.names},
        "pair_rms_px": {pair: float(value) for pair, value in calibration.pair_rms_px.items()},
        "provenance": _provenance_document(calibration.provenance),
    }
    if calibration.projector is not None:
        document["projector"] = _projector_document(calibration.projector)
    if calibration.covariance is not None:
        document["covariance"] = {
            "parameters": list(calibration.covariance.parameters),
            "matrix": calibration.covariance.covariance.tolist(),
        }
    if calibration.lengths is not None:
        document["board_lengths"] = calibration.lengths.model_dump(exclude_defaults=True)
    if calibration.marks_rms_mm:
        document["board_marks_rms_mm"] = float(calibration.marks_rms_mm)
    return document


def _projector_document(projector: ProjectorCalibration) -> dict[str, Any]:
    return {
        **_lens_document(projector.pinhole),
        "reference_from_projector": projector.reference_from_projector.matrix.tolist(),
        "name": projector.name,
        "standard_deviations": {name: float(value) for name, value in projector.standard_deviations.items()},
        "rms_px": float(projector.rms_px),
        "provenance": _provenance_document(projector.provenance),
    }


def _provenance_document(provenance: Provenance) -> dict[str, Any]:
    document: dict[str, Any] = {"created": provenance.created, "method": provenance.method, "inputs": dict(provenance.inputs)}
    optional = {"temperature_c": provenance.temperature_c, "valid_days": provenance.valid_days}
    document |= {name: float(value) for name, value in optional.items() if value is not None}
    return document | ({"arguments": list(provenance.arguments), "folder": provenance.folder} if provenance.arguments else {})


def _lens_document(pinhole: PinholeCamera) -> dict[str, Any]:
    return {
        "width": pinhole.width_px,
        "height": pinhole.height_px,
        "matrix": pinhole.matrix.tolist(),
        "distortion": pinhole.distortion.tolist(),
    }


def _camera_document(camera: CameraCalibration) -> dict[str, Any]:
    settings = {"focus_mm": camera.lens.focus_mm, "f_number": camera.lens.f_number}
    return {
        **_lens_document(camera.pinhole),
        "reference_from_camera": camera.reference_from_camera.matrix.tolist(),
        "standard_deviations": {name: float(value) for name, value in camera.standard_deviations.items()},
        "rms_px": float(camera.rms_px),
        "serial": camera.serial,
        **{name: float(value) for name, value in settings.items() if value is not None},
        **({"blur_px": float(camera.blur_px)} if camera.blur_px else {}),
    }


def cameras_from(document: Any, source: str = "cameras.json") -> CameraArrayCalibration:
    """Return the calibration of a JSON document; raises InputError naming ``source`` and the field."""
    _check_fields(document, FILE_FIELDS | FILE_FIELDS_SINCE_2, source, "the file")
    version = document.get("schema_version")
    if version not in READABLE_VERSIONS or isinstance(version, bool):
        raise InputError(f"{source}: schema_version is {version!r}, not 1 or {SCHEMA_VERSION}.", "Write the file again with this version.")
    _check_fields(document, FILE_FIELDS | (FILE_FIELDS_SINCE_2 if version >= 2 else set()), source, "a file of schema_version 1")
    cameras = _field(document, "cameras", source)
    if not isinstance(cameras, Mapping) or not cameras:
        raise InputError(f"{source}: cameras names no camera.", 'Give {"left": {…}, …}.')
    reference = _field(document, "reference", source)
    if reference not in cameras:
        raise InputError(
            f"{source}: the reference camera {reference!r} is not among the cameras.", "Name one of: " + ", ".join(cameras) + "."
        )
    provenance = document.get("provenance", {})
    made = {name: _camera(name, entry, reference, source) for name, entry in cameras.items()}
    pairs = _numbers(document.get("pair_rms_px", {}), source, "pair_rms_px")
    projector = _projector(document["projector"], source) if "projector" in document else None
    if projector is not None and projector.name in made:
        raise InputError(f"{source}: projector.name is {projector.name!r}, the name of a camera.", "Give the projector another name.")
    covariance = _covariance(document["covariance"], made, projector, source) if "covariance" in document else None
    lengths = _lengths(document["board_lengths"], source) if "board_lengths" in document else None
    marks_rms_mm = _numbers({"board_marks_rms_mm": document.get("board_marks_rms_mm", 0.0)}, source, "the file")["board_marks_rms_mm"]
    made_by = _provenance(provenance, source, "provenance")
    return CameraArrayCalibration(str(reference), made, pairs, made_by, projector, covariance, lengths, marks_rms_mm)


def _lengths(entry: Any, source: str) -> BoardLengths:
    try:
        return BoardLengths.model_validate(entry)
    except ValidationError as error:
        raise InputError(
            f"{source}: board_lengths.{first_problem(error, 'board_lengths')}.", "Remove the field, or calibrate again."
        ) from error


def _covariance(
    entry: Any, cameras: Mapping[str, CameraCalibration], projector: ProjectorCalibration | None, source: str
) -> LabelledCovariance:
    _check_fields(entry, COVARIANCE_FIELDS, source, "covariance")
    labels = _field(entry, "parameters", source, "covariance.")
    owners = {*cameras, *(() if projector is None else (projector.name,))}
    if not isinstance(labels, list) or not all(isinstance(label, str) and label.rpartition(".")[0] in owners for label in labels):
        raise InputError(
            f"{source}: covariance.parameters has a label without a known camera.", 'Give labels such as "left.fx" or "right.x_mm".'
        )
    if len(set(labels)) < len(labels):
        raise InputError(f"{source}: covariance.parameters names a parameter twice.", "Name each parameter once.")
    matrix = _array(_field(entry, "matrix", source, "covariance."), (len(labels),) * 2, source, "covariance.matrix")
    scale = np.sqrt(np.maximum(np.diag(matrix), 0))
    whitened = matrix / np.outer(np.where(scale > 0, scale, 1.0), np.where(scale > 0, scale, 1.0))
    if (
        np.any(np.diag(matrix) < 0)
        or not np.allclose(whitened, whitened.T, atol=1e-9)
        or (len(labels) and np.linalg.eigvalsh(whitened)[0] < -1e-6)
    ):
        raise InputError(
            f"{source}: covariance.matrix is not a covariance matrix: it must be symmetric and positive semidefinite.", "Calibrate again."
        )
    return LabelledCovariance(tuple(labels), matrix)


def _camera(name: str, entry: Any, reference: str, source: str) -> CameraCalibration:
    place = f"cameras.{name}"
    _check_fields(entry, CAMERA_FIELDS, source, place)
    pinhole = _pinhole(entry, source, place)
    pose = _array(_field(entry, "reference_from_camera", source, f"{place}."), (4, 4), source, f"{place}.reference_from_camera")
    if name == reference and not np.allclose(pose, np.eye(4), atol=1e-9):
        raise InputError(
            f"{source}: {place}.reference_from_camera is not the identity for the reference camera.",
            "Its last row is 0 0 0 1; lengths in mm.",
        )
    transform = _transform(pose, name, source, f"{place}.reference_from_camera")
    deviations = _numbers(entry.get("standard_deviations", {}), source, f"{place}.standard_deviations")
    rms_px = _numbers({"rms_px": entry.get("rms_px", 0.0)}, source, place)["rms_px"]
    blur_px = _numbers({"blur_px": entry.get("blur_px", 0.0)}, source, place)["blur_px"]
    if not 0 <= blur_px <= WIDEST_BLUR_PX:  # refuses NaN as well
        raise InputError(
            f"{source}: {place}.blur_px is {blur_px:g}, not 0 to {WIDEST_BLUR_PX:g} px.", "Remove the field, or calibrate again."
        )
    settings = {setting: entry[setting] for setting in ("focus_mm", "f_number") if entry.get(setting) is not None}
    lens = LensSetting(**_numbers(settings, source, place))
    return CameraCalibration(name, pinhole, transform, deviations, rms_px, str(entry.get("serial", "")), lens, blur_px)


def _projector(entry: Any, source: str) -> ProjectorCalibration:
    _check_fields(entry, PROJECTOR_FIELDS, source, "projector")
    pinhole = _pinhole(entry, source, "projector")
    place = "projector.reference_from_projector"
    pose = _array(_field(entry, "reference_from_projector", source, "projector."), (4, 4), source, place)
    provenance = entry.get("provenance", {})
    name = str(entry.get("name", "projector"))
    return ProjectorCalibration(
        pinhole,
        _transform(pose, name, source, place),
        name,
        _numbers(entry.get("standard_deviations", {}), source, "projector.standard_deviations"),
        _provenance(provenance, source, "projector.provenance"),
        _numbers({"rms_px": entry.get("rms_px", 0.0)}, source, "projector")["rms_px"],
    )


def _provenance(entry: Any, source: str, place: str) -> Provenance:
    _check_fields(entry, PROVENANCE_FIELDS, source, place)
    optional = {name: entry[name] for name in ("temperature_c", "valid_days") if entry.get(name) is not None}
    arguments = entry.get("arguments", [])
    if not isinstance(arguments, list) or not all(isinstance(one, str) for one in arguments):
        raise InputError(f"{source}: {place}.arguments is not a list of strings.", "Give the arguments of the command as strings.")
    return Provenance(**{**entry, **_numbers(optional, source, place), "arguments": tuple(arguments)})


def _pinhole(entry: Mapping[str, Any], source: str, place: str) -> PinholeCamera:
    for needed in LENS_FIELDS:
        _field(entry, needed, source, f"{place}.")
    matrix = _array(entry["matrix"], (3, 3), source, f"{place}.matrix")
    if matrix[0, 0] <= 0 or matrix[1, 1] <= 0 or not np.allclose(matrix[2], [0, 0, 1]):
        raise InputError(f"{source}: {place}.matrix is not a camera matrix.", "Give [[fx, 0, cx], [0, fy, cy], [0, 0, 1]] in pixels.")
    distortion = _array(entry["distortion"], None, source, f"{place}.distortion").ravel()
    if len(distortion) not in DISTORTION_LENGTHS:
        raise InputError(
            f"{source}: {place}.distortion has {len(distortion)} coefficients.", "Give 4, 5, 8, 12 or 14 coefficients in OpenCV's order."
        )
    size = [entry[side] for side in ("width", "height")]
    if any(isinstance(value, bool) or not isinstance(value, int) or value <= 0 for value in size):
        raise InputError(f"{source}: {place}.width and height must be whole numbers above 0.", "Give the image's size in pixels.")
    return PinholeCamera(size[0], size[1], matrix, distortion)


def _transform(pose: FloatArray, name: str, source: str, place: str) -> RigidTransform:
    if not np.allclose(pose[3], [0, 0, 0, 1]):
        raise InputError(f"{source}: {place} is not a rigid 4×4 transform.", "Its last row is 0 0 0 1; lengths in mm.")
    try:
        return RigidTransform(pose, "camera", name)
    except FrameMismatch as error:
        raise InputError(f"{source}: {place} is not a rigid transform.", "Its 3×3 part must be a rotation; lengths in mm.") from error


def _check_fields(entry: Any, fields: set[str], source: str, place: str) -> None:
    if not isinstance(entry, Mapping):
        raise InputError(f"{source}: {place} is not a JSON object.", "See the format of cameras.json in the help.")
    foreign = sorted(set(entry) - fields)
    if foreign:
        raise InputError(f"{source}: {place} has the unknown field {foreign[0]!r}.", "Known fields: " + ", ".join(sorted(fields)) + ".")


def _field(entry: Mapping[str, Any], name: str, source: str, prefix: str = "") -> Any:
    if name not in entry:
        raise InputError(f"{source}: {prefix}{name} is missing.", "See the format of cameras.json in the help.")
    return entry[name]


def _array(value: Any, shape: tuple[int, ...] | None, source: str, place: str) -> Any:
    try:
        array = np.asarray(value, np.float64)
    except (TypeError, ValueError):
        array = np.full(1, np.nan)
    if (shape is not None and array.shape != shape) or not np.all(np.isfinite(array)):
        wanted = " × ".join(map(str, shape)) + " numbers" if shape else "a list of numbers"
        raise InputError(f"{source}: {place} is not {wanted}.", "Correct the value.")
    return array


def _numbers(entry: Any, source: str, place: str) -> dict[str, float]:
    if not isinstance(entry, Mapping):
        raise InputError(f"{source}: {place} is not a JSON object.", "Give names with numbers.")
    for name, value in entry.items():
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise InputError(f"{source}: {place}.{name} is not a number.", "Correct the value.")
    return {str(name): float(value) for name, value in entry.items()}
