"""The one demo that the whole suite may run: about a minute. Tests read its folder and never change it."""

from __future__ import annotations

import contextlib
import io
import json
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from measureapp.cli import main
from measureapp.project.folder import ProjectFolder

REQUEST = ("--part", "gypsum", "--resolution", "quarter", "--viewpoints", "6", "--seed", "1")


@dataclass(frozen=True)
class Demo:
    """A finished demo: its folder, its exit code and the one JSON document it printed."""

    folder: Path
    code: int
    document: dict[str, Any]
    messages: str

    @property
    def project(self) -> ProjectFolder:
        """The project, opened anew."""
        return ProjectFolder.open(self.folder)


@contextlib.contextmanager
def finished_demo(folder: Path) -> Iterator[Demo]:
    """Run it by the command line: gypsum, quarter resolution, six views; removed at the end."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main(["demo", *REQUEST, "--out", str(folder), "--json"])
    yield Demo(folder, code, json.loads(out.getvalue()), err.getvalue())
    shutil.rmtree(folder)
