"""A session needs the head, the board and the rig of the calibrations, and marks that stand for images."""

from tests.calibrate.conftest import board, generator, head, rig, shown, simulate  # noqa: F401 - fixtures
