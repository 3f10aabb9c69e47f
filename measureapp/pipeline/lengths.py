"""What a project knows of its lengths: the board that gave them their scale, and the temperature of the part."""

from __future__ import annotations

from dataclasses import dataclass

from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.certificate import CLASSES, lengths_of_class
from measureapp.data.identification import Identification
from measureapp.data.part_temperature import PartTemperature, part_temperature
from measureapp.data.rig import RigDescription

SIMULATED = {"virtual_rig"}  # drivers whose board is as its description has it, unless its project states otherwise
NOT_STATED = f"the board's class is not stated, assumed is {CLASSES['printed'].words}"


@dataclass(frozen=True, slots=True)
class LengthScale:
    """Standard uncertainty of the scale of all lengths, and where it comes from."""

    ppm: float
    source: str


def length_scale(cameras: CameraArrayCalibration | None, rig: RigDescription | None) -> LengthScale:
    """Return the uncertainty of a project's scale: by its board, else as its rig states it, else that of a printed board.

    Nothing is exact by default; the board of the virtual rig is, where nobody states its lengths.
    """
    if cameras is not None and cameras.lengths is not None:
        return LengthScale(cameras.lengths.sigma * 1e6, cameras.lengths.words)
    if rig is not None and rig.calibration_rules.scale_ppm > 0:
        return LengthScale(rig.calibration_rules.scale_ppm, "the rig description")
    if rig is None or set(rig.drivers.values()) <= SIMULATED:
        return LengthScale(0.0, "the board of the virtual rig")
    return LengthScale(lengths_of_class("printed").sigma * 1e6, NOT_STATED)


def temperature_of(identification: Identification) -> PartTemperature | None:
    """Return the temperature of a part from the header of its report; not corrected where the expansion of its material is not known."""
    try:
        return part_temperature(identification.part_temperature, identification.material)
    except ValueError:
        return part_temperature(identification.part_temperature)
