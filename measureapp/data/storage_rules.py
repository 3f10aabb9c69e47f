"""Rules of a project for its disk space."""

from __future__ import annotations

from typing import Literal

from measureapp.data.model import Model
from measureapp.data.raw_policy import RawPolicy


class StorageRules(Model):
    """Rules of a project for its disk space; may be changed at any time."""

    schema_version: Literal[1] = 1
    raw: RawPolicy = "keep"
