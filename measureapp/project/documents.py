"""Nouns as JSON documents, and back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, fields
from typing import Any

import numpy as np

from measureapp.data.calibration import CameraArrayCalibration, HandEye, LinearGuide, Provenance, RigCalibration, RobotStation, RotationAxis
from measureapp.data.cloud import ViewPlacement
from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.feature import Feature
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import Alignment, Inspection
from measureapp.geometry.transform import RigidTransform


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


def rig_calibration_document(calibration: RigCalibration) -> dict[str, Any]:
    """Return everything but the cameras, which have a file of their own, as JSON."""
    return {
        "schema_version": 1,
        "hand_eye": _plain(calibration.hand_eye),
        "guide": _plain(calibration.guide),
        "axis": _plain(calibration.axis),
        "provenance": asdict(calibration.provenance),
        "stations": [_plain(station) for station in calibration.stations],
    }


def rig_calibration_from(document: Mapping[str, Any], cameras: CameraArrayCalibration) -> RigCalibration:
    """Return the calibration of a document and its cameras."""
    hand_eye = dict(document["hand_eye"])
    hand_eye["flange_from_camera"] = transform_from(hand_eye["flange_from_camera"])
    guide = {**document["guide"], "direction": np.array(document["guide"]["direction"])}
    axis = {**document["axis"], "direction": np.array(document["axis"]["direction"]), "point_mm": np.array(document["axis"]["point_mm"])}
    return RigCalibration(
        cameras=cameras,
        hand_eye=HandEye(**hand_eye),
        guide=LinearGuide(**guide),
        axis=RotationAxis(**axis),
        provenance=Provenance(**document["provenance"] | {"arguments": tuple(document["provenance"].get("arguments", ()))}),
        stations=tuple(RobotStation(transform_from(station["read"]), transform_from(station["true"])) for station in document["stations"]),
    )


def placement_document(placement: ViewPlacement) -> dict[str, Any]:
    """Return where a view came to lie as JSON."""
    return _plain(placement)


def placement_from(document: Mapping[str, Any]) -> ViewPlacement:
    """Return the placement of a document."""
    transforms = {name: transform_from(document[name]) for name in ("part_from_camera", "kinematic")}
    return ViewPlacement(**{**document, **transforms, "held_by_axes": tuple(document.get("held_by_axes", ()))})


def inspection_document(inspection: Inspection) -> dict[str, Any]:
    """Return features and dimensions as JSON."""
    return {
        "program": inspection.program,
        "alignment": _plain(inspection.alignment),
        "features": [_plain(feature) for feature in inspection.features],
        "dimensions": [_plain(dimension) for dimension in inspection.dimensions],
    }


def inspection_from(document: Mapping[str, Any]) -> Inspection:
    """Return the inspection of a document."""
    alignment = dict(document["alignment"])
    alignment["nominal_from_part"] = transform_from(alignment["nominal_from_part"])
    alignment["undetermined"] = tuple(alignment["undetermined"])
    return Inspection(
        program=document["program"],
        alignment=Alignment(**alignment),
        features=tuple(_feature_from(feature) for feature in document["features"]),
        dimensions=tuple(_dimension_from(dimension) for dimension in document["dimensions"]),
    )


def _feature_from(document: Mapping[str, Any]) -> Feature:
    arrays = {name: np.array(document[name]) for name in ("point_mm", "direction", "boundary_mm") if document[name] is not None}
    return Feature(**{**document, **arrays})


def _dimension_from(document: Mapping[str, Any]) -> Dimension:
    return Dimension(**{**document, "verdict": Verdict(document["verdict"]), "features": tuple(document["features"])})


def _plain(noun: Any) -> dict[str, Any]:
    """The fields of a frozen dataclass with transforms and arrays as JSON."""
    return {entry.name: _plain_value(getattr(noun, entry.name)) for entry in fields(noun)}


def _plain_value(value: Any) -> Any:
    if isinstance(value, RigidTransform):
        return transform_document(value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Mapping):
        return {name: _plain_value(item) for name, item in value.items()}
    if isinstance(value, tuple):
        return [_plain_value(item) for item in value]
    return value
