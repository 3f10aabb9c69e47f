"""The rotary table on a serial line."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from axis_peers import serial_axis

from measureapp.devices.rotary_table import RotaryTable

KIND = "rotary-table"


@contextmanager
def connected(time_scale: float) -> Iterator[RotaryTable]:
    with serial_axis(speed_deg=30.0 if time_scale else 20_000.0) as found:
        yield found.device
