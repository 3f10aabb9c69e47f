"""Layout of help pages: spacing, tables and code, for which Qt has no style where it reads Markdown."""

from __future__ import annotations

from PySide6.QtGui import (
    QBrush,
    QTextBlock,
    QTextBlockFormat,
    QTextCharFormat,
    QTextCursor,
    QTextDocument,
    QTextFormat,
    QTextFrameFormat,
    QTextTable,
)

from ui.look.theme import Theme

ABOVE_HEADING, BELOW, BELOW_ITEM = 16, 8, 4  # px
ITEM_INDENT = 24  # px
CELL, AROUND_TABLE = 6, 12  # px
CODE_LINE, CODE_MARGIN, CODE_HANGING = 21, 16, 24  # px
LINE = 21  # px; of table rows, whose cells otherwise stand at different heights where only one has ideographs


def lay_out(document: QTextDocument, theme: Theme) -> None:
    """Space paragraphs, wrap code with a hanging indent, and draw tables in the colours of a theme."""
    document.setIndentWidth(ITEM_INDENT)
    tables: dict[int, QTextTable] = {}
    block = document.begin()
    while block.isValid():
        cursor = QTextCursor(block)
        table = cursor.currentTable()
        if table is not None:
            tables[table.firstPosition()] = table
            cursor.setBlockFormat(_cell_format(block))
        else:
            cursor.setBlockFormat(_code_format(block) if _is_code(block) else _paragraph_format(block))
        block = block.next()
    for table in tables.values():
        _lay_out_table(table, theme)


def _is_code(block: QTextBlock) -> bool:
    return block.isValid() and block.blockFormat().hasProperty(QTextFormat.Property.BlockCodeLanguage)


def _paragraph_format(block: QTextBlock) -> QTextBlockFormat:
    form = block.blockFormat()
    form.setTopMargin(ABOVE_HEADING if form.headingLevel() > 1 else 0)
    form.setBottomMargin(BELOW_ITEM if block.textList() is not None and block.next().textList() is not None else BELOW)
    return form


def _code_format(block: QTextBlock) -> QTextBlockFormat:
    form = block.blockFormat()
    form.setNonBreakableLines(False)
    form.setLeftMargin(CODE_MARGIN + CODE_HANGING)
    form.setTextIndent(-CODE_HANGING)
    form.setTopMargin(0)
    form.setBottomMargin(0 if _is_code(block.next()) else BELOW)
    form.setLineHeight(CODE_LINE, QTextBlockFormat.LineHeightTypes.MinimumHeight.value)
    return form


def _cell_format(block: QTextBlock) -> QTextBlockFormat:
    form = block.blockFormat()
    form.setLineHeight(LINE, QTextBlockFormat.LineHeightTypes.MinimumHeight.value)
    return form


def _lay_out_table(table: QTextTable, theme: Theme) -> None:
    form = table.format()
    form.setBorderCollapse(True)
    form.setBorder(1)
    form.setBorderStyle(QTextFrameFormat.BorderStyle.BorderStyle_Solid)
    form.setBorderBrush(QBrush(theme.colour("line")))
    form.setCellPadding(CELL)
    form.setTopMargin(AROUND_TABLE - BELOW)
    form.setBottomMargin(AROUND_TABLE)
    table.setFormat(form)
    head = QTextCharFormat()
    head.setBackground(QBrush(theme.colour("raised")))
    for number in range(table.columns()):
        cell = table.cellAt(0, number)
        shown = cell.format()
        shown.merge(head)
        cell.setFormat(shown)
