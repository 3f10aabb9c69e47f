"""A cluster of Dask distributed: on this computer, or at an address; checked before any work starts.

M. Rocklin, Dask: parallel computation with blocked algorithms and task scheduling, Proc. 14th Python in Science Conference, 2015.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any
from uuid import uuid4

from measureapp.errors import InputError, StorageError
from measureapp.memory import GIB, available_bytes
from measureapp.progress import NoProgress, Progress
from measureapp.project.inputs import fingerprint

if TYPE_CHECKING:
    from distributed import Client

LOCAL = "local"
CONNECTED_WITHIN_S = 10.0
ANSWERED_WITHIN_S = 60.0  # importing the program, on a slow disk
FIRST_WORKER_WITHIN_S = 60.0
WORKER_ENVIRONMENT = {
    "OMP_NUM_THREADS": 1,
    "OPENBLAS_NUM_THREADS": 1,
}  # Dask's own also gives every array's memory back at once: twice the system time
EXTRA = "Install it with: pip install 'measureapp[cluster]'."


@contextmanager
def connected_cluster(address: str, needed_bytes: int, progress: Progress = NoProgress()) -> Iterator[Client]:  # noqa: B008 - stateless
    """Connect to the scheduler at ``address``, or start processes on this computer for "local": one per processor, if their memory suffices.

    Parameters
    ----------
    needed_bytes : memory of the largest task
    progress : told where memory allows fewer processes than there are processors

    Raises
    ------
    InputError
        Dask distributed is not installed, nothing answers, there is no worker, or the memory does not hold one task.
    """
    try:
        import dask
        import distributed
    except ImportError as error:
        raise InputError("Dask distributed is not installed.", EXTRA) from error
    if address == LOCAL:
        processors, available = processor_count(), available_bytes()
        count = local_workers(processors, needed_bytes, available)
        if count < processors:
            progress.report(0, 1, f"{count} of {processors} processors: a task needs {_gib(needed_bytes)}, {_gib(available)} are available")
        with (
            dask.config.set({"distributed.nanny.pre-spawn-environ": WORKER_ENVIRONMENT}),
            distributed.LocalCluster(
                n_workers=count, threads_per_worker=1, memory_limit=available // count, dashboard_address=None
            ) as cluster,
            distributed.Client(cluster) as client,
        ):
            yield client
        return
    try:
        client = distributed.Client(address, timeout=CONNECTED_WITHIN_S)
    except (OSError, ValueError) as error:
        raise InputError(
            f"No cluster answers at {address}.", "Start it with `dask scheduler` and `dask worker ADDRESS`, or use `--cluster local`."
        ) from error
    with client:
        try:
            client.wait_for_workers(1, timeout=FIRST_WORKER_WITHIN_S)
        except TimeoutError as error:
            raise InputError(f"The cluster at {address} has no worker.", f"Start some with: dask worker {address}") from error
        yield client


def processor_count() -> int:
    """Return how many processors this program may use."""
    return max(1, len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1)


def local_workers(processors: int, needed_bytes: int, available: int) -> int:
    """Return how many processes the memory allows, at most one per processor. Raises InputError where it does not hold one task."""
    if needed_bytes > available:
        raise InputError(
            f"A task needs about {_gib(needed_bytes)} of memory, and {_gib(available)} are available.",
            "Close other programs, raise the memory limit of the container, or use a computer with more memory.",
        )
    return min(processors, available // needed_bytes)


def _gib(size: int) -> str:
    return f"{size / GIB:.1f} GiB"


def check_cluster(client: Client, folders: Sequence[Path], needed_bytes: int) -> None:
    """Check that all workers have the same program, see the storage and have enough memory; nothing was begun yet.

    Parameters
    ----------
    folders : must be the same storage for all, under the same paths
    needed_bytes : memory of the largest task

    Raises
    ------
    InputError
        A worker has another version, several threads for linear algebra, or too little memory.
    StorageError
        A worker does not see a folder.
    """
    ours = fingerprint()
    for worker, theirs in _ask(client, fingerprint).items():
        if theirs != ours:
            raise InputError(
                f"The worker {worker} has another version of the program: {theirs}; this is {ours}.", "Install the same one everywhere."
            )
    for worker, threads in _ask(client, threads_of_linear_algebra).items():
        if threads != "1":
            raise InputError(
                f"The worker {worker} does its linear algebra in several threads, which changes the last digits of results.",
                "Start it with OPENBLAS_NUM_THREADS=1 in its environment.",
            )
    limits = {name: about.get("memory_limit") for name, about in client.scheduler_info(n_workers=-1)["workers"].items()}
    for worker, limit in limits.items():
        if limit and limit < needed_bytes:
            raise InputError(
                f"The worker {worker} may use {limit / 2**30:.1f} GiB of memory, and a task needs about {needed_bytes / 2**30:.1f} GiB.",
                "Start fewer workers on it, or give them more: dask worker --memory-limit.",
            )
    for folder in dict.fromkeys(folders):
        _check_storage(client, folder)


def _check_storage(client: Client, folder: Path) -> None:
    """Let every worker read what was written just now. Raises StorageError."""
    mark, token = folder / f".seen-by-workers-{uuid4().hex}", uuid4().hex
    try:
        folder.mkdir(parents=True, exist_ok=True)
        mark.write_text(token, encoding="ascii")
    except OSError as error:
        raise StorageError(f"{folder} cannot be written to: {error.strerror or error}.", "Check the permissions and the disk.") from error
    try:
        blind = [worker for worker, seen in _ask(client, read_mark, str(mark)).items() if seen != token]
    finally:
        mark.unlink(missing_ok=True)
    if blind:
        raise StorageError(
            f"The folder {folder} cannot be seen by {len(blind)} of the workers, such as {blind[0]}.",
            "Use a storage that all computers mount under the same path.",
        )


def threads_of_linear_algebra() -> str:
    """Return in how many threads a process does its linear algebra, as it was told; empty where it was not."""
    return os.environ.get("OPENBLAS_NUM_THREADS") or os.environ.get("OMP_NUM_THREADS", "")


def read_mark(path: str) -> str:
    """Return the content of a file, as a worker sees it; empty where there is none."""
    try:
        return Path(path).read_text(encoding="ascii")
    except OSError:
        return ""


def _ask(client: Client, question: Any, *arguments: Any) -> Mapping[str, Any]:
    """Return the answer of every worker, by its address. Raises InputError where one cannot answer."""
    answers: dict[str, Any] = client.run(question, *arguments, on_error="return")
    for worker, answer in answers.items():
        if isinstance(answer, ImportError):
            raise InputError(f"The worker {worker} does not have this program: {answer}.", "Install the same version everywhere.")
        if isinstance(answer, BaseException):
            raise InputError(f"The worker {worker} does not answer: {answer}.", "Read its log, and start it again.")
    return answers
