"""What pages do by keys of their own, as entries of the list of actions: the pages bind these keys, here they are only listed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Protocol

from ui.actions.actions import Action, always
from ui.controllers.controllers import Controllers
from ui.pages.clouds.clouds import CloudsPage
from ui.pages.inspection.inspection import InspectionPage
from ui.pages.page import Page
from ui.pages.pages import Pages
from ui.pages.plan.page import PlanPage
from ui.widgets.basic import Button

Listed = tuple[str, str, Callable[[], object], str, Callable[[], str]]  # last part of the id, words, what is done, keys, why not


class PagedWindow(Protocol):
    """What is needed of the main window."""

    controllers: Controllers
    pages: Pages

    @property
    def page(self) -> Page:
        """The workspace shown."""


def page_keys(window: PagedWindow) -> tuple[Action, ...]:
    """Return what the pages Plan, Clouds and Inspect do by keys of their own."""
    return (
        *_on_page(window, "plan", "viewpoint", "Go to the page Plan first.", _plan(window)),
        *_on_page(window, "clouds", "view exclude", "Go to the page Clouds first.", _clouds(window)),
        *_on_page(window, "inspection", "dimension feature program", "Go to the page Inspect first.", _inspection(window)),
    )


def _on_page(window: PagedWindow, page: str, keywords: str, elsewhere: str, listed: Sequence[Listed]) -> tuple[Action, ...]:
    def on_page(why_not: Callable[[], str]) -> Callable[[], str]:
        return lambda: why_not() if window.page.name == page else elsewhere

    return tuple(
        Action(f"{page}.{name}", words, run, keywords, page, keys, on_page(why_not), bound=False)
        for name, words, run, keys, why_not in listed
    )


def _plan(window: PagedWindow) -> tuple[Listed, ...]:
    def page() -> PlanPage:
        found = window.pages["plan"]
        assert isinstance(found, PlanPage)
        return found

    def press(button: Callable[[PlanPage], Button]) -> Callable[[], None]:
        return lambda: button(page()).click()

    return (
        ("undo", "Undo the change of the plan", lambda: page().undo_last(), "Ctrl+Z", always),
        ("redo", "Redo the change of the plan", window.controllers.planning.redo, "Ctrl+Y", always),
        ("open", "Open a scan plan…", press(lambda plan: plan.open_file), "Ctrl+Shift+O", always),
        ("copy", "Duplicate the viewpoints", press(lambda plan: plan.tools.copy), "Ctrl+D", always),
        ("remove", "Delete the viewpoints", press(lambda plan: plan.tools.remove), "Del", always),
        ("up", "Move the viewpoints up", press(lambda plan: plan.tools.up), "Alt+Up", always),
        ("down", "Move the viewpoints down", press(lambda plan: plan.tools.down), "Alt+Down", always),
    )


def _clouds(window: PagedWindow) -> tuple[Listed, ...]:
    def page() -> CloudsPage:
        found = window.pages["clouds"]
        assert isinstance(found, CloudsPage)
        return found

    return (("undo", "Undo the last choice or filter", lambda: page().undo_last(), "Ctrl+Z", always),)


def _inspection(window: PagedWindow) -> tuple[Listed, ...]:
    programming = window.controllers.programming

    def page() -> InspectionPage:
        found = window.pages["inspection"]
        assert isinstance(found, InspectionPage)
        return found

    def at(found: Callable[[InspectionPage], Callable[[], object]]) -> Callable[[], object]:
        def run() -> None:
            found(page())()  # the page is made when it is first needed

        return run

    def no_rows() -> str:
        return "" if page().side.actions.chosen else "Select dimensions in the table first."

    def no_feature() -> str:
        return "" if len(page().side.features.entries()) == 1 else "Select one feature in the table first."

    return (
        ("undo", "Undo the change of the program", at(lambda page: page.undo_last), "Ctrl+Z", always),
        ("redo", "Redo the change of the program", programming.redo, "Ctrl+Y", always),
        ("save", "Save program with results and report", programming.save, "Ctrl+S", always),
        ("find", "Search the dimensions", at(lambda page: page.side.filter.search.setFocus), "Ctrl+F", always),
        ("rename", "Rename the selected feature…", at(lambda page: page.side.feature_actions.rename), "F2", no_feature),
        ("copy", "Duplicate the selected dimensions", at(lambda page: page.side.actions.duplicate), "Ctrl+D", no_rows),
        ("remove", "Delete the selected dimensions", at(lambda page: page.side.actions.remove), "Del", no_rows),
        ("up", "Move the selected dimensions up", at(lambda page: partial(page.side.actions.move, -1)), "Alt+Up", no_rows),
        ("down", "Move the selected dimensions down", at(lambda page: partial(page.side.actions.move, 1)), "Alt+Down", no_rows),
    )
