"""The rotary table on a Newport ESP301, over a serial line."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from serial_tables import serial_table

from measureapp.devices.rotary_table import RotaryTable

KIND = "rotary-table"


@contextmanager
def connected(time_scale: float) -> Iterator[RotaryTable]:
    with serial_table("newport_esp301", 30.0 if time_scale else 20_000.0, tolerance=0.0005) as found:
        yield found.device
