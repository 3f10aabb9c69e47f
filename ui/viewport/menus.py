"""Context menus of the 3-D view and of its legend, and the field for a number typed into the legend."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QLocale, QPoint, Qt
from PySide6.QtWidgets import QLineEdit, QMenu, QWidget

from ui.look.language.words import tr, translated
from ui.look.wording import MINUS
from ui.viewport.overlay.legend import Legend
from ui.viewport.overlay.legend_edits import STEP_CHOICES, Handle, reset, swapped, symmetric, value_of, with_value
from ui.viewport.overlay.legend_layout import digits_of

if TYPE_CHECKING:
    from measureapp.data.deviation_scale import RampName
    from ui.viewport.cloud_view import CloudView
    from ui.viewport.pick import Pick

VIEW_WORDS = {
    "front": "Front",
    "back": "Rear",
    "left": "Left",
    "right": "Right",
    "top": "Top",
    "bottom": "Bottom",
    "isometric": "Isometric",
}
FIELD_WIDTH = 96
RAMP_WORDS: dict[RampName, str] = {
    "blue-white-red": "Blue – white – red",
    "rainbow": "Rainbow with green band",
    "colour-blind-safe": "Colour-blind-safe",
}


def view_menu(view: CloudView, pick: Pick | None, legend: Legend | None = None) -> QMenu:
    """Return the context menu of a view, to which pages add their own actions; without a ``pick`` that of the whole view.

    ``legend``: whose menu it contains, if it can be edited.
    """
    menu, stage = QMenu(view), view.stage
    assert stage is not None
    _add(menu, "Show everything", view.fit, "F")
    views = menu.addMenu(tr("Standard views"))
    for place, (name, words) in enumerate(VIEW_WORDS.items(), 1):
        _add(views, words, lambda chosen=name: view.look_from(chosen), str(place))  # type: ignore[misc]
    if pick is not None:
        centre = _add(menu, "Rotate about this place", lambda: stage.set_centre(pick))
        centre.setEnabled(pick.position_mm is not None)  # type: ignore[attr-defined]
    menu.addSeparator()
    scene, furniture = stage.scene, stage.furniture
    _check(menu, "Parallel projection", scene.camera.is_parallel, view.toggle_parallel, "P")
    _check(menu, "Edges", scene.has_edges, view.toggle_edges, "E")
    _check(menu, "Transparent surface", scene.is_transparent, view.toggle_transparent, "T")
    _check(menu, "Labels", furniture.has_flags, view.toggle_labels, "L")
    _check(menu, "Axes, cube, scale and legend", furniture.is_visible, view.toggle_furniture, "H")
    _check(menu, "Clip box", scene.clip is not None and scene.clip.is_on, view.clipAsked.emit, "X")
    menu.addSeparator()
    _add(menu, "Copy picture", view.copy_picture, "Ctrl+Shift+C")
    _add(menu, "Save picture for print…", lambda: view.save_picture("white"))
    _add(menu, "Save picture without background…", lambda: view.save_picture("transparent"))
    if legend is not None and legend.editable:
        scale = legend_menu(menu, legend, stage.edit_legend)
        scale.setTitle(tr("Colour scale"))
        menu.addMenu(scale)
    return menu


def legend_menu(parent: QWidget, legend: Legend, edit: Callable[[Legend], None]) -> QMenu:
    """Return the context menu of a legend."""
    menu = QMenu(parent)
    _add(menu, "Symmetric range", lambda: edit(symmetric(legend)))
    steps = menu.addMenu(tr("Steps"))
    for count in STEP_CHOICES:
        words = "Continuous" if count == 0 else str(count)
        _check(steps, words, legend.steps == count, lambda chosen=count: edit(replace(legend, steps=chosen)))  # type: ignore[misc]
    if legend.ramp != "growing":
        colours = menu.addMenu(tr("Colours"))
        for name, words in RAMP_WORDS.items():
            _check(colours, words, legend.ramp == name, lambda chosen=name: edit(replace(legend, ramp=chosen)))  # type: ignore[misc]
        go = _check(menu, "Go / no-go", legend.go_no_go, lambda: edit(replace(legend, go_no_go=not legend.go_no_go)))
        go.setEnabled(legend.tolerance is not None)  # type: ignore[attr-defined]
    _check(menu, "Swap colours", legend.swapped, lambda: edit(swapped(legend)))
    menu.addSeparator()
    _add(menu, "Reset", lambda: edit(reset(legend)))
    return menu


def _add(menu: QMenu, words: str, action: Callable[[], object], key: str = "") -> object:
    made = menu.addAction(f"{translated(words)}\t{key}" if key else translated(words))
    made.triggered.connect(lambda _checked=False: action())
    return made


def _check(menu: QMenu, words: str, checked: bool, action: Callable[[], object], key: str = "") -> object:
    made = menu.addAction(f"{translated(words)}\t{key}" if key else translated(words))
    made.setCheckable(True)
    made.setChecked(checked)
    made.triggered.connect(lambda _checked=False: action())
    return made


def parse_number(words: str) -> float | None:
    """Read a number with point or comma and any minus sign; None if it is none.

    >>> parse_number("−0,25"), parse_number("+0.1"), parse_number("1,000.5"), parse_number("wide")
    (-0.25, 0.1, None, None)
    """
    plain = words.strip().replace(MINUS, "-").removesuffix("mm").strip()
    if "," in plain and "." in plain:
        return None
    value, fine = QLocale.c().toDouble(plain.replace(",", ".").lstrip("+"))
    return value if fine else None


class NumberPopup(QLineEdit):
    """A field over the picture for one number of the legend; Enter takes it, Escape or a click elsewhere does not."""

    def __init__(self, parent: QWidget, legend: Legend, handle: Handle, edit: Callable[[Legend], None]) -> None:
        super().__init__(parent)
        self.setWindowFlags(Qt.WindowType.Popup)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setFixedWidth(FIELD_WIDTH)
        self.setAccessibleName(tr("Value of the legend"))
        self._legend, self._handle, self._edit = legend, handle, edit
        self.setText(f"{value_of(legend, handle):.{max(3, digits_of(legend))}f}")
        self.selectAll()
        self.returnPressed.connect(self._take)

    def open_at(self, place: QPoint) -> None:
        """Show the field at a place of the screen."""
        self.move(place)
        self.show()
        self.setFocus()

    def _take(self) -> None:
        value = parse_number(self.text())
        if value is not None:
            self._edit(with_value(self._legend, self._handle, value))
        self.close()
