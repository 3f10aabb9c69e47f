"""What pages with a 3-D view share: it starts when graphics are ready, and draws only while it is seen."""

from __future__ import annotations

from PySide6.QtGui import QShowEvent

from ui.controllers.controllers import Controllers
from ui.look.look import Look
from ui.pages.page import Page
from ui.session import Session
from ui.viewport.cloud_view import CloudView
from ui.widgets.empty_state import EmptyState


class ViewportPage(Page):
    """A page whose largest thing is the 3-D view; `draw` is called when it is seen and something changed."""

    def __init__(self, look: Look, session: Session, controllers: Controllers, empty: EmptyState) -> None:
        super().__init__(look, session, controllers, empty)
        self.view = CloudView(look)
        self._stale = True
        session.graphicsChanged.connect(self._use_graphics)
        look.changed.connect(self.redraw)
        self._use_graphics()

    def redraw(self) -> None:
        """Draw again, now or when the page is seen."""
        self._stale = True
        if self.isVisible():
            self._stale = False
            self.draw()

    def draw(self) -> None:
        """Fill the 3-D view."""
        raise TypeError(f"{type(self).__name__} does not draw")

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what changed while the page was hidden."""
        super().showEvent(event)
        if self._stale:
            self.redraw()

    def close_page(self) -> None:
        """Release the graphics memory."""
        self.view.close_view()

    def _use_graphics(self) -> None:
        if self.session.graphics == "ready":
            self.view.activate()
        elif self.session.graphics == "failed":
            self.view.explain(self.session.graphics_problem)
