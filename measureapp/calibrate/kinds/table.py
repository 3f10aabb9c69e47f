"""Every kind of calibration by name, in the order in which menus offer them: the one place where a kind is registered."""

from __future__ import annotations

from collections.abc import Mapping

from measureapp.calibrate.draft.draft import Kind
from measureapp.calibrate.kinds.axis import Axis
from measureapp.calibrate.kinds.cameras import Cameras
from measureapp.calibrate.kinds.guide import Guide
from measureapp.calibrate.kinds.hand_eye import HandEyeKind
from measureapp.calibrate.kinds.projector import Projector
from measureapp.calibrate.kinds.rig import Rig
from measureapp.errors import InputError

KINDS: Mapping[str, Kind] = {kind.name: kind for kind in (Rig(), Cameras(), Projector(), HandEyeKind(), Guide(), Axis())}


def find_kind(name: str) -> Kind:
    """Return a kind of calibration by name. Raises InputError where there is none of that name."""
    if name not in KINDS:
        raise InputError(f"{name!r} is not a kind of calibration.", "Choose one of: " + ", ".join(KINDS) + ".")
    return KINDS[name]
