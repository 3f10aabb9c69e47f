"""The drivers that must keep the contracts: each test runs once per rig named in DRIVERS."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from measureapp.data.rig import RigDescription
from measureapp.devices.plugin_loader import load_plugin
from measureapp.devices.rig import Rig
from measureapp.progress import Cancelled
from measureapp.project.rig_file import read_rig

Connect = Callable[[float], Rig]


def virtual_rig(time_scale: float) -> Rig:
    description: RigDescription = read_rig("paper").at_resolution("quarter")
    return load_plugin(None, "virtual_rig").entry(description, {"part": "flat", "seed": 3, "time_scale": time_scale})


DRIVERS: dict[str, Connect] = {"virtual_rig": virtual_rig}


@pytest.fixture(scope="module", params=sorted(DRIVERS))
def connect(request: pytest.FixtureRequest) -> Connect:
    return DRIVERS[request.param]


@pytest.fixture(scope="module")
def rig(connect: Connect) -> Rig:
    """A rig that does not wait."""
    return connect(0.0)


@pytest.fixture(scope="module")
def slow_rig(connect: Connect) -> Rig:
    """A rig whose moves and exposures last as long as in reality."""
    return connect(1.0)


@pytest.fixture
def cancelled_by() -> Callable[[Callable[[], None], Callable[[], object]], bool]:
    """Run a call on a thread, stop it from here, and say whether it ended by Cancelled."""

    def run(stop: Callable[[], None], call: Callable[[], object]) -> bool:
        outcome: list[bool] = []

        def body() -> None:
            try:
                call()
            except Cancelled:
                outcome.append(True)
            else:
                outcome.append(False)

        thread = threading.Thread(target=body)
        thread.start()
        while thread.is_alive():
            stop()
            thread.join(0.005)
        return outcome == [True]

    return run
