"""Runs of one program."""

from __future__ import annotations

from collections.abc import Callable
from hashlib import md5

import pytest

from measureapp.data.dimension import Verdict
from measureapp.data.identification import Identification
from measureapp.data.series import SeriesRun, SeriesValue


@pytest.fixture(scope="session")
def run() -> Callable[..., SeriesRun]:
    def make(number: int, verdict: Verdict = Verdict.PASS, *, serial: str | None = None, **fields: object) -> SeriesRun:
        value = SeriesValue(
            name="length", nominal=80, lower_tolerance=-0.1, upper_tolerance=0.1, measured=80.01 + 0.001 * number, uncertainty=0.03, verdict=verdict
        )  # fmt: skip
        return SeriesRun(
            **{
                "run_id": md5(f"{number} {fields}".encode(), usedforsecurity=False).hexdigest(),
                "program": "impeller 叶轮",
                "identification": Identification(serial_number=f"SN-{number:03d}" if serial is None else serial),
                "verdict": verdict,
                "values": (value,),
                "project": f"projects/{number}",
                "measured_at": f"2026-05-{1 + number % 28:02d}T10:20:30+00:00",
                **fields,
            }
        )

    return make
