"""The drivers that must keep the contracts: each test runs once for every driver of its kind of device.

A driver joins by a file in `drivers/` with `KIND`, as in plugin manifests, and `connected(time_scale)`, a context manager that yields the
device; time scale 0 is as fast as possible, 1 lets moves and exposures last as long as in reality.
"""

from __future__ import annotations

import importlib
import pkgutil
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from typing import Any

import pytest
from contracts import drivers

from measureapp.data.rig import RigDescription
from measureapp.devices.camera import Camera
from measureapp.devices.linear_guide import LinearGuideAxis
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.projector import Projector
from measureapp.devices.request import DeviceRequest
from measureapp.devices.rig import Rig
from measureapp.devices.robot import Robot
from measureapp.devices.rotary_table import RotaryTable
from measureapp.progress import Cancelled
from measureapp.project.rig_file import read_rig

Connected = Callable[[float], AbstractContextManager[Any]]
FIXTURES = {"camera": "camera", "projector": "projector", "robot": "robot", "guide": "linear-guide", "table": "rotary-table"}


def virtual_rig(time_scale: float) -> Rig:
    description: RigDescription = read_rig("paper").at_resolution("quarter")
    loaded = load_driver(None, "virtual_rig", "rig")
    settings = loaded.settings.model_validate({"part": "flat", "seed": 3, "time_scale": time_scale})
    return loaded.entry(DeviceRequest("rig", description, settings, Links({})))


def _of_virtual_rig(pick: Callable[[Rig], Any]) -> Connected:
    @contextmanager
    def connected(time_scale: float) -> Iterator[Any]:
        rig = virtual_rig(time_scale)
        yield pick(rig)
        rig.close()

    return connected


def _found() -> dict[str, dict[str, Connected]]:
    found: dict[str, dict[str, Connected]] = {
        "camera": {"virtual_rig": _of_virtual_rig(lambda rig: rig.cameras["left"])},
        "projector": {"virtual_rig": _of_virtual_rig(lambda rig: rig.projector)},
        "robot": {"virtual_rig": _of_virtual_rig(lambda rig: rig.robot)},
        "linear-guide": {"virtual_rig": _of_virtual_rig(lambda rig: rig.guide)},
        "rotary-table": {"virtual_rig": _of_virtual_rig(lambda rig: rig.table)},
    }
    for module in pkgutil.iter_modules(drivers.__path__):
        driver = importlib.import_module(f"contracts.drivers.{module.name}")
        found[driver.KIND][module.name] = driver.connected
    return found


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run a test once for every driver of the kind that it takes as a fixture."""
    for fixture, kind in FIXTURES.items():
        for name in (fixture, f"slow_{fixture}"):
            if name in metafunc.fixturenames:
                makers = _found()[kind]
                metafunc.parametrize(name, list(makers.values()), ids=list(makers), indirect=True, scope="module")


def _device(request: pytest.FixtureRequest, time_scale: float) -> Iterator[Any]:
    with ExitStack() as held:
        yield held.enter_context(request.param(time_scale))


@pytest.fixture(scope="module")
def camera(request: pytest.FixtureRequest) -> Iterator[Camera]:
    yield from _device(request, 0.0)


@pytest.fixture(scope="module")
def slow_camera(request: pytest.FixtureRequest) -> Iterator[Camera]:
    yield from _device(request, 1.0)


@pytest.fixture(scope="module")
def projector(request: pytest.FixtureRequest) -> Iterator[Projector]:
    yield from _device(request, 0.0)


@pytest.fixture(scope="module")
def robot(request: pytest.FixtureRequest) -> Iterator[Robot]:
    yield from _device(request, 0.0)


@pytest.fixture(scope="module")
def slow_robot(request: pytest.FixtureRequest) -> Iterator[Robot]:
    yield from _device(request, 1.0)


@pytest.fixture(scope="module")
def guide(request: pytest.FixtureRequest) -> Iterator[LinearGuideAxis]:
    yield from _device(request, 0.0)


@pytest.fixture(scope="module")
def slow_guide(request: pytest.FixtureRequest) -> Iterator[LinearGuideAxis]:
    yield from _device(request, 1.0)


@pytest.fixture(scope="module")
def table(request: pytest.FixtureRequest) -> Iterator[RotaryTable]:
    yield from _device(request, 0.0)


@pytest.fixture(scope="module")
def slow_table(request: pytest.FixtureRequest) -> Iterator[RotaryTable]:
    yield from _device(request, 1.0)


@pytest.fixture(scope="module")
def rig() -> Rig:
    """A whole rig, whose devices do not wait."""
    return virtual_rig(0.0)


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
        thread.join(0.05)  # a stop before the call has begun would leave it alone
        while thread.is_alive():
            stop()
            thread.join(0.005)
        return outcome == [True]

    return run
