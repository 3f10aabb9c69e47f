"""Rigid transforms in files of 16 numbers."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.errors import FrameMismatch, InputError
from measureapp.geometry.transform import RigidTransform

HINT = "Write the 4×4 matrix as four lines of four numbers, or as JSON."


def read_transform(path: Path, to_frame: str, from_frame: str) -> RigidTransform:
    """Read a 4×4 matrix from text (white space or commas) or JSON (a list, or an object with "matrix").

    Raises
    ------
    InputError
        The file cannot be read, does not hold 4×4 numbers, or they are not a rigid transform.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(
            f"{path} cannot be read as an alignment: {reason}.", "Name best-fit, none, or a file with a 4×4 matrix."
        ) from error
    try:
        matrix = np.array(_numbers(text), float)
    except (ValueError, TypeError, RecursionError) as error:
        raise InputError(f"{path} does not hold numbers only.", HINT) from error
    if matrix.size != 16 or not np.isfinite(matrix).all():
        raise InputError(f"{path} does not hold the 16 finite numbers of a 4×4 matrix.", HINT)
    matrix = matrix.reshape(4, 4)
    try:
        if not np.allclose(matrix[3], [0, 0, 0, 1], atol=1e-9):
            raise FrameMismatch("The last row must be 0 0 0 1.")
        return RigidTransform(matrix, to_frame, from_frame)
    except FrameMismatch as error:
        raise InputError(
            f"{path} is not a rigid transform: {error.message}", "The 3×3 part must be a rotation without scale or mirror."
        ) from error


def _numbers(text: str) -> Any:
    if not text.lstrip().startswith(("{", "[")):
        return [float(word) for word in text.replace(",", " ").split()]
    document = json.loads(text)
    return document.get("matrix") if isinstance(document, dict) else document
