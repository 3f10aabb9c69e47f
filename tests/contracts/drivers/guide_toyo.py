"""The guide on a TOYO controller, over a serial line."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from axis_peers import toyo_guide

from measureapp.devices.linear_guide import LinearGuideAxis

KIND = "linear-guide"


@contextmanager
def connected(time_scale: float) -> Iterator[LinearGuideAxis]:
    with toyo_guide(300.0 if time_scale else 20_000.0, tolerance=0.005) as found:
        yield found.device
