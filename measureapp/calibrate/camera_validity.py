"""Whether a calibration belongs to the cameras at hand, and whether it is still valid."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime, timedelta

from measureapp.data.calibration import CameraArrayCalibration, Provenance
from measureapp.errors import CalibrationError

LARGEST_TEMPERATURE_CHANGE_K = 3.0  # the paper's head of aluminium grows by 0.02 mm over its 350 mm baseline


def check_fits(calibration: CameraArrayCalibration, serials: Mapping[str, str], sizes_px: Mapping[str, tuple[int, int]]) -> None:
    """Refuse the calibration of other cameras.

    Parameters
    ----------
    serials : camera -> serial number as the device says; an empty one, or an empty one in the calibration, is not compared
    sizes_px : camera -> (width, height) of its images

    Raises
    ------
    CalibrationError
        A camera is missing in the calibration, has another serial number or another image size. All differences are named.
    """
    wrong = [*_differences(calibration, serials, sizes_px)]
    if wrong:
        raise CalibrationError(
            "The calibration does not belong to these cameras: " + "; ".join(wrong) + ".",
            "Choose the calibration of these cameras, or calibrate them.",
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


def shortfalls(provenance: Provenance, now: datetime, temperature_c: float | None = None) -> tuple[str, ...]:
    """Say why a calibration should be made anew or checked; nothing where it is valid.

    Parameters
    ----------
    now : with its time zone
    temperature_c : as it is now, where it is measured
    """
    reasons = []
    created = _created(provenance)
    if provenance.valid_days is not None and created is None:
        reasons.append(f"The date of the calibration, {provenance.created!r}, cannot be read, so that it counts as expired.")
    elif provenance.valid_days is not None and created is not None and now > created + timedelta(days=provenance.valid_days):
        reasons.append(f"The calibration of {created:%Y-%m-%d} was valid for {provenance.valid_days:g} days and has expired.")
    if created is not None and created > now + timedelta(days=1):
        reasons.append(f"The calibration is dated {created:%Y-%m-%d}, which lies in the future: check the computer's clock.")
    if temperature_c is not None and provenance.temperature_c is not None:
        change = temperature_c - provenance.temperature_c
        if abs(change) > LARGEST_TEMPERATURE_CHANGE_K:
            reasons.append(
                f"It is {temperature_c:.1f} °C now and was {provenance.temperature_c:.1f} °C at the calibration: "
                "let the head warm up, or check it with a few views of the board."
            )
    return tuple(reasons)


def _created(provenance: Provenance) -> datetime | None:
    try:
        created = datetime.fromisoformat(provenance.created)
    except ValueError:
        return None
    return created if created.tzinfo else created.replace(tzinfo=UTC)
