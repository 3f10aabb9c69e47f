"""What a campaign consists of, and what becomes of each job."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from measureapp.demo import DemoRequest
from measureapp.errors import MeasureError


@dataclass(frozen=True, slots=True)
class ProcessJob:
    """A project to be computed anew from its stored images."""

    name: str  # in answers, among all jobs
    folder: Path


@dataclass(frozen=True, slots=True)
class DemoJob:
    """A measurement on the virtual rig, compared with the truth."""

    name: str
    request: DemoRequest

    @property
    def folder(self) -> Path:
        """Folder of its project."""
        return self.request.folder


Job = ProcessJob | DemoJob


@dataclass(frozen=True, slots=True, eq=False)
class Finished:
    """The answer of a job: as of `process` or `demo`, or why there is none."""

    name: str
    folder: Path
    passed: bool
    document: Mapping[str, Any] = field(default_factory=dict)
    problem: str = ""  # message and remedy; empty where it was done
    seconds: float = 0.0  # from its start to its end, waiting included

    @classmethod
    def failed(cls, job: Job, error: Exception, seconds: float = 0.0) -> Finished:
        """Return the answer of a job that ended with an error."""
        words = str(error) if isinstance(error, MeasureError) else f"{type(error).__name__}: {error}"
        return cls(job.name, job.folder, False, problem=words, seconds=seconds)
