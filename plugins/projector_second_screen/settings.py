"""Settings of a projector that is a screen of this computer."""

from __future__ import annotations

from pydantic import Field

from measureapp.data.model import Model


class SecondScreenSettings(Model):
    """Which screen the projector is, and how late it shows what it is sent. `python -m ui.second_screen list` prints the screens."""

    name: str = Field(default="", description="name of the screen, such as DP-2; empty: any")
    manufacturer: str = Field(default="", description="manufacturer of the screen; empty: any")
    model: str = Field(default="", description="model of the screen; empty: any")
    serial: str = Field(default="", description="serial number of the screen; empty: any")
    latency_s: float = Field(
        default=0.15, ge=0, le=2, description="from painting an image until it is lit for certain; `measureapp rig latency` measures it"
    )
    frame_us: int = Field(
        default=0, ge=0, le=1_000_000, description="duration over which the projector's grey levels are right; 0: one frame of the screen"
    )
    plain_level: int = Field(default=255, ge=1, le=255, description="grey level of uniform light")
    start_timeout_s: float = Field(default=15.0, gt=0, le=120, description="longest wait for the window to appear")
    reply_timeout_s: float = Field(default=2.0, gt=0, le=30, description="longest wait for the window to paint an image")
