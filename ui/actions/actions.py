"""The list of actions: each is registered once, with its words, its shortcut, and the reason when it cannot be used."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QWidget

from ui.actions.search import score
from ui.look.language.words import translated

EVERYWHERE = ""
REDO_KEYS = ("Ctrl+Y", "Ctrl+Shift+Z")  # both on every system: which of them is usual differs
ENGINEERS = "This needs the engineer's role."
UNUSABLE = 1.0  # points less for what cannot be used at the moment


def always() -> str:
    """Return no reason: the action can be used at any time."""
    return ""


@dataclass(frozen=True)
class Action:
    """One action.

    ``why_not`` returns the reason why it cannot be used at the moment, empty if it can; ``context`` is the name of the page to which it
    belongs, or `EVERYWHERE`; ``bound``: the shortcut is made here, else the page makes it and it is only listed.
    """

    id: str
    text: str
    run: Callable[[], object]
    keywords: str = ""
    context: str = EVERYWHERE
    shortcut: str = ""
    why_not: Callable[[], str] = always
    icon: str = ""
    bound: bool = True
    for_operator: bool = False  # also without the engineer's role


class Actions(QObject):
    """Registers actions, finds them by what a user types, and runs them."""

    refused = Signal(str, str)  # words of the action, reason

    def __init__(self, window: QWidget, is_engineer: Callable[[], bool] = lambda: True) -> None:
        """``window``: in which the shortcuts work; ``is_engineer``: whether all actions are allowed."""
        super().__init__(window)
        self._is_engineer = is_engineer
        self._window = window
        self._actions: dict[str, Action] = {}

    def register(self, *actions: Action) -> None:
        """Add actions. Raises ValueError for an id or a shortcut that is taken."""
        for action in actions:
            if action.id in self._actions:
                raise ValueError(f"the action {action.id} is registered twice")
            if action.shortcut:
                self._claim(action)
            self._actions[action.id] = action

    def _claim(self, action: Action) -> None:
        keys = QKeySequence(action.shortcut)
        for other in self._actions.values():
            shared = EVERYWHERE in (other.context, action.context) or other.context == action.context
            if shared and other.shortcut and QKeySequence(other.shortcut) == keys:
                raise ValueError(f"{action.id} and {other.id} have the same shortcut {action.shortcut}")
        if action.bound:
            QShortcut(keys, self._window).activated.connect(lambda: self.perform(action.id))

    def all(self) -> tuple[Action, ...]:
        """Return all actions in the order in which they were registered."""
        return tuple(self._actions.values())

    def action(self, id_: str) -> Action | None:
        """Return one action; None if there is none of this id."""
        return self._actions.get(id_)

    def find(self, typed: str, also: Sequence[Action] = ()) -> tuple[Action, ...]:
        """Return the actions that fit what was typed, the best first; of equals those that can be used.

        ``also``: of the moment, such as the buttons of a page; they are not registered.
        """
        scored = [(_fit(typed, action), place, action) for place, action in enumerate((*self._actions.values(), *also))]
        found = [(UNUSABLE * bool(self.reason(action)) - points, place, action) for points, place, action in scored if points is not None]
        return tuple(action for *_, action in sorted(found, key=lambda entry: entry[:2]))

    def reason(self, action: Action) -> str:
        """Return why an action cannot be used at the moment; empty if it can."""
        return action.why_not() if action.for_operator or self._is_engineer() else ENGINEERS

    def perform(self, id_: str) -> bool:
        """Run a registered action, or say why it cannot be used; return whether it ran."""
        return self.run(self._actions[id_])

    def run(self, action: Action) -> bool:
        """Run an action, registered or not, or say why it cannot be used; return whether it ran."""
        reason = self.reason(action)
        if reason:
            self.refused.emit(action.text, reason)
            return False
        action.run()
        return True


def _fit(typed: str, action: Action) -> float | None:
    """Return how well an action fits what was typed, in the language of the window; its English words are keywords then."""
    text = translated(action.text)
    others = (translated(action.keywords), action.text, action.keywords)
    return score(typed, text, " ".join(dict.fromkeys(words for words in others if words != text)))
