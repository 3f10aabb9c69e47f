"""Answers of jobs on disk, so that a campaign that was ended early goes on where it stopped."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from measureapp.campaign.jobs import DemoJob, Finished, Job, ProcessJob
from measureapp.data.json_values import jsonable
from measureapp.project.atomic import write_json
from measureapp.project.folder import ProjectFolder
from measureapp.project.inputs import fingerprint

FOLDER = "answers"


class Answers:
    """The answers of a campaign: one JSON file for each job that has a result."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder / FOLDER
        self._requests: dict[str, Any] = {}

    def of(self, jobs: Sequence[Job]) -> dict[str, Finished]:
        """Return the answers that are stored, by the name of the job; one of another version of the program, of
        other settings or of other images is none.
        """
        self._requests = {job.name: _request(job) for job in jobs}
        found = {job.name: self._read(job) for job in jobs}
        return {name: one for name, one in found.items() if one is not None}

    def keep(self, finished: Finished) -> None:
        """Store an answer; a job without a result is done again next time."""
        if finished.problem:
            return
        self._folder.mkdir(parents=True, exist_ok=True)
        content = {
            "program": fingerprint(),
            "request": self._requests.get(finished.name),
            "passed": finished.passed,
            "seconds": finished.seconds,
            "document": finished.document,
        }
        write_json(self._path(finished.name), jsonable(content))

    def _read(self, job: Job) -> Finished | None:
        try:
            stored = json.loads(self._path(job.name).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None
        if not isinstance(stored, Mapping) or stored.get("program") != fingerprint() or stored.get("request") != self._requests[job.name]:
            return None
        if isinstance(job, ProcessJob) and ProjectFolder.open(job.folder).stale_results():
            return None
        return Finished(job.name, job.folder, bool(stored["passed"]), stored["document"], seconds=float(stored["seconds"]))

    def _path(self, name: str) -> Path:
        return self._folder / f"{name}.json"


def _request(job: Job) -> Any:
    """What the answer depends on, JSON-ready; the results of a project tell themselves what they were computed from."""
    return json.loads(json.dumps(jsonable(asdict(job.request)))) if isinstance(job, DemoJob) else str(job.folder)
