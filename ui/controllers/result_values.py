"""The values of a calibration one by one, beside those of another and, on the virtual rig, beside the true ones."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from ui.look.wording import sentence_case

if TYPE_CHECKING:
    from measureapp.data.calibration import CameraArrayCalibration, HandEye, LinearGuide, ProjectorCalibration, RigCalibration, RotationAxis
    from measureapp.pipeline.collecting import Estimate

LENS_WORDS = {"fx": "Focal length x", "fy": "Focal length y", "cx": "Image centre x", "cy": "Image centre y"}
DIGITS = {"px": 2, "mm": 3, "°": 4, "": 6}
SUBJECTS = re.compile(r"^(camera on the flange, |guide |axis )")
DISTORTION = re.compile(r"[kps]\d")


@dataclass(frozen=True)
class Quantity:
    """One estimated value with its standard deviation; None where that is unknown."""

    group: str
    name: str
    unit: str
    digits: int
    value: float
    sigma: float | None = None


@dataclass(frozen=True)
class ValueRow:
    """A quantity beside its true and its earlier value, where they are known."""

    quantity: Quantity
    true: float | None = None
    previous: float | None = None


def rows_beside(found: tuple[Quantity, ...], truth: tuple[Quantity, ...], previous: tuple[Quantity, ...]) -> tuple[ValueRow, ...]:
    """Return one row per quantity found; others are matched by group and name."""
    true, before = _by_name(truth), _by_name(previous)
    return tuple(ValueRow(one, true.get((one.group, one.name)), before.get((one.group, one.name))) for one in found)


def _by_name(quantities: tuple[Quantity, ...]) -> dict[tuple[str, str], float]:
    return {(one.group, one.name): one.value for one in quantities}


def camera_quantities(cameras: CameraArrayCalibration) -> tuple[Quantity, ...]:
    """Return lens and place of every camera, the reference first."""
    from measureapp.pipeline.collecting import estimates_of

    found = estimates_of(cameras)
    return tuple(
        _quantity(f"Camera {name}", one, one.name.removeprefix(f"{name} "))
        for name in cameras.names
        for one in found
        if one.name.startswith(f"{name} ")
    )


def projector_quantities(found: ProjectorCalibration) -> tuple[Quantity, ...]:
    """Return lens and place of the projector."""
    from measureapp.pipeline.collecting import estimates_of

    return tuple(_quantity("Projector", one, one.name.removeprefix(f"{found.name} ")) for one in estimates_of(found))


def hand_eye_quantities(found: HandEye) -> tuple[Quantity, ...]:
    """Return where the reference camera sits on the flange."""
    return _link("Hand–eye", found)


def guide_quantities(found: LinearGuide) -> tuple[Quantity, ...]:
    """Return direction and scale of the linear guide."""
    return _link("Linear guide", found)


def axis_quantities(found: RotationAxis, height_mm: float) -> tuple[Quantity, ...]:
    """Return the table's axis: its direction, and where it passes the height ``height_mm`` of its frame."""
    point = found.point_mm + found.direction * (height_mm - found.point_mm[2]) / found.direction[2]
    return tuple(one for one in _link("Table axis", replace(found, point_mm=point)) if one.name != "Position z")


def rig_quantities(found: RigCalibration, height_mm: float) -> tuple[Quantity, ...]:
    """Return everything that a calibrated rig consists of; ``height_mm`` as for the axis."""
    return (
        *hand_eye_quantities(found.hand_eye),
        *guide_quantities(found.guide),
        *axis_quantities(found.axis, height_mm),
        *camera_quantities(found.cameras),
    )


def _link(group: str, found: HandEye | LinearGuide | RotationAxis) -> tuple[Quantity, ...]:
    from measureapp.pipeline.collecting import estimates_of

    return tuple(_quantity(group, one, one.name) for one in estimates_of(found))


def _quantity(group: str, one: Estimate, name: str) -> Quantity:
    short = SUBJECTS.sub("", name).replace("place ", "position ").replace("point ", "position ")
    if short in {"x", "y", "z"}:
        short = f"position {short}"
    words = LENS_WORDS.get(short) or (f"Distortion {short}" if DISTORTION.fullmatch(short) else sentence_case(short))
    digits = 5 if words.startswith("Distortion") else DIGITS[one.unit]
    return Quantity(group, words, one.unit, digits, one.value, one.sigma or None)
