"""Run-time selection between compiled kernels and their NumPy reference statements."""

from __future__ import annotations

import os

from measureapp.errors import InputError

VARIABLE = "MEASUREAPP_KERNELS"
COMPILED, REFERENCE = "compiled", "reference"


def use_reference() -> bool:
    """Tell whether the NumPy reference statements replace the compiled kernels.

    The environment variable ``MEASUREAPP_KERNELS`` selects: ``compiled`` (default) or ``reference``. It is read at every call.

    Raises
    ------
    InputError
        The variable has another value.
    """
    choice = os.environ.get(VARIABLE, COMPILED)
    if choice not in (COMPILED, REFERENCE):
        raise InputError(f"The environment variable {VARIABLE} is {choice!r}, but must be {COMPILED!r} or {REFERENCE!r}.")
    return choice == REFERENCE
