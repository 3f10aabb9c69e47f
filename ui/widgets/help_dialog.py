"""Display of the help pages."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Signal
from PySide6.QtWidgets import QDialog, QTextBrowser, QWidget

from measureapp.errors import InputError
from ui.look.language.help_pages import read_help
from ui.look.language.words import TRANSLATOR, tr
from ui.look.look import Look
from ui.widgets.basic import Button, column, row
from ui.widgets.help_layout import lay_out


class HelpDialog(QDialog):
    """Shows one help page in the language of the window, with links to the others."""

    tourClicked = Signal()

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Help"))
        self.resize(800, 640)
        self.browser = QTextBrowser()
        self.browser.setOpenLinks(False)
        self.browser.anchorClicked.connect(lambda link: self.show_page(link.path().removesuffix(".md")))
        self.tour = Button("Take the tour", look, "run", "normal", "A tour of the window on a sample project, in seven steps")
        self.tour.clicked.connect(self._begin_tour)
        self.setLayout(column(self.browser, row(0, self.tour), margin=16))
        self.page = ""  # name of the page on display
        self._look = look
        look.changed.connect(self._show_again)

    def _begin_tour(self) -> None:
        self.close()
        self.tourClicked.emit()

    def show_page(self, name: str) -> None:
        """Show the help of one page, from its beginning."""
        self._fill(name)
        self.show()
        self.raise_()

    def _fill(self, name: str) -> None:
        try:
            text = read_help(name, TRANSLATOR.catalogue)
        except (InputError, OSError):
            text = tr("# Help\n\nThere is no page about “{name}”.", name=name)
        self.page = name
        colour = self._look.theme.colours["accent_text"]
        self.browser.document().setDefaultStyleSheet(tr("a {{ color: {colour}; }}", colour=colour))
        self.browser.setMarkdown(text)
        lay_out(self.browser.document(), self._look.theme)

    def _show_again(self) -> None:
        """Follow a change of language or theme, at the same paragraph: pages have the same ones in all languages."""
        if not self.page:
            return
        paragraph = self.browser.cursorForPosition(QPoint(0, 0)).blockNumber()
        self._fill(self.page)
        block = self.browser.document().findBlockByNumber(paragraph)
        top = self.browser.document().documentLayout().blockBoundingRect(block).top()
        self.browser.verticalScrollBar().setValue(round(top) if paragraph else 0)
