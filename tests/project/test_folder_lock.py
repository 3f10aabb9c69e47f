"""Two windows or commands never change the same folder at once."""

from __future__ import annotations

import subprocess
import sys

import pytest

from measureapp.errors import StorageError
from measureapp.pipeline.run import process_project
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.folder_lock import holder_of, lock_folder
from measureapp.project.rig_file import read_rig

HOLDER = "import sys; from measureapp.project.folder_lock import holder_of, lock_folder\nwith lock_folder(sys.argv[1]):\n    print('held', flush=True); sys.stdin.read()"


@pytest.fixture
def project(tmp_path):
    return ProjectFolder.create(tmp_path / "part", ProjectSettings(name="part", part="gypsum", rig=read_rig("paper")))


def test_a_folder_that_is_held_is_refused_with_a_remedy_and_free_afterwards(tmp_path):
    with lock_folder(tmp_path):
        with pytest.raises(StorageError, match="in use by another") as refused, lock_folder(tmp_path):
            pass
        assert refused.value.hint.startswith("Wait until it has finished")
    with lock_folder(tmp_path):
        pass


def test_a_process_that_dies_gives_its_folder_free(tmp_path):
    holder = subprocess.Popen([sys.executable, "-c", HOLDER, str(tmp_path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    assert holder.stdout.readline().strip() == b"held"
    with pytest.raises(StorageError, match="in use"), lock_folder(tmp_path):
        pass
    holder.kill()
    holder.communicate()
    with lock_folder(tmp_path):
        pass


def test_a_folder_that_cannot_be_written_to_is_reported(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(StorageError, match="cannot be written to"), lock_folder(tmp_path / "file"):
        pass


def test_computing_again_is_refused_while_another_window_changes_the_project(project):
    with project.lock(), pytest.raises(StorageError, match="in use by another"):
        process_project(project, lambda _event: None, NoProgress())


def test_the_holder_of_a_folder_is_told_without_locking_it(tmp_path):
    assert holder_of(tmp_path) is None
    with lock_folder(tmp_path):
        assert holder_of(tmp_path).startswith("this program, user ")
    assert holder_of(tmp_path) is None
    with lock_folder(tmp_path):
        pass
