"""Names, units and validation problems of the fields of models, in words."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from ui.look.language.words import tr
from ui.look.wording import sentence

UNITS = {
    "mm_per_s": "mm/s",
    "deg_per_s2": "°/s²",
    "deg_per_s": "°/s",
    "mbit_per_s": "Mbit/s",
    "per_k": "1/K",
    "mm": "mm",
    "um": "µm",
    "us": "µs",
    "ms": "ms",
    "s": "s",
    "deg": "°",
    "arcsec": "″",
    "px": "px",
    "days": "days",
    "bytes": "bytes",
    "ppm": "ppm",
    "k": "K",
    "c": "°C",
    "e": "e⁻",
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
    "valid_days": "Validity",
    "certified_mm": "Certified length at 20 °C",
    "uncertainty_mm": "Uncertainty (k = 2)",
    "number": "Number of the certificate",
    "scale_ppm": "Uncertainty of the scale",
    "head_expansion_per_k": "Thermal expansion of the head",
    "full_well_e": "Full well",
}
"""Labels of fields whose name says too little."""
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

    >>> field_words("reply_timeout_s"), field_words("usb_serial")
    (('Reply timeout', 's'), ('USB serial', ''))
    """
    ending = next((ending for ending in UNITS if name.endswith(f"_{ending}")), "")
    words = name.removesuffix(f"_{ending}").split("_") if ending else name.split("_")
    label = LABELS.get(name) or " ".join(PROPER.get(word, word) for word in words)
    return label[:1].upper() + label[1:], UNITS.get(ending, "")


def problem_words(problem: Mapping[str, Any]) -> str:
    """Return a validation problem of pydantic as a sentence."""
    kind, limits = problem["type"], problem.get("ctx", {})
    if kind == "string_too_short":
        return "Enter a value."
    if kind == "too_short":
        return tr("Give at least {limits}.", limits=limits["min_length"])
    known = PROBLEMS.get(kind)
    if known:
        return sentence(tr(known, **limits))
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
            parts.append(label if not parts else label[:1].lower() + label[1:])
        elif parts and step is not place[-1]:
            parts[-1] += f" {step + 1}"
    return ", ".join(parts)
