"""Validity of a calibration, checked before and after every scan."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from datetime import UTC, datetime
from statistics import median

from measureapp.acquire.session import read_conditions
from measureapp.calibrate.cameras.drift import camera_drift
from measureapp.calibrate.cameras.validity import check_fits, shortfalls
from measureapp.data.calibration import RigCalibration
from measureapp.data.conditions import Conditions
from measureapp.data.measurement import ViewResult
from measureapp.data.rig import RigDescription
from measureapp.data.validity import CheckRecord, Drift, Validity
from measureapp.devices.rig import Rig
from measureapp.errors import CalibrationError, StorageError
from measureapp.project.documents import calibration_id
from measureapp.project.folder import ProjectFolder


def check_before_scan(rig: Rig, calibration: RigCalibration) -> Validity:
    """Check that the calibration belongs to the connected devices and is valid by age and temperature.

    Raises
    ------
    CalibrationError
        It is of other cameras or other lens settings; or it is no longer valid and the rig's rules refuse such a calibration.
    """
    conditions = read_conditions(rig)
    sizes = {name: (camera.width_px, camera.height_px) for name, camera in rig.cameras.items()}
    check_fits(calibration.cameras, conditions.serials, sizes, conditions.lenses)
    return _check_age(calibration, rig.description, conditions)


def check_stored_images(project: ProjectFolder, calibration: RigCalibration) -> None:
    """Check that the calibration belongs to the cameras of the project's images. Raises CalibrationError as `check_before_scan`."""
    for conditions in _recorded(project):
        check_fits(calibration.cameras, conditions.serials, {}, conditions.lenses)
        _check_age(calibration, project.rig(), conditions)


def validity_of(project: ProjectFolder, calibration: RigCalibration, views: Sequence[ViewResult]) -> Validity:
    """Evaluate the validity of the calibration for the images of a scan, and append the result to its history."""
    recorded = _recorded(project)
    drift = camera_drift([view.shift for view in views if view.shift is not None], calibration.cameras)
    warm = [conditions.temperature_c for conditions in recorded if conditions.temperature_c is not None]
    temperature = median(warm) if warm else None
    at = max((conditions.taken_at for conditions in recorded), default="")
    warnings = _check_age(calibration, project.rig(), Conditions(at, temperature)).warnings if recorded else ()
    if recorded:
        project.record_check(_check_record(at, calibration, drift, temperature))
    return Validity(warnings, drift, temperature)


def known_validity(project: ProjectFolder, calibration: RigCalibration, measured: Validity | None) -> Validity:
    """Return the validity of the calibration of an opened project, from its measurement and later board checks."""
    lines = [line for line in project.calibration_history() if line.calibration == calibration_id(calibration)]
    found = measured or Validity()
    if lines and lines[-1].kind == "board check" and lines[-1].status != "good":
        return replace(found, warnings=(*found.warnings, lines[-1].sentence))
    return found


def _check_record(at: str, calibration: RigCalibration, drift: Drift, temperature_c: float | None) -> CheckRecord:
    line = CheckRecord(at, "scan", calibration_id(calibration), drift.status, drift.sentence, temperature_c=temperature_c)
    if drift.status == "unknown":
        return line
    return replace(line, shift_px=drift.shift_px, expected_px=drift.expected_px, error_mm=drift.error_mm, cameras=drift.cameras)


def _recorded(project: ProjectFolder) -> list[Conditions]:
    found = []
    for viewpoint_id in project.stored_viewpoints():
        with suppress(StorageError):  # a damaged stack is reported where its images are used
            found.append(project.frames.conditions(viewpoint_id))
    return [one for one in found if one is not None]


def _check_age(calibration: RigCalibration, rig: RigDescription, conditions: Conditions) -> Validity:
    rules = rig.calibration_rules
    now = datetime.fromisoformat(conditions.taken_at)
    now = now if now.tzinfo else now.replace(tzinfo=UTC)
    warnings = shortfalls(calibration.provenance, now, conditions.temperature_c, rules, rig.standoff_mm)
    if warnings and rules.when_exceeded == "refuse":
        raise CalibrationError(" ".join(warnings), 'Calibrate again, or set when_exceeded = "warn" in the rig\'s calibration_rules.')
    return Validity(warnings, None, conditions.temperature_c)
