"""What the views of a stitched cloud err by, as elements of its PLY file that other programs pass over."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.view_errors import POSE, POWERS, CloudDistortion, FormErrors, SystematicErrors, ViewErrors
from measureapp.errors import FrameMismatch, InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.project.geometry.ply import Ply

VIEW, STITCHING, CALIBRATION, BEND, BOX = "view_pose", "stitching_error", "calibration_error", "cloud_bend", "cloud_bend_box"
FORM, NODE, FOLLOWING = "cloud_form", "cloud_form_node", "cloud_form_motion"
COMMON, COMMON_FOLLOWING = "common_error", "common_error_motion"
SETUPS, BENT_VIEW, UNEXPLAINED = "setup_error", "cloud_bend_view", "unexplained_error"
MATRIX = tuple(f"m{row}{column}" for row in range(4) for column in range(4))
CENTRE = ("x", "y", "z")


def error_elements(errors: ViewErrors | None) -> dict[str, dict[str, Any]]:
    """Return the elements to be written: the views with their poses and centres, and the arrays of `ViewErrors` one number a row."""
    if errors is None:
        return {}
    table = np.hstack([np.array([pose.matrix.ravel() for pose in errors.poses]), errors.centres_mm])
    elements = {VIEW: dict(zip((*MATRIX, *CENTRE), table.T, strict=True))}
    arrays = {STITCHING: errors.stitching_motions, CALIBRATION: errors.calibration_motions}
    if errors.distortion is not None:
        arrays[BEND] = errors.distortion.coefficients_mm
        if errors.distortion.views is not None:
            arrays[BENT_VIEW] = errors.distortion.views.astype(np.uint8)
        elements[BOX] = dict(zip(CENTRE, np.stack([errors.distortion.middle_mm, errors.distortion.reach_mm]).T, strict=True))
    if errors.form is not None:
        arrays[FOLLOWING] = errors.form.motions
        elements[FORM] = {"size": errors.form.sizes_mm, "reach": errors.form.reaches_mm}
        elements[NODE] = dict(zip((*CENTRE, "view"), np.column_stack([errors.form.nodes_mm, errors.form.view]).T, strict=True))
    if errors.systematic is not None:
        arrays[COMMON_FOLLOWING] = errors.systematic.motions
        sizes = np.full(errors.systematic.count, errors.systematic.size_mm)
        elements[COMMON] = dict(zip((*CENTRE, "size"), np.column_stack([errors.systematic.nodes, sizes]).T, strict=True))
    if errors.setup_motions is not None:
        arrays[SETUPS] = errors.setup_motions
    if errors.unexplained_mm > 0:
        arrays[UNEXPLAINED] = np.array([errors.unexplained_mm])
    return elements | {name: {"value": array.ravel()} for name, array in arrays.items() if array.size}


def errors_from(path: Path, ply: Ply, frame: str) -> ViewErrors | None:
    """Return what `error_elements` gave; None where the file does not have it. Raises InputError for numbers that do not go together."""
    if VIEW not in ply.elements:
        return None
    try:
        table = _table(ply.elements[VIEW], (*MATRIX, *CENTRE))
        rows = POSE * len(table)
        poses = tuple(RigidTransform(row[:16].reshape(4, 4), frame, "camera") for row in table)
        stitching_motions, calibration_motions = (_numbers(ply, name).reshape(rows, -1) for name in (STITCHING, CALIBRATION))
        distortion = None
        if BEND in ply.elements:
            middle, reach = _table(ply.elements[BOX], CENTRE)
            count = calibration_motions.shape[1]
            views = _numbers(ply, BENT_VIEW).reshape(len(table), count) > 0 if BENT_VIEW in ply.elements else None
            distortion = CloudDistortion(middle, reach, _numbers(ply, BEND).reshape(len(POWERS), 3, count), views)
        form = None
        if FORM in ply.elements:
            sizes, reaches = _table(ply.elements[FORM], ("size", "reach")).T
            nodes = _table(ply.elements[NODE], (*CENTRE, "view"))
            form = FormErrors(nodes[:, :3], nodes[:, 3].astype(int), sizes, reaches, _numbers(ply, FOLLOWING).reshape(rows, len(nodes)))
        common = None
        if COMMON in ply.elements:
            nodes = _table(ply.elements[COMMON], (*CENTRE, "size"))
            common = SystematicErrors(nodes[:, :3], float(nodes[0, 3]), _numbers(ply, COMMON_FOLLOWING).reshape(rows, len(nodes)))
        setups = _numbers(ply, SETUPS).reshape(rows, -1) if SETUPS in ply.elements else None
        unexplained = float(_numbers(ply, UNEXPLAINED).sum()) if UNEXPLAINED in ply.elements else 0.0
        made = ViewErrors(poses, table[:, 16:], stitching_motions, calibration_motions, distortion, form, common)
        made = replace(made, unexplained_mm=unexplained, setup_motions=setups)
    except (LookupError, ValueError, FrameMismatch) as error:
        raise InputError(
            f"{path} is damaged: what it says of its views' errors is not whole.", "Stitch again, or copy the file again."
        ) from error
    numbers = [made.stitching_motions, made.calibration_motions, made.centres_mm, np.array(made.unexplained_mm)]
    numbers += [] if made.form is None else [made.form.nodes_mm, made.form.sizes_mm, made.form.reaches_mm, made.form.motions]
    numbers += [] if made.systematic is None else [made.systematic.nodes, np.array(made.systematic.size_mm), made.systematic.motions]
    numbers += [] if made.setup_motions is None else [made.setup_motions]
    if not all(np.isfinite(array).all() for array in numbers):
        raise InputError(f"{path} says of its views what is not a number.", "Stitch again, or copy the file again.")
    return made


def _table(columns: Mapping[str, Any], names: tuple[str, ...]) -> FloatArray:
    return np.column_stack([np.asarray(columns[name], np.float64) for name in names])


def _numbers(ply: Ply, name: str) -> FloatArray:
    found = ply.column(name, "value")
    return np.empty(0) if found is None else np.asarray(found, np.float64)
