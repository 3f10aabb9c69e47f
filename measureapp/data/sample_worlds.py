"""Names of the worlds that the virtual rig can be in: how well rig and part are made (`resources/worlds`, decision 31)."""

from __future__ import annotations

IDEAL = "ideal"  # what the program's model describes exactly
DEFAULT_WORLD = "usual"  # of the demo: its figures are those of a rig as it is found in a workshop
WORLDS = (IDEAL, "good", "usual", "bad")
