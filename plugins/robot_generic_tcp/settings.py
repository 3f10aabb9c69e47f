"""Settings of a robot with the line protocol."""

from __future__ import annotations

from pydantic import Field

from measureapp.data.model import Model


class LineRobotSettings(Model):
    """How the robot is reached, and how it moves."""

    host: str = Field(default="192.168.1.10", min_length=1, description="name or address of the robot's controller")
    port: int = Field(default=5577, ge=1, le=65535, description="TCP port")
    speed_mm_per_s: float = Field(default=150.0, gt=0, le=250, description="speed of the flange")
    speed_deg_per_s: float = Field(default=30.0, gt=0, le=90, description="reorientation of the flange")
    rest_mm: float = Field(default=0.01, gt=0, le=1, description="at rest: two positions read back differ less")
    rest_deg: float = Field(default=0.005, gt=0, le=0.5, description="at rest: two orientations read back differ less")
    goal_mm: float = Field(default=0.1, gt=0, le=5, description="at the goal: the position differs less")
    goal_deg: float = Field(default=0.05, gt=0, le=5, description="at the goal: the orientation differs less")
    poll_s: float = Field(default=0.1, gt=0, le=1, description="interval of polls while the robot moves")
    reads_apart_s: float = Field(default=0.1, gt=0, le=1, description="time between two read-backs that must agree")
    reply_timeout_s: float = Field(default=0.6, gt=0, le=2, description="longest wait for one reply")
    loss_s: float = Field(default=1.2, gt=0, le=2, description="a robot that does not answer for so long is lost")
