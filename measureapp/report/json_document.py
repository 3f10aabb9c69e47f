"""Dimensions and measurements as JSON documents of the command line and the report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from math import degrees, isfinite
from typing import Any

from measureapp.data.axis_motions import AxisMotions
from measureapp.data.calibration import RigCalibration
from measureapp.data.control_frame import frame_document
from measureapp.data.dimension import Dimension
from measureapp.data.feature import Feature
from measureapp.data.measurement import Alignment, Measurement
from measureapp.inspection.surface.statistics import DeviationStatistics, Extreme
from measureapp.project.documents import consistency_document, setup_document, validity_document
from measureapp.report.model import ReportModel, ViewLine
from measureapp.report.valid_pixels import valid_pixels


def dimension_document(dimension: Dimension) -> dict[str, Any]:
    """Return a dimension as JSON; missing numbers are None."""
    return {
        "name": dimension.name,
        "kind": dimension.kind,
        "datums": list(dimension.datums),
        "datum_letters": list(dimension.datum_letters),
        "control_frame": frame_document(dimension.frame),
        "nominal": dimension.nominal,
        "measured": dimension.measured,
        "error": dimension.deviation,
        "relative_error": dimension.relative_deviation,
        "uncertainty": dimension.uncertainty,
        "uncertainty_budget": dict(dimension.budget),
        "tolerance": [dimension.lower_tolerance, dimension.upper_tolerance],
        "tolerance_source": dimension.tolerance_source,
        "unit": dimension.unit,
        "verdict": dimension.verdict.value,
        "reason": dimension.reason,
        "warning": dimension.warning,
        "alignment": dimension.alignment,
        "group": dimension.group,
        "origin": dimension.traceability,
    }


def feature_document(feature: Feature) -> dict[str, Any]:
    """Return a measured feature as JSON, in the nominal's frame; parameters that its shape lacks are None."""
    angle = feature.half_angle_rad
    return {
        "name": feature.name,
        "shape": feature.shape,
        "point_mm": feature.point_mm.tolist(),
        "direction": None if feature.direction is None else feature.direction.tolist(),
        "radius_mm": feature.radius_mm,
        "length_mm": feature.length_mm,
        "half_angle_deg": None if angle is None else degrees(angle),
        "points": feature.points,
        "left_out": feature.left_out,
        "rms_mm": feature.rms_mm,
        "form_error_mm": feature.form_error_mm,
        "how": feature.how,
    }


def alignment_document(alignment: Alignment) -> dict[str, Any]:
    """Return an alignment as JSON."""
    return {
        "name": alignment.name,
        "matrix": alignment.nominal_from_part.matrix.tolist(),
        "rms_mm": alignment.rms_mm,
        "overlap": alignment.overlap,
        "undetermined": list(alignment.undetermined),
        "residuals_mm": dict(alignment.residuals_mm),
        "notes": list(alignment.notes),
        "method": alignment.method,
        "for_comparison_only": alignment.for_comparison_only,
        "fixed": alignment.fixed,
        "weakest_mm": alignment.weakest_mm,
        "weakest_direction": list(alignment.weakest_direction),
    }


def statistics_document(found: DeviationStatistics) -> dict[str, Any]:
    """Return the statistics of a deviation as JSON: the numbers of legend, window and report."""
    return {
        "points": found.points,
        "lost": found.lost,
        "search_mm": found.search_mm,
        "mean_mm": found.mean_mm,
        "rms_mm": found.rms_mm,
        "p95_mm": found.p95_mm,
        "tolerance_mm": None if found.tolerance_mm is None else list(found.tolerance_mm),
        "range_mm": list(found.range_mm),
        "below": found.below,
        "inside": found.inside,
        "above": found.above,
        "no_data": {"not_seen": found.no_data.not_seen, "filled": found.no_data.filled, "too_far": found.no_data.too_far},
        "minimum": _extreme_document(found.minimum),
        "maximum": _extreme_document(found.maximum),
        "all_points_mm": None if found.all_points_mm is None else dict(zip(("min", "max"), found.all_points_mm, strict=True)),
    }


def _extreme_document(extreme: Extreme | None) -> dict[str, Any] | None:
    if extreme is None:
        return None
    return {"value_mm": extreme.value_mm, "point_mm": extreme.point_mm.tolist(), "neighbours": extreme.neighbours}


def view_document(view: ViewLine) -> dict[str, Any]:
    """Return a line of the table of views as JSON."""
    return {
        "name": view.viewpoint_id,
        "points": view.points,
        "noise_mm": view.noise_mm,
        "completeness": view.completeness,
        "outlier_ratio": view.outlier_ratio,
        "distortion_mm": view.distortion_mm,
        "correction_mm": view.correction_mm,
        "correction_deg": view.correction_deg,
        "residual_mm": view.residual_mm,
        "overlap": view.overlap,
        "bound_mm": view.bound_mm,
        "sigma_mm": view.sigma_mm,
        "held_by_axes": list(view.unconstrained_motions),
        "used": view.used,
        "verdict": view.verdict,
    }


def motions_document(motions: AxisMotions) -> dict[str, float]:
    """Return the error motions of table and guide as JSON: half ranges, and by how much they move the board of the calibration."""
    found = motions.amplitudes
    return {
        "radial_mm": found["radial"],
        "axial_mm": found["axial"],
        "tilt_rad": found["tilt"],
        "guide_straightness_mm": found["straightness"],
        "guide_angles_rad": found["angles"],
        "board_moved_mm": motions.explained_mm,
    }


def calibration_document(calibration: RigCalibration) -> dict[str, Any]:
    """Return the calibration of a measurement as JSON, with its standard deviations."""
    axis, hand_eye, guide = calibration.axis, calibration.hand_eye, calibration.guide
    return {
        "created": calibration.provenance.created,
        "method": calibration.provenance.method,
        "temperature_c": calibration.provenance.temperature_c,
        "valid_days": calibration.provenance.valid_days,
        "cameras": {
            name: {
                "rms_px": camera.rms_px,
                "blur_px": camera.blur_px or None,
                "serial": camera.serial,
                "standard_deviations": dict(camera.standard_deviations),
            }
            for name, camera in calibration.cameras.cameras.items()
        },
        "pair_rms_px": dict(calibration.cameras.pair_rms_px),
        "board_marks_rms_mm": calibration.cameras.marks_rms_mm or None,
        "axis": {
            "point_mm": axis.point_mm.tolist(),
            "direction": axis.direction.tolist(),
            "point_sigma_mm": axis.point_sigma_mm,
            "direction_sigma_rad": axis.direction_sigma_rad,
            "residual_mm": axis.residual_mm,
        },
        "hand_eye": {
            "flange_from_camera": hand_eye.flange_from_camera.matrix.tolist(),
            "rotation_sigma_rad": hand_eye.rotation_sigma_rad,
            "translation_sigma_mm": hand_eye.translation_sigma_mm,
            "residual_mm": hand_eye.residual_mm,
            "method": hand_eye.method,
        },
        "guide": {
            "direction": guide.direction.tolist(),
            "scale": guide.scale,
            "direction_sigma_rad": guide.direction_sigma_rad,
            "scale_sigma": guide.scale_sigma,
            "straightness_mm": guide.straightness_mm,
        },
        "error_motions": None if calibration.motions is None else motions_document(calibration.motions),
    }


def measurement_document(measurement: Measurement) -> dict[str, Any]:
    """Return a measurement as JSON, without points."""
    from measureapp.report.compose import view_lines

    inspection = measurement.inspection
    return {
        "schema_version": 1,
        "project": measurement.project,
        "part": measurement.part,
        "rig": measurement.rig,
        "measured_at": measurement.measured_at,
        "points": len(measurement.stitched),
        "triangles": None if measurement.mesh is None else len(measurement.mesh.triangles),
        "views": [view_document(view) for view in view_lines(measurement)],
        "program": None if inspection is None else inspection.program,
        "alignment": None if inspection is None else alignment_document(inspection.alignment),
        "dimensions": [] if inspection is None else [dimension_document(dimension) for dimension in inspection.dimensions],
        **({"setups": [setup_document(setup) for setup in measurement.setups]} if measurement.setups else {}),
        "calibration": calibration_document(measurement.calibration),
        "validity": validity_document(measurement.validity),
        "consistency": consistency_document(measurement.consistency),
        "settings": dict(measurement.settings),
        "timings_s": dict(measurement.timings_s),
    }


def report_document(model: ReportModel) -> dict[str, Any]:
    """Return a composed report as JSON: the measurement, the verdict and its rule, and the deviation from the nominal."""
    deviation = model.deviation
    document = {
        **measurement_document(model.measurement),
        "software": model.software,
        "language": model.details.language,  # of the documents beside it
        "verdict": None if model.verdict is None else model.verdict.value,
        "summary": model.summary,
        "verdict_rule": model.verdict_rule,
        "valid_pixels": [asdict(one) for one in valid_pixels(model.measurement, model.details.exposures_us)],
        "deviation_mm": None if deviation is None else _figures(deviation.statistics),
        "unmeasured_share": None if deviation is None else deviation.statistics.no_data.total,
        "deviation_statistics": None if deviation is None else statistics_document(deviation.statistics),
    }
    return _without_nan(document)


def _figures(found: DeviationStatistics) -> dict[str, float | None]:
    extremes = {"min": found.minimum, "max": found.maximum}
    values = {name: None if extreme is None else extreme.value_mm for name, extreme in extremes.items()}
    return {"mean": found.mean_mm, "rms": found.rms_mm, "p95": found.p95_mm, **values}


def _without_nan(value: Any) -> Any:
    """Replace non-finite numbers, which JSON lacks, by null."""
    if isinstance(value, Mapping):
        return {str(key): _without_nan(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_without_nan(item) for item in value]
    return None if isinstance(value, float) and not isfinite(value) else value
