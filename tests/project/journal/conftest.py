"""One project with a file of every kind, for all tests of this folder."""

from __future__ import annotations

import pytest

from measureapp.project.folder import ProjectFolder
from tests.project.journal.whole_project import whole_project


@pytest.fixture(scope="session")
def template(tmp_path_factory: pytest.TempPathFactory) -> ProjectFolder:
    """Copy it (`copied`); never change it."""
    return whole_project(tmp_path_factory.mktemp("whole") / "project")
