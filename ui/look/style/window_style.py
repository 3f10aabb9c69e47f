"""The style of the window: Fusion, with all controls drawn in the colours of the theme."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QRect, QSize
from PySide6.QtGui import QPainter, QPalette
from PySide6.QtWidgets import (
    QProxyStyle,
    QStyle,
    QStyleHintReturn,
    QStyleOption,
    QStyleOptionComplex,
    QStyleOptionViewItem,
    QWidget,
)

from ui.look.style import buttons, fields, frames, views
from ui.look.style.dressing import dress
from ui.look.style.ink import Ink
from ui.look.theme import Theme

NAME = "measureapp"
Draw = Callable[[Ink, QStyleOption, QPainter, QWidget | None], None]
Control, Complex, Primitive, Element = QStyle.ControlElement, QStyle.ComplexControl, QStyle.PrimitiveElement, QStyle.SubElement
Contents, Metric, Hint = QStyle.ContentsType, QStyle.PixelMetric, QStyle.StyleHint
CONTROLS: dict[QStyle.ControlElement, Draw] = {
    Control.CE_ShapedFrame: frames.draw_frame,
    Control.CE_PushButton: buttons.draw_button,
    Control.CE_HeaderSection: views.draw_header_section,
    Control.CE_HeaderEmptyArea: views.draw_header_section,
    Control.CE_HeaderLabel: views.draw_header_label,
    Control.CE_ProgressBarGroove: views.draw_progress_groove,
    Control.CE_ProgressBarContents: views.draw_progress,
    Control.CE_Splitter: views.draw_splitter,
    Control.CE_MenuItem: views.draw_menu_item,
}
COMPLEX: dict[QStyle.ComplexControl, Draw] = {
    Complex.CC_ComboBox: fields.draw_combo_box,
    Complex.CC_SpinBox: fields.draw_spin_box,
    Complex.CC_ToolButton: buttons.draw_tool_button,
    Complex.CC_ScrollBar: views.draw_scroll_bar,
}
PRIMITIVES: dict[QStyle.PrimitiveElement, Draw] = {
    Primitive.PE_Widget: frames.draw_panel,
    Primitive.PE_PanelTipLabel: frames.draw_tip,
    Primitive.PE_PanelMenu: frames.draw_menu_panel,
    Primitive.PE_PanelLineEdit: fields.draw_field,
    Primitive.PE_IndicatorCheckBox: buttons.draw_check,
    Primitive.PE_IndicatorItemViewItemCheck: buttons.draw_check,
    Primitive.PE_IndicatorRadioButton: buttons.draw_radio,
    Primitive.PE_PanelItemViewItem: views.draw_item,
    Primitive.PE_PanelItemViewRow: views.draw_row,
    Primitive.PE_IndicatorArrowDown: lambda ink, option, painter, _: ink.chevron(painter, option.rect, "down"),
    Primitive.PE_IndicatorArrowUp: lambda ink, option, painter, _: ink.chevron(painter, option.rect, "up"),
    Primitive.PE_IndicatorArrowRight: lambda ink, option, painter, _: ink.chevron(painter, option.rect, "right"),
}
NOT_DRAWN = frozenset(
    {
        Primitive.PE_FrameFocusRect,  # drawn as a border
        Primitive.PE_IndicatorHeaderArrow,  # drawn with the words of the heading
        Primitive.PE_FrameMenu,
        Primitive.PE_FrameLineEdit,
        Primitive.PE_PanelScrollAreaCorner,
        Primitive.PE_FrameStatusBarItem,
    }
)
CELL_PARTS = frozenset({Element.SE_ItemViewItemCheckIndicator, Element.SE_ItemViewItemDecoration, Element.SE_ItemViewItemText})
METRICS: dict[QStyle.PixelMetric, int] = {
    Metric.PM_DefaultFrameWidth: 1,
    Metric.PM_ScrollBarExtent: views.BAR_PX,
    Metric.PM_ScrollBarSliderMin: views.HANDLE_PX,
    Metric.PM_ScrollView_ScrollBarSpacing: 0,
    Metric.PM_IndicatorWidth: 18,
    Metric.PM_IndicatorHeight: 18,
    Metric.PM_ExclusiveIndicatorWidth: 18,
    Metric.PM_ExclusiveIndicatorHeight: 18,
    Metric.PM_CheckBoxLabelSpacing: 8,
    Metric.PM_RadioButtonLabelSpacing: 8,
    Metric.PM_MenuButtonIndicator: buttons.MENU_ARROW_PX,
    Metric.PM_MenuPanelWidth: 1,
    Metric.PM_MenuVMargin: 4,
    Metric.PM_MenuHMargin: 0,
    Metric.PM_FocusFrameHMargin: 2,
    Metric.PM_SplitterWidth: 16,
    Metric.PM_ToolTipLabelFrameWidth: 4,
    Metric.PM_ButtonShiftHorizontal: 0,
    Metric.PM_ButtonShiftVertical: 0,
}
HINTS: dict[QStyle.StyleHint, int] = {
    Hint.SH_Widget_Animation_Duration: 0,
    Hint.SH_ComboBox_Popup: 0,
    Hint.SH_EtchDisabledText: 0,
    Hint.SH_ItemView_ShowDecorationSelected: 1,
    Hint.SH_ScrollBar_Transient: 0,
    Hint.SH_ScrollBar_LeftClickAbsolutePosition: 0,
    Hint.SH_Menu_SupportsSections: 1,
    Hint.SH_ToolTip_WakeUpDelay: 500,
}


class WindowStyle(QProxyStyle):
    """Draws from the theme, the palette and the properties of widgets, so that a change of theme only paints again."""

    def __init__(self, theme: Theme) -> None:
        super().__init__("Fusion")
        self.setObjectName(NAME)
        self.ink = Ink(theme)

    def set_theme(self, theme: Theme) -> None:
        """Draw in the colours of another theme from now on."""
        self.ink = Ink(theme)

    def drawControl(self, element: QStyle.ControlElement, option: QStyleOption, painter: QPainter, widget: QWidget | None = None) -> None:
        """Draw one control."""
        draw = CONTROLS.get(element)
        if draw is not None:
            draw(self.ink, option, painter, widget)
            return
        if element == Control.CE_ItemViewItem and isinstance(option, QStyleOptionViewItem):
            self._keep_text_colour(option)
        super().drawControl(element, option, painter, widget)

    def _keep_text_colour(self, option: QStyleOptionViewItem) -> None:
        """Write on a selected row in the colour of all rows; its ground is light."""
        palette = QPalette(option.palette)
        palette.setColor(QPalette.ColorRole.HighlightedText, palette.color(QPalette.ColorRole.Text))
        option.palette = palette

    def drawComplexControl(
        self, control: QStyle.ComplexControl, option: QStyleOptionComplex, painter: QPainter, widget: QWidget | None = None
    ) -> None:
        """Draw one control of several parts."""
        draw = COMPLEX.get(control)
        if draw is not None:
            draw(self.ink, option, painter, widget)
        else:
            super().drawComplexControl(control, option, painter, widget)

    def drawPrimitive(
        self, element: QStyle.PrimitiveElement, option: QStyleOption, painter: QPainter, widget: QWidget | None = None
    ) -> None:
        """Draw one part of a control."""
        if element in NOT_DRAWN:
            return
        draw = PRIMITIVES.get(element)
        if draw is not None:
            draw(self.ink, option, painter, widget)
        else:
            super().drawPrimitive(element, option, painter, widget)

    def sizeFromContents(self, kind: QStyle.ContentsType, option: QStyleOption, contents: QSize, widget: QWidget | None = None) -> QSize:
        """Return the size of a control with these contents."""
        if kind == Contents.CT_PushButton:
            return buttons.button_size(contents, widget)
        if kind == Contents.CT_LineEdit:
            return fields.line_edit_size(contents)
        if kind == Contents.CT_ComboBox:
            return fields.combo_box_size(contents)
        if kind == Contents.CT_SpinBox:
            return fields.spin_box_size(contents, widget)
        if kind == Contents.CT_ToolButton:
            return QSize(contents.width() + 10, contents.height() + 10)
        if kind == Contents.CT_HeaderSection:
            return views.header_size(option)
        if kind == Contents.CT_MenuItem:
            return views.menu_item_size(option, contents)
        if kind == Contents.CT_ItemViewItem:
            return super().sizeFromContents(kind, option, contents, widget) + QSize(2 * views.CELL_PX, 0)
        if kind == Contents.CT_ProgressBar:
            return QSize(contents.width(), views.PROGRESS_PX)
        return super().sizeFromContents(kind, option, contents, widget)

    def subControlRect(
        self, control: QStyle.ComplexControl, option: QStyleOptionComplex, part: QStyle.SubControl, widget: QWidget | None = None
    ) -> QRect:
        """Return where a part of a control lies."""
        if control == Complex.CC_SpinBox:
            return fields.spin_box_part(option.rect, part, widget)
        if control == Complex.CC_ComboBox:
            return fields.combo_box_part(option.rect, part)
        if control == Complex.CC_ScrollBar:
            return views.scroll_bar_part(option, part)
        return super().subControlRect(control, option, part, widget)

    def subElementRect(self, element: QStyle.SubElement, option: QStyleOption, widget: QWidget | None = None) -> QRect:
        """Return where the contents of a control lie."""
        if element == Element.SE_LineEditContents:
            return option.rect if fields.is_bare(widget) else option.rect.adjusted(fields.PADDING_PX, 1, -fields.PADDING_PX, -1)
        if element in (Element.SE_ProgressBarGroove, Element.SE_ProgressBarContents):
            return option.rect
        if element in CELL_PARTS:
            whole = QRect(option.rect)  # a copy: the option hands out its own
            option.rect = whole.adjusted(views.CELL_PX, 0, -views.CELL_PX, 0)
            inner = super().subElementRect(element, option, widget)
            option.rect = whole
            return inner
        return super().subElementRect(element, option, widget)

    def pixelMetric(self, metric: QStyle.PixelMetric, option: QStyleOption | None = None, widget: QWidget | None = None) -> int:
        """Return a size in px."""
        known = METRICS.get(metric)
        return super().pixelMetric(metric, option, widget) if known is None else known

    def styleHint(
        self,
        hint: QStyle.StyleHint,
        option: QStyleOption | None = None,
        widget: QWidget | None = None,
        returned: QStyleHintReturn | None = None,
    ) -> int:
        """Return how a control behaves."""
        known = HINTS.get(hint)
        return super().styleHint(hint, option, widget, returned) if known is None else known

    def polish(self, polished: Any) -> Any:
        """Set font, colour role and attributes of a widget by its role; called before it is first shown, or on demand."""
        made = super().polish(polished)
        if isinstance(polished, QWidget):
            dress(polished, self.ink.theme)
        return made
