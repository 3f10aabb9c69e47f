"""Choice of one stored image: exposure and pattern."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QSlider, QWidget

from ui.look.language.words import tr, translated
from ui.look.wording import exposure
from ui.widgets.basic import label, row


class FrameBar(QWidget):
    """Two sliders; arrow keys move the one that has the focus."""

    valueChanged = Signal(object)  # (exposure, image), both from 0

    def __init__(self) -> None:
        super().__init__()
        self._times: tuple[int, ...] = ()
        self._sliders = {name: self._slider(name) for name in ("Exposure", "Image")}
        self._words = {name: label("", "body") for name in self._sliders}
        for words in self._words.values():
            words.setMinimumWidth(96)
        parts = [part for name, slider in self._sliders.items() for part in (label(name, "soft"), slider, self._words[name])]
        self.setLayout(row(*parts, spacing=8))

    def show_stack(self, exposures_us: Sequence[int], images: int) -> None:
        """Offer these exposures, and so many images of each; the present choice is kept where it exists."""
        self._times = tuple(exposures_us)
        for slider, count in zip(self._sliders.values(), (len(self._times), images), strict=True):
            slider.blockSignals(True)
            slider.setRange(0, max(0, count - 1))
            slider.blockSignals(False)
            slider.setEnabled(count > 1)
        self._write()

    def value(self) -> tuple[int, int]:
        """Return exposure and image, both from 0."""
        return self._sliders["Exposure"].value(), self._sliders["Image"].value()

    def setValue(self, value: tuple[int, int]) -> None:
        """Choose exposure and image."""
        for slider, place in zip(self._sliders.values(), value, strict=True):
            slider.setValue(place)

    @property
    def words(self) -> str:
        """Return the choice in words."""
        return tr("{text}, image {text_2}", text=self._words["Exposure"].text(), text_2=self._words["Image"].text())

    def _slider(self, name: str) -> QSlider:
        slider = QSlider(Qt.Orientation.Horizontal)
        slider.setAccessibleName(translated(name))
        slider.setPageStep(1)
        slider.valueChanged.connect(self._tell)
        return slider

    def _tell(self) -> None:
        self._write()
        self.valueChanged.emit(self.value())

    def _write(self) -> None:
        time, image = self.value()
        self._words["Exposure"].setText(exposure(self._times[time]) if self._times else "")
        self._words["Image"].setText(tr("{count} of {total}", count=image + 1, total=self._sliders["Image"].maximum() + 1))
