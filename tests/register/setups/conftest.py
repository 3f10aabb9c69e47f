"""A part that was scanned upright and turned over, once for all tests of this room."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import pytest

from measureapp.geometry.transform import RigidTransform
from measureapp.register.setups.setup_cloud import SetUpCloud
from tests.register.setups.scanned_setups import STEP_MM, bracket, put, set_up


@dataclass(frozen=True)
class TurnedOver:
    """Two set-ups of one part, and how they truly stood."""

    mesh: Any
    up: SetUpCloud
    down: SetUpCloud
    up_from_down: RigidTransform


def scan_turned_over(step_mm: float = STEP_MM) -> TurnedOver:
    """Scan the bracket upright and turned over."""
    mesh = bracket()
    upright, part_from_nominal = put(mesh, (0.0, 0.0, 0.0))
    flipped, other_from_nominal = put(mesh, (180.0, 0.0, 25.0), (4.0, -3.0))
    return TurnedOver(
        mesh,
        set_up("up", upright, 1, step_mm=step_mm),
        set_up("down", flipped, 2, step_mm=step_mm),
        part_from_nominal @ other_from_nominal.inverse(),
    )


@pytest.fixture(scope="session")
def turned_over() -> TurnedOver:
    return scan_turned_over()
