"""Compilation of the kernels in a process of its own.

The compiler holds the interpreter lock: in the process of the window it would hold up the window for half a second again and again, for
the minutes that compiling takes once per installation.
"""

from __future__ import annotations

import logging
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from measureapp.child_process import describe_exit, run_child
from measureapp.compiled.kernel_cache import lacks_compiled
from measureapp.progress import Progress

COMMAND = "from measureapp.pipeline.warm_up import warm_up; warm_up()"
PACKAGE = Path(__file__).resolve().parents[1]
KERNELS = (PACKAGE / "fringe" / "kernels", PACKAGE / "reconstruct" / "kernels")  # nearly all that is compiled
_log = logging.getLogger(__name__)


def compile_apart(progress: Progress) -> None:
    """Compile the kernels of the first measurement into the cache on disk, where it has none; else return at once.

    A process that fails is written to the log: the kernels are then compiled where they are used.
    """
    if not any(lacks_compiled(folder) for folder in KERNELS):
        return
    with TemporaryDirectory(prefix="measureapp-kernels-", ignore_cleanup_errors=True) as folder:
        log = Path(folder) / "log.txt"
        try:
            code = run_child([sys.executable, "-P", "-c", COMMAND], log, progress.check)
        except OSError as error:
            _log.warning("The kernels could not be compiled beside the window: %s", error)
            return
        if code != 0:
            _log.warning("The kernels could not be compiled beside the window: %s", describe_exit(code, log))
