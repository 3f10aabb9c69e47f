"""Names, units and validation problems of the fields of models, in words."""

from __future__ import annotations

import re
from collections.abc import Mapping
from enum import Enum
from typing import Any

from ui.look.language.words import later, tr
from ui.look.wording import sentence

UNITS = {
    "mm_per_s": "mm/s",
    "deg_per_s2": "°/s²",
    "deg_per_s": "°/s",
    "mbit_per_s": "Mbit/s",
    "per_k": "1/K",
    "mm_s2": "mm/s²",
    "deg_s2": "°/s²",
    "mm_s": "mm/s",
    "deg_s": "°/s",
    "mm": "mm",
    "um": "µm",
    "us": "µs",
    "ms": "ms",
    "s": "s",
    "deg": "°",
    "arcsec": "″",
    "px": "px",
    "days": later("days"),
    "bytes": later("bytes"),
    "ppm": "ppm",
    "k": "K",
    "c": "°C",
    "e": "e⁻",
    "percent": "%",
}
"""Endings of names and the units they stand for, the longest first."""
PROPER = {"usb": "USB", "tcp": "TCP", "udp": "UDP", "id": "ID", "led": "LED", "egm": "EGM", "sha256": "SHA-256", "io": "I/O"}
NAME = re.compile(r"\b[a-z0-9]+(?:_[a-z0-9]+)+\b")  # of a field, in a sentence
LABELS = {
    "keep_out": "Keep-out boxes",
    "quaternion_wxyz": "Quaternion",
    "park": "Park pose",
    "cell": "Bodies in the cell",
    "clearance_mm": "Clearance",
    "floor_mm": "Height of the floor",
    "guide_beam": "Beam of the guide",
    "head_bodies": "Boxes of the head",
    "largest_part_mm": "Largest part",
    "settle_s": "Settling time",
    "low_mm": "Lower corner",
    "high_mm": "Upper corner",
    "reference": "Reference camera",
    "head": "Synchronisation",
    "flange_from_head": "Head on the flange",
    "head_from_camera": "Camera in the head",
    "head_from_projector": "Projector in the head",
    "packet_bytes": "Packet size",
    "inter_packet_delay": "Delay between packets",
    "baudrate": "Baud rate",
    "valid_days": "Valid for",
    "certified_mm": "Certified length at 20 °C",
    "uncertainty_mm": "Uncertainty (k = 2)",
    "number": "Number of the certificate",
    "scale_ppm": "Uncertainty of the scale",
    "head_expansion_per_k": "Thermal expansion of the head",
    "full_well_e": "Full well",
    "position_mm": "Position (x, y, z)",
    "rotation_deg": "Rotation (x, y, z)",
    "serial": "Serial number",
    "usb_serial": "Serial number of the USB adapter",
    "width_px": "Image width",
    "height_px": "Image height",
    "pixel_um": "Size of a pixel",
    "focal_mm": "Focal length",
    "focal_px": "Focal length",
    "model_file": "Kinematic model",
    "shoulder_mm": "Position of the shoulder",
    "min_reach_mm": "Least reach",
    "max_reach_mm": "Largest reach",
    "limits_mm": "Range of travel",
    "limits_deg": "Range of rotation",
    "absolute_accuracy_mm": "Accuracy of the position",
    "absolute_accuracy_deg": "Accuracy of the orientation",
    "joint_speeds_deg_s": "Speeds of the joints",
    "speed_share": "Share of the joint speeds",
    "speed_deg_s": "Speed of rotation",
    "speed_deg_per_s": "Speed of rotation",
    "acceleration_deg_s2": "Angular acceleration",
    "ramp_s": "Time to accelerate",
    "radial_error_mm": "Radial error motion",
    "axial_error_mm": "Axial error motion",
    "tilt_error_arcsec": "Tilt error motion",
    "centre_in_guide_mm": "Centre in the guide frame",
    "largest_temperature_change_k": "Largest change of temperature",
    "when_exceeded": "When a limit is exceeded",
    "move_timeout_s": "Longest duration of a move",
    "sequence": "Triggered by",
    "on_table": "Stands on the table",
    "settled_s": "Interval of reads at rest",
    "reads_apart_s": "Interval of reads at rest",
    "poll_s": "Interval of reads in motion",
    "loss_s": "Lost after",
    "answer_s": "Lost after",
    "rest_mm": "Tolerance at rest, position",
    "rest_deg": "Tolerance at rest, angle",
    "goal_mm": "Tolerance at the goal, position",
    "goal_deg": "Tolerance at the goal, angle",
    "model_mm": "Deviation from the kinematic model",
    "tolerance": "Tolerance of the position",
    "zero_counts": "Counts at zero",
    "sense": "Sense of counting",
    "order": "Order of the images",
    "row_us": "Read-out of a row",
    "readout_ms": "Read-out time",
    "readout_s": "Read-out time",
    "open_retry_s": "Longest wait for access",
    "control_wait_s": "Longest wait for access",
    "wake_timeout_s": "Longest wait for wake-up",
    "start_timeout_s": "Longest wait for the start",
    "reply_timeout_s": "Longest wait for a reply",
    "login_patience_s": "Longest wait for a login",
    "frame_us": "Duration of a frame",
    "hold_cycle_us": "Cycle of a held pattern",
    "exposure_in_name": "Exposure in the name",
    "at_end": "After the last image",
    "at_arm": "At a new sequence",
    "part_turn_deg": "Rotation of the part",
    "follows": "Follows the cell at",
    "debounce_us": "Shortest trigger pulse",
}
"""Labels of fields whose name says too little."""
CHOICES = {
    "software": "Software",
    "hardware": "Hardware",
    "warn": "Warn",
    "refuse": "Refuse",
    "box": "Box",
    "cylinder": "Cylinder",
    "rolling": "Rolling shutter",
    "global": "Global shutter",
    "global-reset": "Global reset",
    "auto": "Automatic",
    "Line1": later("Line1 (trigger input)"),
    "Line2": later("Line2 (trigger input)"),
    "Line3": later("Line3 (trigger input)"),
    "Action1": later("Action1 (action command)"),
    "map": "As the map says",
    "rtu": "Modbus RTU",
    "ascii": "Modbus ASCII",
    "socket": "Modbus TCP",
    "N": "No parity",
    "E": "Even parity",
    "O": "Odd parity",
    "name": "Name",
    "number": "Number",
    "loop": "Begin again",
    "end": "Refuse triggers",
    "continue": "Continue",
    "restart": "Restart",
    "flash": "Flash memory",
    "video": "Video port",
    "red": "Red",
    "green": "Green",
    "blue": "Blue",
    "white": "White",
    "inch": later("inch"),
    "um": "µm",
}
"""Names of the values of a choice; numbers, units and the pixel formats of GenICam are their own names."""
PIXEL_FORMAT = re.compile(r"Mono(\d+)(p|Packed)?")
PROBLEMS = {
    "missing": "Enter a value",
    "float_parsing": "Enter a number",
    "float_type": "Enter a number",
    "finite_number": "Enter a finite number",
    "int_parsing": "Enter a whole number",
    "int_type": "Enter a whole number",
    "int_from_float": "Enter a whole number",
    "greater_than": "Must be greater than {gt}",
    "greater_than_equal": "Must be at least {ge}",
    "less_than": "Must be less than {lt}",
    "less_than_equal": "Must be at most {le}",
    "literal_error": "Choose one of: {expected}",
    "extra_forbidden": "There is no such setting",
    "string_pattern_mismatch": "This text does not have the required form",
}


def field_words(name: str) -> tuple[str, str]:
    """Return the label and the unit of a field.

    >>> field_words("angle_tolerance_deg"), field_words("led_current")
    (('Angle tolerance', '°'), ('LED current', ''))
    """
    ending = next((ending for ending in UNITS if name.endswith(f"_{ending}")), "")
    words = name.removesuffix(f"_{ending}").split("_") if ending else name.split("_")
    label = LABELS.get(name) or " ".join(PROPER.get(word, word) for word in words)
    return label[:1].upper() + label[1:], UNITS.get(ending, "")


def tip_words(description: str | None) -> str:
    """Return the description of a field as its tooltip.

    >>> tip_words("wait at the goal, in the controller")
    'Wait at the goal, in the controller'
    """
    tip = (description or "").strip()
    return tip[:1].upper() + tip[1:]


def choice_words(value: Any) -> str:
    """Return the name of a value that is chosen, in the language of the window.

    >>> choice_words("global"), choice_words("Mono10Packed"), choice_words(8)
    ('Global shutter', '10 bit, packed (Mono10Packed)', '8')
    """
    value = value.value if isinstance(value, Enum) else value
    found = PIXEL_FORMAT.fullmatch(str(value))
    if found is None:
        return tr(CHOICES[value]) if value in CHOICES else str(value)
    bits, packed = found.groups()
    return tr("{bits} bit, packed ({name})", bits=bits, name=value) if packed else tr("{bits} bit ({name})", bits=bits, name=value)


def problem_words(problem: Mapping[str, Any]) -> str:
    """Return a validation problem of pydantic as a sentence."""
    kind, limits = problem["type"], problem.get("ctx", {})
    if kind == "string_too_short":
        return "Enter a value."
    if kind == "too_short":
        return tr("Give at least {limits}.", limits=limits["min_length"])
    known = PROBLEMS.get(kind)
    if known:
        plain = {name: f"{value:g}" if isinstance(value, float) else value for name, value in limits.items()}
        return tr("{problem}.", problem=tr(known, **plain))
    return sentence(NAME.sub(lambda name: field_words(name.group())[0].lower(), str(problem["msg"]).removeprefix("Value error, ")))


def place_words(place: tuple[int | str, ...]) -> str:
    """Return where a problem is.

    >>> place_words(("keep_out", 1, "low_mm", 0))
    'Keep-out boxes 2, lower corner'
    """
    parts: list[str] = []
    for step in place:
        if isinstance(step, str):
            label = field_words(step)[0]
            parts.append(tr("{label:lower}", label=label) if parts else label)
        elif parts and step is not place[-1]:
            parts[-1] = tr("{label} {number}", label=parts[-1], number=step + 1)
    return ", ".join(parts)


def problem_sentence(problem: Mapping[str, Any]) -> str:
    """Return a validation problem with the field that it concerns."""
    where = place_words(problem["loc"])
    return tr("{where}: {problem}", where=where, problem=problem_words(problem)) if where else problem_words(problem)
