"""One image of a camera with its caption; the level under the mouse is told in its place."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtWidgets import QSizePolicy, QStackedWidget, QVBoxLayout, QWidget

from ui.images.layers import frame_layer
from ui.images.map_view import MapView, Pixel
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.widgets.basic import ElidedLabel, label

if TYPE_CHECKING:
    from ui.charts.plotting import Plot
    from ui.look.theme import Theme

EDGE = 4  # px
SMALLEST, USUAL = QSize(144, 72), QSize(208, 156)


class CameraView(QWidget):
    """An image that is replaced as often as the camera takes one: zoom and the level under the mouse stay; or words where there is none."""

    def __init__(self, look: Look, caption: str = "", *, over: Callable[[Plot, Theme], None] | None = None) -> None:
        """``over`` draws on top of the image, in its pixels."""
        super().__init__()
        self.setObjectName("sunken")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.map = MapView(look, axes=False, over=over)
        self.map.setMinimumSize(0, 0)
        self.map.pointed.connect(self._point_at)
        self.map.setToolTip(tr("The wheel zooms, dragging moves the image, a double click shows all of it."))
        self.empty = label("", "soft", wrap=True)
        self.empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.shown = QStackedWidget()
        self.shown.addWidget(self.empty)
        self.shown.addWidget(self.map)
        self.words = ElidedLabel("", "small")
        self.caption = ""
        self._under: Pixel | None = None
        layout = QVBoxLayout()
        layout.setContentsMargins(EDGE, EDGE, EDGE, EDGE)
        layout.setSpacing(EDGE)
        layout.addWidget(self.shown, 1)
        layout.addWidget(self.words)
        self.setLayout(layout)
        self.setMinimumSize(SMALLEST)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._say(caption)

    def sizeHint(self) -> QSize:
        """Return the default size."""
        return USUAL

    @property
    def is_empty(self) -> bool:
        """Whether there is no image."""
        return self.map.is_empty

    def show_image(self, pixels: np.ndarray, caption: str, saturation: int | None = None) -> None:
        """Show an image (H, W) of 8 or 16 bits, its pixels that reach ``saturation`` in red."""
        self.map.show_layer(frame_layer(pixels), saturation)
        self.shown.setCurrentWidget(self.map)
        self._say(caption)

    def clear(self, words: str = "") -> None:
        """Show a text instead of an image."""
        self.map.clear()
        self._under = None
        self.empty.setText(translated(words))
        self.shown.setCurrentWidget(self.empty)
        self._say("")

    def leaveEvent(self, event: QEvent) -> None:
        """Tell the caption again."""
        super().leaveEvent(event)
        self._under = None
        self.map.choose(None)
        self._say(self.caption)

    def _point_at(self, row: int, column: int) -> None:
        self._under = row, column
        self._say(self.caption)

    def _say(self, caption: str) -> None:
        """Write the caption, or the level of the pixel under the mouse."""
        self.caption = caption
        layer, under = self.map.layer, self._under
        if layer is not None and under is not None and under[0] < layer.values.shape[0] and under[1] < layer.values.shape[1]:
            level = layer.words_at(*under)
            self.words.set_words(tr("Row {row}, column {column}: {level}", row=under[0], column=under[1], level=level))
        else:
            self.words.set_words(caption)
