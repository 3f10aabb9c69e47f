"""What becomes of raw images after a scan."""

from __future__ import annotations

from typing import Literal

from measureapp.data.model import Model

RawPolicy = Literal["keep", "compress", "drop"]
"""Kept as they are; compressed without loss; or removed once the cloud of their viewpoint is stored."""


class StorageRules(Model):
    """Rules of a project for its disk space; may be changed at any time."""

    schema_version: Literal[1] = 1
    raw: RawPolicy = "keep"
