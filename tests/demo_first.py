"""The order of the tests: the demo begins at once, so that no process has to wait for the one that runs it."""

from __future__ import annotations

import pytest


@pytest.hookimpl(trylast=True)  # what is deselected is gone by then
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the first file whose tests ask for the demo before all others, which stay in their order."""
    first = next((item.path for item in items if "demo" in getattr(item, "fixturenames", ())), None)
    items.sort(key=lambda item: item.path != first)
