"""Makes path-traced images for recordings; runs in the renderer's environment, never in that of the project.

PYTHON render.py RENDERER OUT [options of the renderer]: ``RENDERER`` is the program that renders a rig of three cameras. It is told to
expose also so briefly that fringes have a modulation of 5 to 15 grey levels, and to spread its rays evenly over a pixel.
"""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from typing import Any

BRIGHT_US = (100_000, 80_000, 60_000, 40_000, 20_000)
FAINT_US = (9000, 6000, 4000)


def main() -> None:
    """Render as the arguments say."""
    renderer = Path(sys.argv[1])
    spec = importlib.util.spec_from_file_location("renderer", renderer)
    assert spec is not None and spec.loader is not None
    module: Any = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    load = module.mi.load_dict

    def load_evenly(scene: dict[str, Any]) -> Any:
        if isinstance(scene.get("sampler"), dict):
            scene["sampler"]["type"] = "multijitter"
        return load(scene)

    module.mi.load_dict = load_evenly
    module.EXPOSURES = (*BRIGHT_US, *FAINT_US)
    sys.argv = [str(renderer), *sys.argv[2:], "--exposures", str(len(module.EXPOSURES))]
    module.main()


if __name__ == "__main__":
    main()
