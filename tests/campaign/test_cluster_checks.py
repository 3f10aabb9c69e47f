"""What is wrong with a cluster is said before any work starts."""

from __future__ import annotations

import subprocess
import sys

import pytest

from measureapp.campaign.cluster import check_cluster, local_workers, threads_of_linear_algebra
from measureapp.errors import InputError, StorageError
from measureapp.project.inputs import fingerprint


class Workers:
    """Answers as a client of Dask does, for workers with one thing wrong."""

    def __init__(self, versions=None, blind=(), memory=8 * 2**30, threads="1"):
        self.versions, self.blind, self.memory, self.threads = versions or {}, blind, memory, threads
        self.names = ("tcp://one:1", "tcp://two:2")

    def run(self, question, *arguments, on_error):
        if question is fingerprint:
            return {name: self.versions.get(name, fingerprint()) for name in self.names}
        if question is threads_of_linear_algebra:
            return dict.fromkeys(self.names, self.threads)
        return {name: "" if name in self.blind else question(*arguments) for name in self.names}

    def scheduler_info(self, n_workers):
        return {"workers": {name: {"memory_limit": self.memory} for name in self.names}}


def test_workers_of_one_program_that_see_the_storage_pass_and_nothing_is_left_behind(tmp_path):
    check_cluster(Workers(), [tmp_path], 2**30)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("workers", "kind", "words"),
    [
        (Workers(versions={"tcp://two:2": "0.0.9 (abc)"}), InputError, "tcp://two:2 has another version of the program: 0.0.9"),
        (Workers(versions={"tcp://two:2": ModuleNotFoundError("No module named 'measureapp'")}), InputError, "does not have this program"),
        (Workers(versions={"tcp://one:1": OSError("gone")}), InputError, "tcp://one:1 does not answer"),
        (Workers(blind=("tcp://two:2",)), StorageError, "cannot be seen by 1 of the workers, such as tcp://two:2"),
        (Workers(threads=""), InputError, "does its linear algebra in several threads"),
        (Workers(memory=2**29), InputError, "may use 0.5 GiB of memory, and a task needs about 1.0 GiB"),
    ],
)
def test_what_is_wrong_is_named(tmp_path, workers, kind, words):
    with pytest.raises(kind) as found:
        check_cluster(workers, [tmp_path], 2**30)
    assert words in found.value.message
    assert not list(tmp_path.iterdir())


def test_a_cluster_that_is_not_there_is_named(tmp_path):
    (tmp_path / "project.json").touch()
    code = "import sys; from measureapp.campaign import cluster; cluster.CONNECTED_WITHIN_S = 0.5; from measureapp.cli import main; sys.exit(main())"
    file = tmp_path / "campaign.toml"
    file.write_text('[demo]\nresolution = "quarter"\nviewpoints = 2\n', encoding="utf-8")
    command = [sys.executable, "-c", code, "campaign", str(file), "--cluster", "tcp://127.0.0.1:1"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)  # Dask keeps a thread of its own
    assert done.returncode == 2
    assert "No cluster answers at tcp://127.0.0.1:1. Start it with `dask scheduler`" in done.stderr


@pytest.mark.parametrize(("needed", "expected"), [(1.0, 4), (2.0, 3), (3.4, 2), (6.9, 1)])
def test_as_many_workers_as_memory_holds_at_most_one_per_processor(needed, expected):
    assert local_workers(4, round(needed * 2**30), 7 * 2**30) == expected


def test_where_memory_does_not_hold_one_task_nothing_starts():
    with pytest.raises(InputError, match=r"needs about 8\.0 GiB of memory, and 7\.0 GiB are available"):
        local_workers(4, 8 * 2**30, 7 * 2**30)
