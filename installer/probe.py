"""Runs inside `.venv`: says what is installed and what is wrong with it, as one JSON document."""

from __future__ import annotations

import csv
import importlib
import importlib.metadata
import json
import sys
import sysconfig
from collections.abc import Iterator
from pathlib import Path

KEY_MODULES = ("numpy", "scipy.linalg", "cv2", "pydantic", "typer", "PySide6.QtWidgets", "vtkmodules.vtkRenderingOpenGL2", "measureapp")


def distributions() -> list[importlib.metadata.Distribution]:
    """Return what is installed in this environment alone."""
    folders = sorted({sysconfig.get_path("purelib"), sysconfig.get_path("platlib")})
    return list(importlib.metadata.distributions(path=folders))


def damaged_files(distribution: importlib.metadata.Distribution) -> Iterator[str]:
    """Name installed files that are gone or have another size than when they were installed."""
    for name, _, size in csv.reader((distribution.read_text("RECORD") or "").splitlines()):
        path = Path(str(distribution.locate_file(name)))
        if not size or name.endswith(".pyc"):
            continue
        if not path.is_file() or path.stat().st_size != int(size):
            yield str(path)


def import_troubles(checkout: Path) -> Iterator[str]:
    """Name key packages that cannot be imported, and a core that is not the one of this checkout."""
    for name in KEY_MODULES:
        try:
            importlib.import_module(name)
        except Exception as error:  # a broken package may raise anything
            yield f"{name}: {error}"
    core = sys.modules.get("measureapp")
    if core is not None and not Path(core.__file__ or "").resolve().is_relative_to(checkout):
        yield f"measureapp comes from {core.__file__}"


def main() -> None:
    """Print the inventory and the problems."""
    checkout = Path(__file__).resolve().parents[1]
    installed = distributions()
    inventory = sorted(f"{item.name}=={item.version}" for item in installed)
    problems = [path for item in installed for path in damaged_files(item)]
    problems = problems or list(import_troubles(checkout))
    json.dump({"inventory": inventory, "problems": problems}, sys.stdout)


if __name__ == "__main__":
    sys.path.pop(0)  # the folder of this file holds no package
    main()
