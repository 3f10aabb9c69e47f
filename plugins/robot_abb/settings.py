"""Settings of an ABB robot."""

from __future__ import annotations

from typing import Literal
from urllib.parse import urlsplit

from pydantic import Field, SecretStr, model_validator

from measureapp.data.model import Model

LOOPBACK = ("127.0.0.1", "localhost", "::1")
NAME = r"^[A-Za-z]\w{0,31}$"


class AbbSettings(Model):
    """How the controller is reached, and how its robot moves."""

    address: str = Field(
        default="http://192.168.125.1", pattern=r"^https?://[^/?#\s]+$", description="address with http:// or https://, without a path"
    )
    version: Literal["1.0", "2.0"] = Field(default="1.0", description="of Robot Web Services: 1.0 for RobotWare 6, 2.0 for RobotWare 7")
    user: str = Field(default="Default User", min_length=1, description="user of the controller")
    password: SecretStr = Field(default=SecretStr("robotics"), description="password of this user")
    certificate_sha256: str = Field(
        default="",
        pattern=r"^([0-9A-Fa-f]{2}:?){31}[0-9A-Fa-f]{2}$|^$",
        description="fingerprint of the controller's own certificate, for https; empty: one that this computer trusts",
    )
    system_id: str = Field(default="", description="ID of the controller's system; empty: any")
    task: str = Field(default="T_ROB1", pattern=NAME, description="RAPID task that runs MeasureApp.mod")
    module: str = Field(default="MeasureApp", pattern=NAME, description="name of this module")
    mechanical_unit: str = Field(default="ROB_1", pattern=NAME, description="mechanical unit of the arm")
    arm: str = Field(
        default="irb1200_7_07",
        min_length=1,
        description="kinematic model: a name in `resources/robots`, a TOML file of the same form, or a URDF with a link `tool0`",
    )
    speed_mm_per_s: float = Field(default=150.0, gt=0, le=250, description="speed of the flange")
    speed_deg_per_s: float = Field(default=30.0, gt=0, le=90, description="reorientation of the flange")
    joint_margin_deg: float = Field(default=2.0, ge=0, le=30, description="distance that every joint keeps from its limits")
    settle_s: float = Field(default=0.3, ge=0, le=10, description="wait at the goal, in the controller")
    rest_deg: float = Field(default=0.005, gt=0, le=0.1, description="at rest: two read-backs of every joint differ less")
    goal_deg: float = Field(default=0.02, gt=0, le=1, description="at the goal: every joint differs less")
    model_mm: float = Field(default=1.0, gt=0, description="largest difference of the controller's pose and the kinematic model's")
    switch_motors_on: bool = Field(default=True, description="switch the motors on at the first move; otherwise a person does")
    take_over: bool = Field(
        default=False, description="take the robot from a program on another computer that has ended without releasing it"
    )
    egm_port: int | None = Field(default=None, ge=1024, le=65535, description="UDP port of a pose stream (option 689-1); none: no stream")
    poll_s: float = Field(default=0.1, gt=0, le=1, description="interval of polls while the robot moves")
    reads_apart_s: float = Field(default=0.1, gt=0, le=1, description="time between two read-backs that must agree")
    reply_timeout_s: float = Field(default=0.6, gt=0, le=2, description="longest wait for one answer")
    loss_s: float = Field(default=1.2, gt=0, le=2, description="a controller that does not answer for so long is lost")
    login_patience_s: float = Field(default=10.0, ge=0, le=120, description="wait for a free session of the controller")

    @model_validator(mode="after")
    def _is_encrypted_where_it_must_be(self) -> AbbSettings:
        url = urlsplit(self.address)
        if self.version == "2.0" and url.scheme == "http" and url.hostname not in LOOPBACK:
            raise ValueError("address: Robot Web Services 2.0 use https, except on this computer")
        if self.version == "1.0" and url.scheme == "https":
            raise ValueError("address: Robot Web Services 1.0 use http")
        return self
