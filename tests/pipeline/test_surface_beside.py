"""The surface is computed beside the inspection, and ends with it."""

from __future__ import annotations

import time

import numpy as np
import pytest

from measureapp.data.mesh import Mesh
from measureapp.errors import InputError, RegistrationError
from measureapp.pipeline import surface
from measureapp.pipeline.events import SurfaceFailed
from measureapp.pipeline.surface import SurfaceBeside
from measureapp.progress import CallbackProgress, Cancelled, NoProgress


def endless(cloud, progress):
    for _ in range(1000):
        progress.report(0, 1)
        time.sleep(0.01)
    raise AssertionError("it was never stopped")


def test_an_error_of_the_inspection_ends_the_surface(monkeypatch):
    monkeypatch.setattr(surface, "reconstruct_surface", endless)
    with pytest.raises(InputError), SurfaceBeside(None):
        raise InputError("A feature is wrong.", "Mend it.")


def test_cancelling_while_it_is_awaited_ends_it(monkeypatch):
    monkeypatch.setattr(surface, "reconstruct_surface", endless)

    def cancel(*_):
        raise Cancelled

    with pytest.raises(Cancelled), SurfaceBeside(None) as beside:
        beside.wait(lambda event: None, CallbackProgress(cancel))


def test_it_is_awaited_and_a_failure_is_told_by_the_thread_that_waits(monkeypatch):
    mesh, told = Mesh(np.eye(3), [[0, 1, 2]], "part"), []
    monkeypatch.setattr(surface, "reconstruct_surface", lambda cloud, progress: mesh)
    with SurfaceBeside(None) as beside:
        assert beside.wait(told.append, NoProgress()) is mesh

    def fail(cloud, progress):
        raise RegistrationError("No memory.", "Close other programs.")

    monkeypatch.setattr(surface, "reconstruct_surface", fail)
    with SurfaceBeside(None) as beside:
        assert beside.wait(told.append, NoProgress()) is None
    assert [type(one) for one in told] == [SurfaceFailed]
