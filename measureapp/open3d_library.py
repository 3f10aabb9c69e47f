"""Open3D without its viewers, which the program never shows."""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Any

VIEWERS = "open3d.visualization"
TRIALS = 20  # its first lines go through all modules, which fails while another thread imports one


def open3d() -> Any:
    """Return the library, imported at the first call.

    Its viewers would import a web server with all that this needs, which takes half of the time of the import. An empty module stands in
    for them, unless another program of this process has imported Open3D before.
    """
    if "open3d" not in sys.modules:
        sys.modules.setdefault(VIEWERS, ModuleType(VIEWERS))
    for _ in range(TRIALS - 1):
        try:
            return _imported()
        except RuntimeError as error:
            if "changed size" not in str(error):
                raise
    return _imported()


def _imported() -> Any:
    import open3d as library

    return library
