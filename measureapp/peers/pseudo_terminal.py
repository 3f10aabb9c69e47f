"""A serial line without hardware: a pair of pseudo-terminals."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

from measureapp.errors import InputError


@contextmanager
def serial_line() -> Iterator[tuple[int, str]]:
    """Open a pair; yields the handle of the device's end and the port of the program's.

    Raises
    ------
    InputError
        The operating system has no pseudo-terminals (Windows).
    """
    try:
        import tty
    except ImportError as error:
        raise InputError("This system cannot simulate a serial line.", "Run virtual devices on Linux or macOS.") from error
    handle, other = os.openpty()
    try:
        tty.setraw(handle)
        tty.setraw(other)
        yield handle, os.ttyname(other)
    finally:
        os.close(other)
        os.close(handle)
