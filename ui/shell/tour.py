"""A tour of the window on a sample project: one step per page, offered at the first start, taken again from Help."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from ui.controllers.controllers import Controllers
from ui.look.language.words import tr
from ui.pages.page import SAMPLE
from ui.pages.pages import Pages
from ui.session import Session
from ui.settings.settings import Settings
from ui.widgets.rail import Rail
from ui.widgets.tour_bar import TourBar

TAKEN = "taken"  # value of the setting


@dataclass(frozen=True)
class Step:
    """One step: the page it shows, and what it says about it."""

    page: str
    heading: str
    text: str


WELCOME = Step(
    "",
    "Welcome to MeasureApp",
    "A tour in seven steps leads through a part that has been measured on the virtual rig, up to its report. Nothing moves.",
)
STEPS = (
    Step(
        "rig",
        "The rig",
        "Cameras, projector, robot, linear guide and rotary table, real or virtual. Connect them here, and move them by hand.",
    ),
    Step(
        "calibration",
        "Calibration",
        "One automatic run calibrates the whole rig. The page states what the calibration adds to a length, and when it is due again.",
    ),
    Step("plan", "The scan plan", "The viewpoints around the part. They can be generated from its CAD model, checked and edited here."),
    Step("scan", "The scan", "Start takes all viewpoints while the cloud grows. This one is finished: every viewpoint is a tile."),
    Step(
        "clouds",
        "The clouds",
        "All views in one frame. Turn the part with the left mouse button; click a point to see where it comes from.",
    ),
    Step(
        "inspection",
        "Inspection",
        "Dimensions with tolerance, uncertainty and verdict, the worst first, and the deviation from the CAD model in colours.",
    ),
    Step(
        "report",
        "The report",
        "What you see is the PDF. Export it, or put your company and logo on it. To measure a part of your own, begin on the page Rig.",
    ),
)


class GuidedWindow(Protocol):
    """What the tour needs of the main window."""

    session: Session
    controllers: Controllers
    settings: Settings
    pages: Pages
    rail: Rail

    def show_page(self, name: str) -> None:
        """Show one workspace."""


class Tour(QObject):
    """Leads from page to page; whoever goes elsewhere meanwhile may do so."""

    def __init__(self, window: GuidedWindow, bar: TourBar, parent: QWidget) -> None:
        super().__init__(parent)
        self._window, self.bar = window, bar
        self._place = -1  # step shown; -1: the welcome
        self._waits = False  # for the sample project
        bar.nextClicked.connect(self.go_on)
        bar.backClicked.connect(self.go_back)
        bar.endClicked.connect(self.end)
        window.session.projectChanged.connect(self._go_on_with_sample)
        window.session.appearanceChanged.connect(self._follow_role)

    @property
    def step(self) -> Step:
        """The step shown."""
        return STEPS[self._place] if self._place >= 0 else WELCOME

    def offer(self) -> None:
        """Offer the tour, unless it was taken or refused before, or an operator works here."""
        if self._window.settings.text("tour") != TAKEN and self._window.session.role == "engineer":
            self.begin()

    def begin(self) -> None:
        """Show the welcome."""
        self._place, self._waits = -1, False
        self._show()

    def go_on(self) -> None:
        """Show the next step; the first opens the sample project."""
        if self._place + 1 == len(STEPS):
            self.end()
        elif self._place >= 0:
            self._show_step(self._place + 1)
        elif self._window.session.refuse_during_job():
            return
        else:
            self._waits = True
            self._window.controllers.project.open_sample(SAMPLE)

    def go_back(self) -> None:
        """Show the step before."""
        if self._place > 0:
            self._show_step(self._place - 1)

    def end(self) -> None:
        """End the tour, and do not offer it again."""
        self._waits = False
        self.bar.hide()
        self._window.settings.set_text("tour", TAKEN)

    def _go_on_with_sample(self) -> None:
        if self._waits and self._window.session.folder is not None:
            self._waits = False
            self._show_step(0)

    def _show_step(self, place: int) -> None:
        self._place = place
        self._window.show_page(STEPS[place].page)
        self._show()

    def _show(self) -> None:
        step, last = self.step, self._place + 1 == len(STEPS)
        words = (
            "Show me a measured part"
            if self._place < 0
            else "Finish"
            if last
            else tr("Next: {lower}", lower=STEPS[self._place + 1].heading.lower())
        )
        count = "" if self._place < 0 else tr("{count} of {total}", count=self._place + 1, total=len(STEPS))
        self.bar.say(count, step.heading, step.text, next_words=words, can_go_back=self._place > 0, last=last)

    def _follow_role(self) -> None:
        if self._window.session.role != "engineer":
            self.bar.hide()
