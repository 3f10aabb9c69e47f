"""Settings of a camera that replays recorded images."""

from __future__ import annotations

import re
from typing import Literal

from pydantic import Field, field_validator

from measureapp.data.model import Model
from measureapp.devices.camera import Shutter


class FolderSettings(Model):
    """Which images are replayed, in which order, and how."""

    folder: str = Field(default=".", description="where the images are")
    files: str = Field(default="*.png", min_length=1, description="pattern of the names: * for any characters, ? for one")
    order: Literal["name", "number"] = Field(
        default="name", description="name: alphabetically; number: by the numbers in the name, 2 before 10"
    )
    exposure_in_name: str = Field(
        default="", description="regular expression with a group us or ms that finds the exposure in a name, such as _(?P<us>\\d+)us"
    )
    manifest: str = Field(default="", description="TOML file in the folder that lists images and exposures, in place of the three above")
    at_end: Literal["loop", "end"] = Field(
        default="loop", description="after the last image of an exposure: begin again, or refuse triggers"
    )
    at_arm: Literal["continue", "restart"] = Field(default="continue", description="a new sequence continues the recording, or restarts it")
    shutter: Shutter = Field(default="rolling", description="of the camera that recorded the images")
    readout_ms: float = Field(default=0.0, ge=0, description="duration of the read-out after each exposure")
    time_scale: float = Field(default=0.0, ge=0, description="1: exposures and read-outs last as long as in reality; 0: no waiting")

    @field_validator("exposure_in_name")
    @classmethod
    def _finds_an_exposure(cls, pattern: str) -> str:
        try:
            groups = re.compile(pattern).groupindex
        except re.error as error:
            raise ValueError(f"{pattern!r} is no regular expression: {error}") from error
        if pattern and not {"us", "ms"} & set(groups):
            raise ValueError(f"{pattern!r} has no group (?P<us>…) or (?P<ms>…)")
        return pattern


class ManifestImage(Model):
    """A table ``[[image]]`` of a manifest."""

    file: str = Field(min_length=1)
    exposure_us: int | None = Field(default=None, gt=0)


class Manifest(Model):
    """The images of a recording, in order."""

    image: tuple[ManifestImage, ...] = Field(min_length=1)
