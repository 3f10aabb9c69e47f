"""The 3-D widget; it shows a placeholder until VTK is loaded."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QPoint, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QGuiApplication, QImage, QShowEvent
from PySide6.QtWidgets import QLabel, QMenu, QStackedLayout, QWidget

from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.theme import Theme
from ui.settings.dialogs import choose_new
from ui.viewport.backend import NO_GRAPHICS, choose_backend, off_screen_window
from ui.viewport.keys import KEYS, add_keys
from ui.viewport.layers import CloudLayer, Label, LineLayer, SurfaceLayer
from ui.viewport.menus import NumberPopup, legend_menu, view_menu
from ui.viewport.overlay.flag import Flag
from ui.viewport.overlay.legend import Legend
from ui.viewport.overlay.style import OverlayStyle
from ui.viewport.pick import Pick
from ui.viewport.prepared_surface import PreparedSurface, prepare_surface
from ui.viewport.shuffled_cloud import ShuffledCloud, shuffle
from ui.viewport.standard_views import OPENING_DIRECTION, Direction
from ui.viewport.steered_view import SteeredView

if TYPE_CHECKING:
    from ui.viewport.native import NativeView
    from ui.viewport.off_screen import OffScreenView
    from ui.viewport.point_index import PointIndex
    from ui.viewport.print_picture import Background, PrintSize
    from ui.viewport.render_window import RenderWindow
    from ui.viewport.stage import Stage

PREPARING = "Preparing 3-D view…"
PREPARED_AFTER_MS = 20  # so that the window answers between making a page and loading the graphics driver


class CloudView(SteeredView):
    """Shows clouds, a surface and lines, with a legend, flags and labels over them.

    The mouse: left drag rotates, middle drag or Shift pans, the wheel and right drag zoom, Alt and drag zooms to a box, a double
    click sets the centre of rotation, a click picks. Keys: see `ui.viewport.keys`.
    """

    picked = Signal(object)  # Pick, of every click
    pointPicked = Signal(int, int)  # layer, index in the layer
    rayClicked = Signal(object, object)  # origin and direction, where a click hits no point
    legendEdited = Signal(object)  # Legend
    flagMoved = Signal(str, object)  # key, middle of its box as fractions of the picture
    flagChosen = Signal(str)
    clipChanged = Signal(object)  # ClipBox
    menuOpening = Signal(object, object)  # QMenu and Pick, so that pages can add actions
    becameLive = Signal()
    pictureFailed = Signal(str)  # file that could not be written

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._look = look
        self._view: OffScreenView | NativeView | None = None
        self._window: RenderWindow | None = None
        self._allowed = False
        self._clouds: tuple[CloudLayer, ...] = ()
        self._cloud = shuffle(())
        self._index: PointIndex | None = None
        self._surface: PreparedSurface | None = None
        self._proxy: PreparedSurface | None = None
        self._lines: tuple[LineLayer, ...] = ()
        self._labels: tuple[Label, ...] = ()
        self._flags: tuple[Flag, ...] = ()
        self._legend: Legend | None = None
        self._frame_name, self._chosen = "", ""
        self._framing: tuple[np.ndarray | None, Direction] | None = None
        self.corner: Callable[[], tuple[str, ...]] = lambda: ()  # words in the corner of printed pictures
        self._placeholder = QLabel(translated(PREPARING), alignment=Qt.AlignmentFlag.AlignCenter)
        self._placeholder.setWordWrap(True)
        self._stack = QStackedLayout(self)
        self._stack.addWidget(self._placeholder)
        self.setMinimumSize(280, 240)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("3-D view"))
        self.setAccessibleDescription(translated(KEYS))
        add_keys(self)
        look.changed.connect(self._apply_theme)

    @property
    def is_live(self) -> bool:
        """Whether the 3-D view draws."""
        return self._view is not None

    @property
    def legend(self) -> Legend | None:
        """The legend shown."""
        return self._legend

    def activate(self) -> None:
        """Enable drawing, when the widget is visible; VTK should have been imported, or the window waits for it."""
        self._allowed = True
        if self.isVisible():
            self._create()
        else:
            QTimer.singleShot(PREPARED_AFTER_MS, self, self._prepare)

    def hide_picture(self, instead: str = PREPARING) -> None:
        """Say that a picture is being prepared, in place of one that is of something else, or of nothing; `show_picture` ends it."""
        if self._view is not None:
            self._placeholder.setText(translated(instead))
            self._stack.setCurrentWidget(self._placeholder)

    def show_picture(self) -> None:
        """Show the picture again."""
        if self._view is not None:
            self._stack.setCurrentWidget(self._view)

    def explain(self, problem: str) -> None:
        """Show the reason for a missing 3-D view."""
        self._placeholder.setText(translated(problem))

    def set_clouds(self, layers: Sequence[CloudLayer], cloud: ShuffledCloud | None = None) -> None:
        """Show these clouds; ``cloud``: all of them, if they were shuffled already in a thread."""
        self._clouds = tuple(layers)
        self._cloud = shuffle(self._clouds) if cloud is None else cloud
        self._index, self._proxy = None, None
        if self.stage is not None:
            self.stage.scene.set_cloud(self._cloud)
            self._refresh()

    def set_index(self, index: PointIndex) -> None:
        """Use what was prepared for the clouds shown; ignored for others."""
        if index.cloud is self._cloud:
            self._index = index
            if self.stage is not None:
                self.stage.scene.set_index(index)

    def set_cloud_proxy(self, surface: PreparedSurface | None) -> None:
        """Show this surface in place of the clouds while the camera moves; None: a subsample of their points."""
        self._proxy = surface
        if self.stage is not None:
            self.stage.scene.set_cloud_proxy(surface)

    def set_surface(self, layer: SurfaceLayer | None, prepared: PreparedSurface | None = None) -> None:
        """Show this surface, or none; ``prepared``: the same, if it was prepared already in a thread."""
        self._surface = prepared if prepared is not None or layer is None else prepare_surface(layer)
        if self.stage is not None:
            self.stage.scene.set_surface(self._surface)
            self._refresh()

    def set_lines(self, layers: Sequence[LineLayer]) -> None:
        """Show these lines."""
        self._lines = tuple(layers)
        if self.stage is not None:
            self.stage.scene.set_lines(self._lines)
            self._refresh()

    def set_labels(self, labels: Sequence[Label]) -> None:
        """Show these short texts beside their points."""
        self._labels = tuple(labels)
        self._show_overlay()

    def set_flags(self, flags: Sequence[Flag], chosen: str = "") -> None:
        """Show these flags, the most important first; ``chosen``: key of the selected one."""
        self._flags, self._chosen = tuple(flags), chosen
        self._show_overlay()

    def set_legend(self, legend: Legend | None) -> None:
        """Show this legend, or none."""
        self._legend = legend
        self._show_overlay()

    def set_frame_name(self, name: str) -> None:
        """Show the name of the scene's frame beside its axes."""
        self._frame_name = name
        self._show_overlay()

    def reset_camera(self) -> None:
        """Show everything from the opening direction."""
        if self.stage is not None:
            self.stage.scene.camera.open_from(OPENING_DIRECTION if self._framing is None else self._framing[1])
            self._refresh()

    def frame(self, points_mm: np.ndarray | None, direction: Direction) -> None:
        """Open the camera on these points (N, 3), None: on everything, from a direction; a camera that was moved by hand stays."""
        self._framing = (points_mm, direction)
        if self.stage is not None:
            self.stage.scene.camera.framed_mm, self.stage.scene.camera.opening = self._framing
            self._refresh()

    def look_at(self, points_mm: np.ndarray) -> None:
        """Move the camera to these points (N, 3) without rotation."""
        if self.stage is not None and len(points_mm):
            self.stage.scene.look_at(np.asarray(points_mm, float))
            self._refresh()

    def screenshot(self) -> QImage:
        """Return the picture; empty while there is no 3-D view."""
        return QImage() if self._view is None else self._view.image()

    def print_picture(self, size: PrintSize) -> QImage:
        """Return the picture at print resolution, on white or without background; empty while there is no 3-D view."""
        from ui.viewport.print_picture import print_picture

        if self._view is None or self.stage is None:
            return QImage()
        style = OverlayStyle.of(Theme.load("light"))
        return print_picture(self.stage, self._view.render_window, size, style, self.corner())

    def save_picture(self, background: Background) -> None:
        """Ask for a file, and save the picture at print resolution."""
        from ui.viewport.print_picture import PrintSize

        file = choose_new(self, "Save picture", "picture.png", "pictures", "*.png")
        if file is not None:
            file = file if file.suffix.lower() == ".png" else file.with_name(f"{file.name}.png")
            if not self.print_picture(PrintSize(background=background)).save(str(file)):
                self.pictureFailed.emit(str(file))

    def copy_picture(self) -> None:
        """Copy the picture with its furniture to the clipboard."""
        picture = self.screenshot()
        if not picture.isNull():
            QGuiApplication.clipboard().setImage(picture)

    def cancel(self) -> bool:
        """End a gesture of the mouse without effect; False if there is none."""
        return self._view is not None and self._view.mouse is not None and self._view.mouse.cancel()

    def close_view(self) -> None:
        """Release the graphics memory and show the placeholder."""
        if self._view is not None:
            self._view.close_view()
            self._stack.removeWidget(self._view)
            self._view.deleteLater()
        if self.stage is not None:
            self.stage.deleteLater()
        if self._window is not None:
            self._window.leave(self)
        self._view, self.stage, self._window, self._allowed = None, None, None, False

    def showEvent(self, event: QShowEvent) -> None:
        """Create the 3-D view when it is first visible."""
        super().showEvent(event)
        if self._allowed:
            self._create()

    def pick_at(self, place: QPointF) -> Pick | None:
        """Return what is at a place of the widget; None before the view is live."""
        return None if self._view is None else self._view.pick(place)

    def pick_centre(self) -> None:
        """Pick what is in the middle of the picture."""
        self.take_pick(self.pick_at(QPointF(self.width() / 2.0, self.height() / 2.0)))

    def take_pick(self, pick: Pick | None) -> None:
        """Announce a pick."""
        if pick is None:
            return
        self.picked.emit(pick)
        if pick.is_point:
            self.pointPicked.emit(pick.layer, pick.index)
        else:
            self.rayClicked.emit(pick.ray_mm, pick.direction)

    def _prepare(self) -> None:
        """Load graphics driver and shaders in idle time, before the view is first visible; the first view does it for all."""
        if not self._allowed or self._window is not None:
            return
        from ui.viewport.preparation import Preparation
        from ui.viewport.render_window import shared_window

        is_first = shared_window(self) is None
        self._window = _render_window(self)
        if self._window is not None:
            self._window.join(self)
            if is_first:
                self._window.wait_for_view()
                Preparation(self._window)

    def _create(self) -> None:
        if self._view is not None:
            return
        from ui.viewport.stage import Stage

        self._window = self._window or _render_window(self)
        if self._window is None:
            self._allowed = False
            self.explain(NO_GRAPHICS)
            return
        self._window.join(self)
        stage = Stage(OverlayStyle.of(self._look.theme), self)
        view = _new_view(stage, self._window)
        self.stage, self._view = stage, view
        stage.clicked.connect(self.take_pick)
        stage.menuAsked.connect(self._open_menu)
        stage.legendMenuAsked.connect(self._open_legend_menu)
        stage.numberAsked.connect(self._type_number)
        stage.legendEdited.connect(self._take_legend)
        stage.flagMoved.connect(self.flagMoved)
        stage.flagChosen.connect(self.flagChosen)
        stage.clipChanged.connect(self.clipChanged)
        self._fill(stage)
        self._stack.addWidget(view)
        self._stack.setCurrentWidget(view)
        self._refresh()
        self.becameLive.emit()

    def _fill(self, stage: Stage) -> None:
        scene = stage.scene
        if self._framing is not None:
            scene.camera.framed_mm, scene.camera.opening = self._framing
        scene.set_cloud(self._cloud)
        if self._index is not None:
            scene.set_index(self._index)
        scene.set_cloud_proxy(self._proxy)
        scene.set_surface(self._surface)
        scene.set_lines(self._lines)
        self._apply_theme()
        self._show_overlay()

    def _take_legend(self, legend: Legend) -> None:
        self._legend = legend
        self.legendEdited.emit(legend)

    def offered_menu(self) -> QMenu | None:
        """Return the entries that need no place in the picture; None before there is one."""
        return None if self.stage is None else view_menu(self, None, self._legend)

    def _open_menu(self, pick: Pick, place: QPoint) -> None:
        menu = view_menu(self, pick)
        self.menuOpening.emit(menu, pick)
        self._open(menu, place)

    def _open_legend_menu(self, place: QPoint) -> None:
        if self._legend is not None and self._legend.editable and self.stage is not None:
            self._open(legend_menu(self, self._legend, self.stage.edit_legend), place)

    def _open(self, menu: QMenu, place: QPoint) -> None:
        menu.aboutToHide.connect(menu.deleteLater)
        menu.popup(place)

    def _type_number(self, handle: str, place: QPoint) -> None:
        if self._legend is not None and self.stage is not None:
            NumberPopup(self, self._legend, handle, self.stage.edit_legend).open_at(place)  # type: ignore[arg-type]

    def _show_overlay(self) -> None:
        if self.stage is None:
            return
        furniture = self.stage.furniture
        legend_came = (furniture.legend is None) != (self._legend is None)
        furniture.legend, furniture.flags, furniture.labels = self._legend, self._flags, self._labels
        furniture.frame, furniture.chosen = self._frame_name, self._chosen
        furniture.forget_places()
        self.stage.picture_ready()
        if legend_came:
            self._refresh()  # the room for the part has changed
        else:
            self.stage.paintWanted.emit()

    def _apply_theme(self) -> None:
        if self.stage is not None:
            theme = self._look.theme
            self.stage.scene.set_background(_rgb(theme.colour("viewport_top")), _rgb(theme.colour("viewport_bottom")))
            self.stage.set_style(OverlayStyle.of(theme))
            self._refresh()

    def _refresh(self) -> None:
        if self.stage is not None:
            self.stage.refreshWanted.emit()


def _render_window(owner: CloudView) -> RenderWindow | None:
    """Return the render window that all views of the same top-level window share; None without graphics."""
    from ui.viewport.render_window import RenderWindow, shared_window

    shared = shared_window(owner)
    if shared is not None:
        return shared
    if choose_backend() == "native":
        from ui.viewport.native import NativeWindow

        return NativeWindow(owner.window())
    window = off_screen_window()
    return None if window is None else RenderWindow(window, owner.window())


def _new_view(stage: Stage, window: RenderWindow) -> OffScreenView | NativeView:
    if choose_backend() == "native":
        from ui.viewport.native import NativeView, NativeWindow

        assert isinstance(window, NativeWindow)
        return NativeView(stage, window)
    from ui.viewport.off_screen import OffScreenView

    return OffScreenView(stage, window)


def _rgb(colour: QColor) -> tuple[float, float, float]:
    return colour.redF(), colour.greenF(), colour.blueF()
