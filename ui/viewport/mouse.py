"""Mouse gestures of the 3-D view, the same in every window."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Literal

from PySide6.QtCore import QEvent, QObject, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QToolTip, QWidget

from ui.viewport.clip_box import ClipBox
from ui.viewport.overlay.handles import clip_handle_at, dragged_face
from ui.viewport.overlay.legend import Legend
from ui.viewport.overlay.legend_edits import Handle, dragged, scaled
from ui.viewport.pick import Pick
from ui.viewport.stage import Stage

CLICK_PX = 4.0
ZOOM_NOTCH, ZOOM_DRAG = 1.2, 3.0  # factors: of a notch of the wheel, of a drag over the height
NOTCH = 120
LEAST_BOX_PX = 8.0
Mode = Literal["", "press", "rotate", "pan", "zoom", "box", "legend", "flag", "clip", "overlay"]


class Mouse(QObject):
    """Watches the mouse on a widget: left drag rotates, Shift or middle pans, right or wheel zooms, Alt zooms to a box; clicks select."""

    def __init__(self, widget: QWidget, stage: Stage, pick: Callable[[QPointF], Pick]) -> None:
        super().__init__(widget)
        self._widget, self._stage, self._pick = widget, stage, pick
        self._mode: Mode = ""
        self._button = Qt.MouseButton.NoButton
        self._start = self._last = QPointF()
        self._handle: Handle | None = None
        self._legend: Legend | None = None  # at the start of the drag
        self._flag, self._grip = -1, QPointF()
        self._clip: tuple[ClipBox, int] | None = None
        widget.setMouseTracking(True)
        widget.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Handle mouse and wheel; all other events go on."""
        if isinstance(event, QWheelEvent):
            self._wheel(event)
            return True
        if not isinstance(event, QMouseEvent):
            if event.type() == QEvent.Type.Leave:
                self._hover("")
            return False
        kind = event.type()
        if kind == QEvent.Type.MouseButtonDblClick:
            self._double_click(event)
        elif kind == QEvent.Type.MouseButtonPress:
            self._press(event)
        elif kind == QEvent.Type.MouseMove:
            self._move(event)
        elif kind == QEvent.Type.MouseButtonRelease:
            self._release(event)
        return True

    def cancel(self) -> bool:
        """End a gesture without effect; False if there is none."""
        if self._mode in {"", "press"}:
            return False
        if self._mode == "legend" and self._legend is not None:
            self._stage.edit_legend(self._legend, done=False)
        if self._mode == "clip" and self._clip is not None:
            self._stage.set_clip(self._clip[0])
        self._stage.box_zoom = None
        self._mode = ""
        self._stage.end_move()
        self._stage.paintWanted.emit()
        return True

    def _press(self, event: QMouseEvent) -> None:
        if self._mode not in {"", "press"}:
            return
        self._start = self._last = event.position()
        self._button, self._mode = event.button(), "press"
        if event.button() == Qt.MouseButton.LeftButton:
            self._take(event.position())

    def _take(self, place: QPointF) -> None:
        """Take what is painted over the picture, if it can be dragged."""
        stage, camera = self._stage, self._stage.camera_view()
        part = stage.furniture.legend_part_at(place, camera, stage.style)
        if part is not None:
            self._mode = "overlay" if part == "legend" else "legend"
            self._handle, self._legend = (None if part == "legend" else part), stage.furniture.legend  # type: ignore[assignment]
            return
        flag = stage.furniture.flag_at(place, camera, stage.style)
        if flag is not None:
            left, top, width, height = stage.furniture.flag_places(camera, stage.style).boxes[flag]
            self._mode, self._flag, self._grip = "flag", flag, QPointF(left + width / 2, top + height / 2) - place
            return
        clip = stage.scene.clip
        if clip is not None and clip.is_on:
            face = clip_handle_at(place, camera, clip, stage.style)
            if face is not None:
                self._mode, self._clip = "clip", (clip, face)
                return
        if stage.furniture.face_at(place, camera, stage.style) or stage.furniture.collapsed_at(place, camera, stage.style):
            self._mode = "overlay"

    def _collapsed_words(self, place: QPointF) -> str:
        """Return a line for each flag that there is no room for, at the number that stands for them."""
        found = self._stage.furniture.collapsed_at(place, self._stage.camera_view(), self._stage.style)
        return "\n".join("  ".join(word for word in (one.sign, one.title, one.value) if word) for one in found)

    def _move(self, event: QMouseEvent) -> None:
        place = event.position()
        if event.buttons() == Qt.MouseButton.NoButton:
            self._hover(self._stage.furniture.face_at(place, self._stage.camera_view(), self._stage.style))
            self._widget.setToolTip(self._collapsed_words(place))
            return
        if self._mode == "" or (
            self._mode != "overlay" and not self._has_moved(place) and self._mode in {"press", "flag", "legend", "clip"}
        ):
            return
        if self._mode == "press":
            self._mode = self._drag_mode(event)
            self._last = self._start
        self._drag(place)
        self._last = place

    def _has_moved(self, place: QPointF) -> bool:
        return (place - self._start).manhattanLength() >= CLICK_PX or self._last != self._start

    def _drag_mode(self, event: QMouseEvent) -> Mode:
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        alt = bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
        if self._button == Qt.MouseButton.MiddleButton or (self._button == Qt.MouseButton.LeftButton and shift):
            return "pan"
        if self._button == Qt.MouseButton.RightButton:
            return "zoom"
        return "box" if alt else "rotate"

    def _drag(self, place: QPointF) -> None:
        stage, ratio = self._stage, self._ratio()
        step = (place - self._last) * ratio
        camera = stage.scene.camera
        if self._mode == "rotate":
            stage.steer(lambda: camera.drag(step.x(), -step.y()))
            stage.hold()
        elif self._mode == "pan":
            stage.steer(lambda: camera.pan(step.x(), -step.y()))
            stage.hold()
        elif self._mode == "zoom":
            factor = ZOOM_DRAG ** (-step.y() * 3.0 / camera.size_px[1])
            stage.steer(lambda: camera.zoom(factor, *self._device(self._start)))
            stage.hold()
        elif self._mode == "box":
            stage.box_zoom = (self._start, place)
            stage.paintWanted.emit()
        elif self._mode == "legend":
            self._drag_legend(place)
        elif self._mode == "flag":
            self._drag_flag(place)
        elif self._mode == "clip" and self._clip is not None:
            clip, face = self._clip
            stage.begin_move()
            stage.hold()
            stage.set_clip(dragged_face(clip, face, place - self._start, stage.camera_view()))

    def _drag_legend(self, place: QPointF) -> None:
        stage = self._stage
        layout = stage.furniture.legend_layout(stage.camera_view(), stage.style)
        if self._legend is not None and self._handle is not None and layout is not None:
            moved = dragged(self._legend, self._handle, self._start.y() - place.y(), layout.bar.height())
            stage.edit_legend(moved, done=False)

    def _drag_flag(self, place: QPointF) -> None:
        stage, middle = self._stage, place + self._grip
        flag = stage.furniture.flags[self._flag]
        fraction = (min(max(middle.x() / stage.width, 0.02), 0.98), min(max(middle.y() / stage.height, 0.02), 0.98))
        stage.furniture.pinned[flag.key] = fraction
        stage.furniture.forget_places()
        stage.paintWanted.emit()

    def _release(self, event: QMouseEvent) -> None:
        mode, place, moved = self._mode, event.position(), self._last != self._start
        if event.button() != self._button:
            return
        self._mode = ""
        stage = self._stage
        if mode == "press":
            self._click(event)
        elif mode == "box":
            self._zoom_to_box(place)
        elif mode == "legend" and moved and stage.furniture.legend is not None:
            stage.edit_legend(stage.furniture.legend)
        elif mode == "flag":
            flag = stage.furniture.flags[self._flag]
            if moved:
                stage.flagMoved.emit(flag.key, stage.furniture.pinned[flag.key])
            else:
                stage.flagChosen.emit(flag.key)
        elif mode == "clip" and stage.scene.clip is not None:
            stage.end_move()
            stage.clipChanged.emit(stage.scene.clip)
        elif mode == "overlay" and not moved:
            face = stage.furniture.face_at(place, stage.camera_view(), stage.style)
            if face:
                stage.look_from(face)
            elif words := self._collapsed_words(place):
                QToolTip.showText(event.globalPosition().toPoint(), words, self._widget)
        stage.end_move()

    def _click(self, event: QMouseEvent) -> None:
        place = event.position()
        if event.button() == Qt.MouseButton.RightButton:
            on_legend = self._stage.furniture.legend_part_at(place, self._stage.camera_view(), self._stage.style)
            if on_legend:
                self._stage.legendMenuAsked.emit(event.globalPosition().toPoint())
            else:
                self._stage.menuAsked.emit(self._pick(place), event.globalPosition().toPoint())
        elif event.button() == Qt.MouseButton.LeftButton:
            self._stage.clicked.emit(self._picked(event))

    def _picked(self, event: QMouseEvent) -> Pick:
        keys = event.modifiers()
        adds, removes = bool(keys & Qt.KeyboardModifier.ShiftModifier), bool(keys & Qt.KeyboardModifier.ControlModifier)
        return replace(self._pick(event.position()), adds=adds, removes=removes)

    def _double_click(self, event: QMouseEvent) -> None:
        stage, place = self._stage, event.position()
        part = stage.furniture.legend_part_at(place, stage.camera_view(), stage.style)
        if event.button() != Qt.MouseButton.LeftButton:
            self._press(event)
        elif part is not None:
            if part != "legend":
                self._stage.numberAsked.emit(part, event.globalPosition().toPoint())
        elif stage.furniture.flag_at(place, stage.camera_view(), stage.style) is None:
            stage.set_centre(self._pick(place))

    def _zoom_to_box(self, place: QPointF) -> None:
        stage = self._stage
        stage.box_zoom = None
        box = place - self._start
        if abs(box.x()) >= LEAST_BOX_PX and abs(box.y()) >= LEAST_BOX_PX:
            one, other = self._device(self._start), self._device(place)
            stage.steer(lambda: stage.scene.camera.zoom_to_box(one, other))
        else:
            stage.paintWanted.emit()

    def _wheel(self, event: QWheelEvent) -> None:
        stage, place = self._stage, event.position()
        notches = event.angleDelta().y() / NOTCH
        legend = stage.furniture.legend
        event.accept()
        if legend is not None and stage.furniture.legend_part_at(place, stage.camera_view(), stage.style):
            if legend.editable and notches:
                stage.edit_legend(scaled(legend, -1 if notches > 0 else 1))
        elif notches:
            stage.steer(lambda: stage.scene.camera.zoom(ZOOM_NOTCH**notches, *self._device(place)))

    def _hover(self, face: str) -> None:
        if face != self._stage.furniture.hovered:
            self._stage.furniture.hovered = face
            self._stage.paintWanted.emit()

    def _ratio(self) -> float:
        """Pixels of the camera per pixel of the widget; fewer while the camera moves on a slow computer."""
        return self._stage.scene.camera.size_px[1] / max(self._widget.height(), 1)

    def _device(self, place: QPointF) -> tuple[float, float]:
        """Return a place in the camera's pixels, from the lower left corner."""
        ratio = self._ratio()
        return place.x() * ratio, (self._widget.height() - place.y()) * ratio - 1.0
