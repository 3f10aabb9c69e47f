"""Open3D without its viewers, which the program never shows."""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Any

VIEWERS = "open3d.visualization"


def open3d() -> Any:
    """Return the library, imported at the first call.

    Its viewers would import a web server with all that this needs, which takes half of the time of the import. An empty module stands in
    for them, unless another program of this process has imported Open3D before.
    """
    if "open3d" not in sys.modules:
        sys.modules.setdefault(VIEWERS, ModuleType(VIEWERS))
    import open3d as library

    return library
