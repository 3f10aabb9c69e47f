"""Keys of the 3-D view; they act only while it has the focus."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence, QShortcut

if TYPE_CHECKING:
    from collections.abc import Callable

    from ui.viewport.cloud_view import CloudView

STEP_RAD = 0.2617993877991494  # 15°
PAN_FRACTION, ZOOM = 0.08, 1.25
NUMBERED_VIEWS = ("front", "back", "left", "right", "top", "bottom", "isometric")
KEYS = (
    "F shows everything, Shift+F the selection, 1 to 7 the standard views. P changes the projection, E shows edges, T makes the "
    "surface transparent, L hides labels, H the furniture. Arrow keys rotate, with Shift they pan; plus and minus zoom. "
    "Enter picks the point in the centre."
)


def add_keys(view: CloudView) -> None:
    """Give a view its keys."""
    for keys, action in _actions(view):
        shortcut = QShortcut(QKeySequence(keys), view)
        shortcut.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        shortcut.activated.connect(action)


def _actions(view: CloudView) -> list[tuple[str, Callable[[], object]]]:
    turn, pan = view.turn, view.pan
    made: list[tuple[str, Callable[[], object]]] = [
        (str(place), lambda name=name: view.look_from(name))  # type: ignore[misc]
        for place, name in enumerate(NUMBERED_VIEWS, 1)
    ]
    return [
        *made,
        ("F", view.fit),
        ("Home", view.reset_camera),
        ("Shift+F", view.fit_selection),
        ("P", view.toggle_parallel),
        ("E", view.toggle_edges),
        ("T", view.toggle_transparent),
        ("L", view.toggle_labels),
        ("H", view.toggle_furniture),
        ("X", view.clipAsked.emit),
        ("C", view.sectionAsked.emit),
        ("Ctrl+Shift+C", view.copy_picture),
        ("Left", lambda: turn(-STEP_RAD, 0.0)),
        ("Right", lambda: turn(STEP_RAD, 0.0)),
        ("Up", lambda: turn(0.0, STEP_RAD)),
        ("Down", lambda: turn(0.0, -STEP_RAD)),
        ("Shift+Left", lambda: pan(-PAN_FRACTION, 0.0)),
        ("Shift+Right", lambda: pan(PAN_FRACTION, 0.0)),
        ("Shift+Up", lambda: pan(0.0, PAN_FRACTION)),
        ("Shift+Down", lambda: pan(0.0, -PAN_FRACTION)),
        ("+", lambda: view.zoom(ZOOM)),
        ("=", lambda: view.zoom(ZOOM)),
        ("-", lambda: view.zoom(1.0 / ZOOM)),
        ("Return", view.pick_centre),
        ("Enter", view.pick_centre),
    ]
