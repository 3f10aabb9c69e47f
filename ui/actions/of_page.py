"""What a page offers at the moment, as actions: its visible buttons, and the menus that a right click would open."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Protocol, runtime_checkable

import shiboken6
from PySide6.QtCore import QObject
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QPushButton, QWidget

from ui.actions.actions import Action
from ui.look.language.words import tr, translated

NOT_NOW = "It cannot be used at the moment."


@runtime_checkable
class OffersMenu(Protocol):
    """A widget with a context menu, or what makes the menu of its parent."""

    def offered_menu(self) -> QMenu | None:
        """Return a new menu for what is selected; None: nothing is."""


class PageActions:
    """The actions of one page; its menus are kept until they are collected again, as their entries belong to them."""

    def __init__(self) -> None:
        self.actions: tuple[Action, ...] = ()
        self._menus: list[QMenu] = []

    def collect(self, name: str, page: QWidget, registered: Sequence[Action]) -> None:
        """List the buttons and menus of a page anew, without those that are registered under the same words."""
        for menu in self._menus:
            if shiboken6.isValid(menu):
                menu.deleteLater()
        self._menus = [menu for maker in _menu_makers(page) if (menu := maker.offered_menu()) is not None]
        buttons = [one for one in page.findChildren(QPushButton) if one.isVisible() and one.accessibleName()]
        known = {translated(action.text) for action in registered if action.context == name}
        found = (*_buttons(name, buttons), *_entries(name, (*self._menus, *(one.menu() for one in buttons if one.menu()))))
        self.actions = tuple(action for action in found if action.text not in known)


def _menu_makers(page: QWidget) -> Iterator[OffersMenu]:
    for one in page.findChildren(QObject):
        owner = one if isinstance(one, QWidget) else one.parent()
        if isinstance(one, OffersMenu) and isinstance(owner, QWidget) and owner.isVisible():
            yield one


def _buttons(name: str, buttons: Sequence[QPushButton]) -> Iterator[Action]:
    """Yield buttons by the names that a screen reader says."""
    for place, one in enumerate(buttons):
        reason = lambda one=one: "" if one.isEnabled() else NOT_NOW  # noqa: E731
        yield Action(f"{name}.button.{place}", one.accessibleName(), one.click, one.toolTip(), name, why_not=reason)


def _entries(name: str, menus: Sequence[QMenu]) -> Iterator[Action]:
    """Yield the entries of menus, those of a menu inside another with its title."""
    for place, (entry, title) in enumerate(one for menu in menus for one in _flat(menu)):
        words = entry.text().partition("\t")[0].replace("&&", "&")
        text = tr("{menu}: {entry}", menu=title, entry=words) if title else words
        reason = lambda entry=entry: "" if entry.isEnabled() else NOT_NOW  # noqa: E731
        yield Action(f"{name}.menu.{place}", text, entry.trigger, context=name, why_not=reason)


def _flat(menu: QMenu, title: str = "") -> Iterator[tuple[QAction, str]]:
    for entry in menu.actions():
        inner = entry.menu()
        if isinstance(inner, QMenu):
            yield from _flat(inner, tr("{menu}: {entry}", menu=title, entry=inner.title()) if title else inner.title())
        elif entry.text():
            yield entry, title
