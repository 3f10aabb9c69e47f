"""The rotary table on Modbus TCP."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from axis_peers import simple_table

from measureapp.devices.rotary_table import RotaryTable

KIND = "rotary-table"


@contextmanager
def connected(time_scale: float) -> Iterator[RotaryTable]:
    with simple_table(30.0 if time_scale else 20_000.0) as found:
        yield found.device
