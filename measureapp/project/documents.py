"""Data classes as JSON documents, and back."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, fields
from typing import Any

import numpy as np

from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.data.axis_motions import AxisMotions
from measureapp.data.calibration import CameraArrayCalibration, HandEye, LinearGuide, Provenance, RigCalibration, RobotStation, RotationAxis
from measureapp.data.camera_shift import ShiftEvidence
from measureapp.data.cloud import LoopClosure, ViewPlacement
from measureapp.data.conditions import Conditions, LensSetting
from measureapp.data.consistency import Consistency, ConsistencyCheck
from measureapp.data.control_frame import ControlFrame, frame_document, frame_from
from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.feature import Feature
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import Alignment, Inspection
from measureapp.data.setups import JoinedSetUp
from measureapp.data.validity import CheckRecord, Drift, Validity
from measureapp.geometry.transform import RigidTransform

STORED_NAMES = {  # attribute -> field of the files where the two differ
    "unconstrained_motions": "held_by_axes",
    "traceability": "origin",
    "status": "standing",
    "undetectable": "unseen",
    "undetectable_deg": "unseen_deg",
    "robot_correlation_mm": "robot_alike_mm",
    "robot_correlation_turn": "robot_alike_turn",
}
SHIFT_ARRAYS = ("information", "gradient", "image_px2", "depth_mm2")
ATTRIBUTES = {stored: name for name, stored in STORED_NAMES.items()}


def transform_document(transform: RigidTransform) -> dict[str, Any]:
    """Return a transform as JSON."""
    return {"to": transform.to_frame, "from": transform.from_frame, "matrix": transform.matrix.tolist()}


def transform_from(document: Mapping[str, Any]) -> RigidTransform:
    """Return the transform of a document."""
    return RigidTransform(np.array(document["matrix"], float), document["to"], document["from"])


def readback_document(readback: AxisReadback) -> dict[str, Any]:
    """Return a read-back as JSON."""
    return {
        "base_from_flange": transform_document(readback.base_from_flange),
        "guide_mm": readback.guide_mm,
        "table_rad": readback.table_rad,
    }


def readback_from(document: Mapping[str, Any]) -> AxisReadback:
    """Return the read-back of a document."""
    return AxisReadback(transform_from(document["base_from_flange"]), float(document["guide_mm"]), float(document["table_rad"]))


def conditions_document(conditions: Conditions | None) -> dict[str, Any] | None:
    """Return the conditions of images as JSON; None if they were not recorded."""
    return None if conditions is None else asdict(conditions)


def conditions_from(document: Mapping[str, Any] | None) -> Conditions | None:
    """Return the conditions of a document."""
    if document is None:
        return None
    lenses = {name: LensSetting(**setting) for name, setting in document["lenses"].items()}
    return Conditions(**{**document, "lenses": lenses})


def calibration_id(calibration: RigCalibration) -> str:
    """Return the id of a calibration, twelve characters: hash of its provenance, or of all its numbers if it has no inputs.

    A calibration solved again from the same images keeps its id.
    """
    provenance = calibration.provenance
    named = asdict(provenance) if provenance.inputs else rig_calibration_document(calibration)
    return digest(named | {"cameras": {name: camera.serial for name, camera in calibration.cameras.cameras.items()}})[:12]


def digest(document: Mapping[str, Any]) -> str:
    """Return the SHA-256 of a JSON document, independent of the order of its fields."""
    return hashlib.sha256(json.dumps(document, sort_keys=True).encode()).hexdigest()


def rig_calibration_document(calibration: RigCalibration) -> dict[str, Any]:
    """Return a rig calibration without its cameras, which have their own file, as JSON; version 2 has the error motions of the axes."""
    return {
        "schema_version": 1 if calibration.motions is None else 2,
        "hand_eye": link_document(calibration.hand_eye),
        "guide": link_document(calibration.guide),
        "axis": link_document(calibration.axis),
        "provenance": asdict(calibration.provenance),
        "stations": [_plain(station) for station in calibration.stations],
        **({} if calibration.view_gaps_mm is None else {"view_gaps_mm": calibration.view_gaps_mm}),
        **({} if calibration.motions is None else {"motions": link_document(calibration.motions)}),
    }


def rig_calibration_from(document: Mapping[str, Any], cameras: CameraArrayCalibration) -> RigCalibration:
    """Return the calibration of a document and its cameras."""
    return RigCalibration(
        cameras=cameras,
        hand_eye=hand_eye_from(document["hand_eye"]),
        guide=guide_from(document["guide"]),
        axis=axis_from(document["axis"]),
        provenance=Provenance(**document["provenance"] | {"arguments": tuple(document["provenance"].get("arguments", ()))}),
        stations=tuple(RobotStation(transform_from(station["read"]), transform_from(station["true"])) for station in document["stations"]),
        view_gaps_mm=document.get("view_gaps_mm"),
        motions=motions_from(document.get("motions")),
    )


def motions_from(document: Mapping[str, Any] | None) -> AxisMotions | None:
    """Return the error motions of a document; None where it has none."""
    return None if document is None else AxisMotions(**document)


def link_document(link: Any) -> dict[str, Any]:
    """Return a link of the rig's chain, a dataclass such as `HandEye`, as JSON."""
    return _plain(link)


def noise_document(noise: AxisNoise) -> dict[str, float]:
    """Return the noise of the axes as JSON."""
    return {STORED_NAMES.get(name, name): value for name, value in asdict(noise).items()}


def noise_from(document: Mapping[str, Any]) -> AxisNoise:
    """Return the noise of the axes of a document."""
    return AxisNoise(**{ATTRIBUTES.get(name, name): float(value) for name, value in document.items()})


def hand_eye_from(document: Mapping[str, Any]) -> HandEye:
    """Return the hand-eye transform of a document."""
    return HandEye(**{**document, "flange_from_camera": transform_from(document["flange_from_camera"])})


def guide_from(document: Mapping[str, Any]) -> LinearGuide:
    """Return the linear guide of a document."""
    return LinearGuide(**{**document, "direction": np.array(document["direction"], float)})


def axis_from(document: Mapping[str, Any]) -> RotationAxis:
    """Return the rotation axis of a document."""
    arrays = {name: np.array(document[name], float) for name in ("direction", "point_mm")}
    return RotationAxis(**{**document, **arrays})


def placement_document(placement: ViewPlacement) -> dict[str, Any]:
    """Return the placement of a view as JSON."""
    return _plain(placement)


def placement_from(document: Mapping[str, Any]) -> ViewPlacement:
    """Return the placement of a document."""
    transforms = {name: transform_from(document[name]) for name in ("part_from_camera", "kinematic")}
    return ViewPlacement(**_attributes({**document, **transforms, "held_by_axes": tuple(document.get("held_by_axes", ()))}))


def setup_document(setup: JoinedSetUp) -> dict[str, Any]:
    """Return a joined set-up as JSON."""
    return _plain(setup)


def setup_from(document: Mapping[str, Any]) -> JoinedSetUp:
    """Return the joined set-up of a document."""
    return JoinedSetUp(**{**document, "part_from_setup": transform_from(document["part_from_setup"])})


def loop_closure_document(loop_closure: LoopClosure | None) -> dict[str, Any] | None:
    """Return the worst loop closure as JSON."""
    return None if loop_closure is None else _plain(loop_closure)


def loop_closure_from(document: Mapping[str, Any] | None) -> LoopClosure | None:
    """Return the loop closure of a document."""
    return None if document is None else LoopClosure(**{**document, "viewpoints": tuple(document["viewpoints"])})


def inspection_document(inspection: Inspection) -> dict[str, Any]:
    """Return features and dimensions as JSON."""
    return {
        "program": inspection.program,
        "alignment": _plain(inspection.alignment),
        "features": [_plain(feature) for feature in inspection.features],
        "dimensions": [_plain(dimension) for dimension in inspection.dimensions],
        "further": {name: _plain(alignment) for name, alignment in inspection.further.items()},
        "lengths": list(inspection.lengths),
    }


def inspection_from(document: Mapping[str, Any]) -> Inspection:
    """Return the inspection of a document."""
    return Inspection(
        program=document["program"],
        alignment=_alignment_from(document["alignment"]),
        features=tuple(_feature_from(feature) for feature in document["features"]),
        dimensions=tuple(_dimension_from(dimension) for dimension in document["dimensions"]),
        further={name: _alignment_from(stored) for name, stored in document.get("further", {}).items()},
        lengths=tuple(document.get("lengths", ())),
    )


def _alignment_from(document: Mapping[str, Any]) -> Alignment:
    alignment = dict(document)
    alignment["nominal_from_part"] = transform_from(alignment["nominal_from_part"])
    alignment["undetermined"] = tuple(alignment["undetermined"])
    for name in ("notes", "weakest_direction"):
        alignment[name] = tuple(alignment.get(name, ()))
    return Alignment(**alignment)


def validity_document(validity: Validity) -> dict[str, Any]:
    """Return the validity of a calibration as JSON."""
    return _plain(validity) | {"drift": None if validity.drift is None else _plain(validity.drift)}


def validity_from(document: Mapping[str, Any]) -> Validity:
    """Return the validity of a document; without warnings and drift check for an empty one."""
    stored = document.get("drift")
    drift = None if stored is None else Drift(**_attributes({**stored, "cameras": tuple(stored["cameras"])}))
    return Validity(tuple(document.get("warnings", ())), drift, document.get("temperature_c"), document.get("axes", ""))


def consistency_document(consistency: Consistency) -> dict[str, Any]:
    """Return the checks of the error model as JSON."""
    return {"checks": [_plain(check) for check in consistency.checks], "unexplained_mm": consistency.unexplained_mm}


def consistency_from(document: Mapping[str, Any]) -> Consistency:
    """Return the checks of a document; none for an empty one."""
    return Consistency(tuple(ConsistencyCheck(**_attributes(check)) for check in document.get("checks", ())))


def check_document(check: CheckRecord) -> dict[str, Any]:
    """Return a line of a calibration's history as JSON."""
    return _plain(check)


def check_from(document: Mapping[str, Any]) -> CheckRecord:
    """Return the line of a document."""
    return CheckRecord(**_attributes({**document, "cameras": tuple(document["cameras"])}))


def _feature_from(document: Mapping[str, Any]) -> Feature:
    names = ("point_mm", "direction", "normal", "covariance", "boundary_mm")
    arrays = {name: np.array(document[name]) for name in names if document.get(name) is not None}
    return Feature(**{**document, **arrays})


def _dimension_from(document: Mapping[str, Any]) -> Dimension:
    names = {key: tuple(document.get(key, ())) for key in ("features", "datums", "datum_letters")}
    known = {"verdict": Verdict(document["verdict"]), "frame": frame_from(document.get("frame"))}
    return Dimension(**_attributes({**document, **names, **known}))


def _plain(noun: Any) -> dict[str, Any]:
    """Return the fields of a frozen dataclass, under their stored names, with transforms and arrays as JSON."""
    return {STORED_NAMES.get(entry.name, entry.name): _plain_value(getattr(noun, entry.name)) for entry in fields(noun)}


def _attributes(document: Mapping[str, Any]) -> dict[str, Any]:
    """Return a document under the names of the attributes; the inverse of the naming of `_plain`."""
    return {ATTRIBUTES.get(name, name): value for name, value in document.items()}


def _plain_value(value: Any) -> Any:
    if isinstance(value, RigidTransform):
        return transform_document(value)
    if isinstance(value, ControlFrame):
        return frame_document(value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Mapping):
        return {name: _plain_value(item) for name, item in value.items()}
    if isinstance(value, tuple):
        return [_plain_value(item) for item in value]
    return value


def shift_document(shift: ShiftEvidence) -> dict[str, Any]:
    """Return the evidence of camera drift in one view as JSON."""
    return {
        "cameras": list(shift.cameras),
        "samples": int(shift.samples),
        "misfit": float(shift.misfit),
        "freedom": int(shift.freedom),
        **{name: getattr(shift, name).tolist() for name in SHIFT_ARRAYS},
    }


def shift_from(document: Mapping[str, Any]) -> ShiftEvidence:
    """Return the evidence of a document; raises KeyError, TypeError or ValueError where it is none."""
    arrays = {name: np.array(document[name], np.float64) for name in SHIFT_ARRAYS}
    return ShiftEvidence(
        cameras=tuple(document["cameras"]),
        samples=int(document["samples"]),
        misfit=float(document["misfit"]),
        freedom=int(document["freedom"]),
        **arrays,
    )
