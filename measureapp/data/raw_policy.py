"""What becomes of raw images after a scan: a word, which the command line reads before anything heavy is loaded."""

from __future__ import annotations

from typing import Literal

RawPolicy = Literal["keep", "compress", "drop"]
"""Kept as they are; compressed without loss; or removed once the cloud of their viewpoint is stored."""
