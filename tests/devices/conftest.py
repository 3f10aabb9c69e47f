"""Plugins of these tests lie in folders of their own, and are allowed unless a test asks about just that."""

from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def _everything_is_allowed(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if "permissions" not in request.fixturenames:
        monkeypatch.setattr("measureapp.devices.plugin_loader.is_allowed", lambda folder: True)
