"""The one demo that the whole suite may run: about a minute. Tests read its folder and never change it."""

from __future__ import annotations

import contextlib
import io
import json
import os
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from filelock import FileLock
from found_boards import found_once, keep_found, take_found

from measureapp.cli import main
from measureapp.project.folder import ProjectFolder
from measureapp.project.folder_lock import LOCK

ANSWER = "answer.json"
BOARDS = "boards"  # found in the demo's images
REQUEST = ("--part", "gypsum", "--resolution", "quarter", "--viewpoints", "6", "--seed", "1", "--rig", "ideal")


@dataclass(frozen=True)
class Demo:
    """A finished demo: its folder, its exit code and the one JSON document it printed."""

    folder: Path
    code: int
    document: dict[str, Any]
    messages: str

    @property
    def boards(self) -> Path:
        """The file with what was found in its images of the board."""
        return self.folder.parent / BOARDS

    @property
    def project(self) -> ProjectFolder:
        """The project, opened anew."""
        return ProjectFolder.open(self.folder)


@contextlib.contextmanager
def shared_demo(folder: Path, user: str) -> Iterator[Demo]:
    """Share one demo between the processes of a run: the first to ask runs it while the others wait, the last to leave removes it."""
    users = folder / "users"
    users.mkdir(parents=True, exist_ok=True)
    lock = FileLock(folder / "lock")
    with lock:
        if not (folder / ANSWER).exists():
            _run(folder)
        else:
            take_found(folder / BOARDS)
        (users / user).touch()
    answer = json.loads((folder / ANSWER).read_text(encoding="utf-8"))
    yield Demo(folder / "project", **answer)
    with lock:
        (users / user).unlink()
        if not any(users.iterdir()):
            (folder / ANSWER).unlink()
            shutil.rmtree(folder / "project")


def linked_copy(project: Path, place: Path) -> Path:
    """Copy a project by links, so that its files are replaced and never written into; its journal, which is, becomes one of the copy."""

    def link(source: str, target: str) -> None:
        if Path(source).name.startswith("journal."):
            shutil.copyfile(source, target)
        else:
            os.link(source, target)

    unfit = shutil.ignore_patterns("journal.sqlite-*", ".journal.lock", ".lock*")  # of programs that read it just now
    return Path(shutil.copytree(project, place, copy_function=link, ignore=unfit))


def _run(folder: Path) -> None:
    """Run it by the command line: gypsum, quarter resolution, six views; keep what it answered."""
    out, err = io.StringIO(), io.StringIO()
    shutil.rmtree(folder / "project", ignore_errors=True)  # of one that failed
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), found_once():
        code = main(["demo", *REQUEST, "--out", str(folder / "project"), "--json"])
    keep_found(folder / BOARDS)
    answer = {"code": code, "document": json.loads(out.getvalue()), "messages": err.getvalue()}
    (folder / "project" / LOCK).unlink(missing_ok=True)  # copies made of links would all be locked by one
    (folder / ANSWER).write_text(json.dumps(answer), encoding="utf-8")
