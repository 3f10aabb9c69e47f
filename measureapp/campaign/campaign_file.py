"""Campaigns as TOML files: parts × rigs × seeds on the virtual rig, and projects to be processed."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from itertools import product
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, ValidationError, field_validator

from measureapp.campaign.jobs import DemoJob, Job, ProcessJob
from measureapp.data.model import Model, first_problem
from measureapp.data.pattern_sets import DEFAULT_NAME
from measureapp.data.rig import Resolution
from measureapp.demo import DemoRequest
from measureapp.errors import InputError
from measureapp.pipeline.project_names import unique_names
from measureapp.simulate.worlds import read_world

RANGE = re.compile(r"^\s*(\d+)\s*-\s*(\d+)\s*$")
EXAMPLE = 'State `projects = ["week/*"]`, or a table `[demo]` with parts, rigs and seeds, such as `seeds = "1-20"`.'


class DemoMatrix(Model):
    """Measurements on the virtual rig: every part on every rig with every seed."""

    parts: Annotated[tuple[str, ...], Field(min_length=1)] = ("gypsum",)
    rigs: Annotated[tuple[str, ...], Field(min_length=1)] = ("usual",)
    seeds: Annotated[tuple[int, ...], Field(min_length=1)] = (1,)
    resolution: Resolution = "half"
    viewpoints: Annotated[int, Field(ge=1)] | None = None
    patterns: str = DEFAULT_NAME

    @field_validator("rigs")
    @classmethod
    def _exist(cls, rigs: tuple[str, ...]) -> tuple[str, ...]:
        """Worlds are read before a campaign begins, so that a wrong name stops no job in the night."""
        for rig in rigs:
            try:
                read_world(rig)
            except InputError as error:
                raise ValueError(str(error)) from error
        return rigs

    @field_validator("seeds", mode="before")
    @classmethod
    def _unfold(cls, given: Any) -> Any:
        """A range in words, "1-20", is all seeds from the first to the last."""
        found = RANGE.match(given) if isinstance(given, str) else None
        return tuple(range(int(found[1]), int(found[2]) + 1)) if found else given

    def jobs(self, folder: Path) -> list[Job]:
        """Return the jobs, each with a project of its own in ``folder``."""
        found: list[Job] = []
        for part, rig, seed in product(self.parts, self.rigs, self.seeds):
            name = f"{Path(part).stem}-{Path(rig).stem}-{seed}"
            found.append(
                DemoJob(name, DemoRequest(folder / name, part, self.resolution, self.viewpoints, seed, self.patterns, conditions=rig))
            )
        return found


class Campaign(Model):
    """Content of a campaign file; paths are relative to it."""

    folder: Path = Path("campaign")  # where projects of the virtual rig and the answers are stored
    demo: DemoMatrix | None = None
    projects: tuple[str, ...] = ()  # folders to be processed; `*` and `?` stand for any name and any character


def read_campaign(path: Path) -> tuple[Path, list[Job]]:
    """Return the folder of the answers and the jobs of a campaign file.

    Raises
    ------
    InputError
        The file cannot be read, contains something unknown, or names no job.
    """
    try:
        given = Campaign.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", "Give a campaign file in TOML.") from error
    except UnicodeDecodeError as error:
        raise InputError(f"{path} is not a text.", "Give a campaign file in TOML.") from error
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path} is not valid TOML: {error}.", EXAMPLE) from error
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the file')}.", EXAMPLE) from error
    folder = (path.parent / given.folder).resolve()
    jobs = [] if given.demo is None else given.demo.jobs(folder)
    found: list[Path] = []
    for pattern in given.projects:
        there = sorted(one for one in _matching(path.parent, pattern) if (one / "project.json").is_file())
        if not there:
            raise InputError(f"{path}: no project lies at {pattern}.", "Give folders that contain a project.json, relative to the file.")
        found += there
    jobs += process_jobs(found)
    if not jobs:
        raise InputError(f"{path} names no job.", EXAMPLE)
    return folder, jobs


def process_jobs(folders: Sequence[Path]) -> list[Job]:
    """Return one job for each project folder. Raises InputError where one is named twice."""
    if not folders:
        return []
    names = unique_names(folders, "Name each project once.")
    return [ProcessJob(name, folder.resolve()) for name, folder in zip(names, folders, strict=True)]


def _matching(base: Path, pattern: str) -> list[Path]:
    """Return the paths that a pattern names, relative to a folder; an absolute one counts from its root."""
    wanted = Path(pattern)
    if not wanted.is_absolute():
        return list(base.glob(pattern))
    return list(Path(wanted.anchor).glob(str(wanted.relative_to(wanted.anchor))))
