"""Validity of a calibration: it belongs to these cameras, and is neither expired nor too warm."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime, timedelta

from measureapp.data.calibration import CameraArrayCalibration, Provenance
from measureapp.data.conditions import LensSetting
from measureapp.data.rig import CalibrationRules
from measureapp.errors import CalibrationError

SAME_SETTING = 0.01  # relative: what a lens reads back may differ in the last digit


def check_fits(
    calibration: CameraArrayCalibration,
    serials: Mapping[str, str],
    sizes_px: Mapping[str, tuple[int, int]],
    lenses: Mapping[str, LensSetting] | None = None,
) -> None:
    """Refuse the calibration of other cameras.

    Parameters
    ----------
    serials : camera -> serial number as the device says; an empty one, or an empty one in the calibration, is not compared
    sizes_px : camera -> (width, height) of its images
    lenses : camera -> how its lens is set, where it tells; compared where the calibration knows it too

    Raises
    ------
    CalibrationError
        A camera is missing in the calibration, has another serial number, image size, focus or aperture. All differences are named.
    """
    wrong = [*_differences(calibration, serials, sizes_px), *_find_changed_lenses(calibration, lenses or {})]
    if wrong:
        raise CalibrationError(
            "The calibration does not belong to these cameras: " + "; ".join(wrong) + ".",
            "Choose the calibration of these cameras as they are set now, or calibrate them.",
        )


def _differences(calibration: CameraArrayCalibration, serials: Mapping[str, str], sizes_px: Mapping[str, tuple[int, int]]) -> list[str]:
    wrong = []
    owners = {camera.serial: name for name, camera in calibration.cameras.items() if camera.serial}
    for name in dict.fromkeys((*serials, *sizes_px)):
        if name not in calibration.cameras:
            wrong.append(f"it has no camera {name!r}")
            continue
        camera = calibration.cameras[name]
        serial, lens = serials.get(name, ""), camera.pinhole
        if serial and camera.serial and serial != camera.serial:
            exchanged = f", which was calibrated as {owners[serial]!r}" if serial in owners else ""
            wrong.append(f"camera {name!r} has serial number {serial}{exchanged}, {camera.serial} was calibrated")
        size = sizes_px.get(name, (lens.width_px, lens.height_px))
        if tuple(size) != (lens.width_px, lens.height_px):
            wrong.append(f"camera {name!r} gives {size[0]} × {size[1]} px, {lens.width_px} × {lens.height_px} px were calibrated")
    return wrong


def _find_changed_lenses(calibration: CameraArrayCalibration, lenses: Mapping[str, LensSetting]) -> list[str]:
    wrong = []
    for name, lens in lenses.items():
        if name in calibration.cameras:
            known = calibration.cameras[name].lens
            for word, now, then in (("focus in mm", lens.focus_mm, known.focus_mm), ("f-number", lens.f_number, known.f_number)):
                if now is not None and then is not None and abs(now - then) > SAME_SETTING * abs(then):
                    wrong.append(f"camera {name!r} is set to {word} {now:g}, {then:g} was calibrated")
    return wrong


def shortfalls(
    provenance: Provenance,
    now: datetime,
    temperature_c: float | None = None,
    rules: CalibrationRules = CalibrationRules(),  # noqa: B008 - frozen
    standoff_mm: float | None = None,
) -> tuple[str, ...]:
    """Return the reasons why a calibration should be renewed or checked; nothing if it is valid.

    Parameters
    ----------
    now : when the images were taken that it serves, with time zone
    temperature_c : as it was then, where it is measured
    rules : of the rig; a calibration that was given a shorter life itself keeps it
    standoff_mm : from the head to the part; with it the effect of a temperature is stated in mm
    """
    return (*_too_old(provenance, now, rules), *_too_warm(provenance, temperature_c, rules, standoff_mm))


def _too_old(provenance: Provenance, now: datetime, rules: CalibrationRules) -> list[str]:
    created = _creation_time(provenance)
    lives = [days for days in (provenance.valid_days, rules.valid_days) if days is not None]
    if created is None:
        unknown = f"The date of the calibration, {provenance.created!r}, cannot be read, so that it counts as expired."
        return [unknown] if provenance.valid_days is not None or (lives and provenance.created) else []
    if created > now + timedelta(days=1):
        return [f"The calibration is dated {created:%Y-%m-%d}, which is in the future: check the computer's clock."]
    if lives and now > created + timedelta(days=min(lives)):
        return [
            f"The calibration of {created:%Y-%m-%d} was valid for {min(lives):g} days and has expired; only images of the "
            "board show what that means in mm: check it with a few views of the board, or calibrate again."
        ]
    return []


def _too_warm(provenance: Provenance, temperature_c: float | None, rules: CalibrationRules, standoff_mm: float | None) -> list[str]:
    if temperature_c is None or provenance.temperature_c is None:
        return []
    change = temperature_c - provenance.temperature_c
    if abs(change) <= rules.largest_temperature_change_k:
        return []
    relative = abs(change) * rules.head_expansion_per_k  # the baseline grows with the frame, and all lengths are measured in baselines
    effect = f"{relative * 1e6:.0f} ppm of every length"
    if standoff_mm is not None:
        effect += f", {relative * standoff_mm:.3f} mm at {standoff_mm:.0f} mm from the head"
    return [
        f"It was {temperature_c:.1f} °C at the head and {provenance.temperature_c:.1f} °C at the calibration "
        f"({rules.largest_temperature_change_k:g} K are allowed), which may cost {effect}: "
        "let the head come to its temperature, or check the calibration with a few views of the board."
    ]


def _creation_time(provenance: Provenance) -> datetime | None:
    try:
        created = datetime.fromisoformat(provenance.created)
    except ValueError:
        return None
    return created if created.tzinfo else created.replace(tzinfo=UTC)
