"""What users of buffers and options import stays light."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

LIGHT = ("buffer_pool", "kernel_cache", "options", "selection")


def test_buffers_options_and_selection_do_not_import_numba() -> None:
    code = f"import importlib, sys; [importlib.import_module('measureapp.compiled.' + n) for n in {LIGHT!r}]; print('numba' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=Path(__file__).parents[2], capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout.strip() == "False"
