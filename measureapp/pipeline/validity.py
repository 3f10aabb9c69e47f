"""May this calibration serve these images? Asked before a scan moves anything, and of every scan afterwards."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime
from statistics import median

from measureapp.acquire.capture import conditions_now
from measureapp.calibrate.cameras.drift import camera_drift
from measureapp.calibrate.cameras.validity import check_fits, shortfalls
from measureapp.data.calibration import RigCalibration
from measureapp.data.conditions import Conditions
from measureapp.data.measurement import ViewResult
from measureapp.data.rig import RigDescription
from measureapp.data.validity import CheckRecord, Drift, Validity
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError
from measureapp.project.documents import calibration_id
from measureapp.project.folder import ProjectFolder


def check_before_scan(rig: Rig, calibration: RigCalibration) -> Validity:
    """Ask the connected devices whether the calibration is theirs, and whether it still holds by its age and temperature.

    Raises
    ------
    CalibrationError
        It is of other cameras or of cameras set otherwise; or it no longer holds and the rig's rules refuse such a calibration.
    """
    conditions = conditions_now(rig)
    sizes = {name: (camera.width_px, camera.height_px) for name, camera in rig.cameras.items()}
    check_fits(calibration.cameras, conditions.serials, sizes, conditions.lenses)
    return _aged(calibration, rig.description, conditions)


def check_stored_images(project: ProjectFolder, calibration: RigCalibration) -> None:
    """Refuse a calibration of other cameras than those that took the project's images. Raises CalibrationError as `check_before_scan`."""
    for conditions in _recorded(project):
        check_fits(calibration.cameras, conditions.serials, {}, conditions.lenses)
        _aged(calibration, project.rig(), conditions)


def validity_of(project: ProjectFolder, calibration: RigCalibration, views: Sequence[ViewResult]) -> Validity:
    """Judge the calibration for the images of a scan, and keep the judgement in its history."""
    recorded = _recorded(project)
    drift = camera_drift([view.shift for view in views if view.shift is not None], calibration.cameras)
    warm = [conditions.temperature_c for conditions in recorded if conditions.temperature_c is not None]
    temperature = median(warm) if warm else None
    at = max((conditions.taken_at for conditions in recorded), default="")
    warnings = _aged(calibration, project.rig(), Conditions(at, temperature)).warnings if recorded else ()
    if recorded:
        project.record_check(_line(at, calibration, drift, temperature))
    return Validity(warnings, drift, temperature)


def known_validity(project: ProjectFolder, calibration: RigCalibration, measured: Validity | None) -> Validity:
    """Return what is known of the calibration when a project is opened: from its measurement, and a check with the board after it."""
    lines = [line for line in project.calibration_history() if line.calibration == calibration_id(calibration)]
    found = measured or Validity()
    if lines and lines[-1].kind == "board check" and lines[-1].status != "good":
        return replace(found, warnings=(*found.warnings, lines[-1].sentence))
    return found


def _line(at: str, calibration: RigCalibration, drift: Drift, temperature_c: float | None) -> CheckRecord:
    line = CheckRecord(at, "scan", calibration_id(calibration), drift.status, drift.sentence, temperature_c=temperature_c)
    if drift.status == "unknown":
        return line
    return replace(line, shift_px=drift.shift_px, expected_px=drift.expected_px, error_mm=drift.error_mm, cameras=drift.cameras)


def _recorded(project: ProjectFolder) -> list[Conditions]:
    return [one for id_ in project.stored_viewpoints() if (one := project.frames.conditions(id_)) is not None]


def _aged(calibration: RigCalibration, rig: RigDescription, conditions: Conditions) -> Validity:
    rules = rig.calibration_rules
    now = datetime.fromisoformat(conditions.taken_at)
    now = now if now.tzinfo else now.replace(tzinfo=UTC)
    warnings = shortfalls(calibration.provenance, now, conditions.temperature_c, rules, rig.standoff_mm)
    if warnings and rules.when_exceeded == "refuse":
        raise CalibrationError(
            " ".join(warnings), "Calibrate again; or let the rig's calibration_rules warn instead of refusing (when_exceeded)."
        )
    return Validity(warnings, None, conditions.temperature_c)
