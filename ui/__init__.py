"""The Qt application: views, controllers, workers and the viewport."""

from __future__ import annotations

import importlib
import sys

FEATURES, SEARCH = "shibokensupport.feature", "_mod_uses_pyside"  # of Qt for Python


def _load_qt() -> None:
    """Load Qt for Python without its search through the source of every module that is imported afterwards.

    It looks for modules whose spellings it would translate (``from __feature__ import …``). The program uses none, and the search costs 70 MB and
    a fifth of a second of the start. Where a later version searches by another name, it searches again.
    """
    importlib.import_module("PySide6.QtCore")
    features = vars(sys.modules[FEATURES]) if FEATURES in sys.modules else {}
    if SEARCH in features:
        features[SEARCH] = lambda _module: True  # "without special spellings"


_load_qt()
