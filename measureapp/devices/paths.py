"""What finds free ways for the axes of a rig."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from measureapp.arrays import FloatArray
from measureapp.data.fringe import AxisReadback
from measureapp.data.leg import Leg
from measureapp.data.plan import Viewpoint


class Paths(Protocol):
    """Ways from where the axes are to a viewpoint, on which nothing touches."""

    def legs_to(self, viewpoint: Viewpoint, here: AxisReadback, joints_rad: FloatArray | None) -> Sequence[Leg]:
        """Return the moves to a viewpoint, to be driven one after the other.

        Parameters
        ----------
        here : read-back of all axes
        joints_rad : (6,) read-back of the robot's joints; None: it does not tell them

        Raises
        ------
        LimitError
            There is no free way.
        """
