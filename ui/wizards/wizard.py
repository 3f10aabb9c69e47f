"""The window of every wizard: steps on the left, one step in the middle, and one filled button for what comes next."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Slot
from PySide6.QtGui import QCloseEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import QDialog, QStackedWidget, QWidget

from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from ui.actions.actions import REDO_KEYS
from ui.controllers.calibrating import CalibratingController
from ui.controllers.result import Result
from ui.look.language.words import later, tr, translated
from ui.look.look import Look
from ui.look.wording import several
from ui.widgets.basic import column, label, row
from ui.widgets.help_dialog import HelpDialog
from ui.widgets.step_list import Step, StepList, StepState
from ui.wizards.collect_page import CollectPage
from ui.wizards.footer import Footer
from ui.wizards.result_page import ResultPage
from ui.wizards.setup_page import SetupPage

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Kind

SETUP, COLLECT, RESULT = range(3)
SMALLEST, USUAL = (1264, 660), (1340, 740)  # the smallest fits a screen of 1280 × 720
MORE = 5  # views at a time, beyond those planned
TAKE_MORE = later("Take {more} more views").format(more=MORE)
HELP_PAGE = "calibration_wizards"
ANYWAY, KEEP_OLD, NOT_NOW = "Accept anyway", "Keep the previous one", "Not now"
OTHER_IMAGES = "Choose other images"
JUDGING, NO_RESULT = "Evaluating the result…", "These views do not determine a result yet."


class CalibrationWizard(QDialog):
    """One calibration from the first image to the accepted result; closing loses nothing."""

    def __init__(self, look: Look, kind: Kind, calibrating: CalibratingController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(translated(kind.words.title))
        self.setModal(True)
        self.setMinimumSize(*SMALLEST)
        self.resize(QSize(*USUAL).boundedTo(self.screen().availableSize()))
        self.kind, self.calibrating, self.collecting = kind, calibrating, calibrating.collecting
        self.steps = StepList(look)
        self.setup, self.collect, self.result = SetupPage(look, kind), CollectPage(look, self.collecting), ResultPage(look)
        self.stack = QStackedWidget()
        for page in (self.setup, self.collect, self.result):
            self.stack.addWidget(page)
        self.footer = Footer(look, self.steps)
        self.help = HelpDialog(look, self)
        title = row(label(kind.words.title, "title"), 0, self.footer.help)
        middle = row(self.steps, self.stack, spacing=24)
        middle.setStretch(1, 1)
        layout = column(title, middle, self.footer, margin=16, spacing=12)
        layout.setStretch(1, 1)
        self.setLayout(layout)
        self._connect()
        self.footer.primary.setDefault(True)
        self.steps.setFocus()

    def _connect(self) -> None:
        collecting, footer = self.collecting, self.footer
        self.steps.stepClicked.connect(self.show_step)
        self.setup.changed.connect(self.refresh)
        self.setup.resumeClicked.connect(self._resume)
        footer.primary.clicked.connect(self._do_next)
        footer.second.clicked.connect(self._do_second)
        footer.third.clicked.connect(self._do_third)
        footer.stop.clicked.connect(collecting.stop)
        footer.help.clicked.connect(self._show_help)
        collecting.begun.connect(self._begun)
        collecting.changed.connect(self.refresh)
        collecting.progressed.connect(footer.show_progress)
        collecting.told.connect(footer.show_message)
        self.calibrating.concluded.connect(self._show_result)
        self.calibrating.checking.connect(self.result.show_checking)
        self.calibrating.checked.connect(self._show_checked)
        self.result.stop_check.clicked.connect(self.calibrating.stop_check)
        for keys, action in (
            (QKeySequence.StandardKey.Delete, self.collect.remove_chosen),
            (QKeySequence.StandardKey.Undo, collecting.undo),
            *((key, collecting.redo) for key in REDO_KEYS),
            (QKeySequence.StandardKey.HelpContents, self._show_help),
        ):
            QShortcut(QKeySequence(keys), self, action)

    @property
    def step(self) -> int:
        """The step that is shown."""
        return self.stack.currentIndex()

    def begin(self) -> None:
        """Show the first step, without the message that stood there when the wizard was closed."""
        self.footer.show_message("")
        rig = self.calibrating.rig_setup()
        if rig is not None:
            self.setup.offer_rig(rig)
        self.setup.offer_kept(self.collecting.kept())
        self.show_step(SETUP)
        self.open()

    def show_step(self, step: int) -> None:
        """Show one step."""
        self.stack.setCurrentIndex(step)
        if step != RESULT:
            self.calibrating.stop_check()  # what is collected next is solved on the same thread
        if step == COLLECT:
            self.collect.begin()
        else:
            self.collect.end()
        self.refresh()

    def refresh(self) -> None:
        """Show the state of every step and the possible actions."""
        self.steps.show_steps(self._states(), self.step)
        self.footer.offer(*self._offers(), self.setup.problem() if self.step == SETUP else "")
        if self.step == RESULT and self.calibrating.result is None and not self.calibrating.is_concluding:
            self.result.show_none(NO_RESULT)
        self.footer.show_running(self.collecting.is_collecting and self.step == COLLECT, self.calibrating.is_concluding)

    def _states(self) -> list[Step]:
        collecting, found = self.collecting, self.calibrating.result
        begun, views = bool(collecting.cameras), sum(view.verdict == "pass" for view in collecting.views)
        problem = self.setup.problem()
        setup = Step(
            "Set up",
            "done" if begun else "now",
            problem if not begun else several(sum(name != PROJECTOR for name in collecting.cameras), "camera"),
        )
        state: StepState = "waiting" if not begun else "done" if collecting.solver.has_enough else "now"
        words = tr("{count} in use", count=several(views, "view")) if begun else ""
        result: StepState = "waiting" if found is None else "done" if found.sign == "pass" else "problem"
        return [
            setup,
            Step(self.kind.words.step, state, words),
            Step("Result", result, {"done": "Good", "problem": "Check"}.get(result, "")),
        ]

    def _offers(self) -> tuple[str, str, str]:
        """Return the words of the filled button, the second and the third; empty: not offered."""
        collecting = self.collecting
        if self.step == SETUP:
            return "Begin", "", ""
        if self.step == COLLECT:
            see = "See the result" if collecting.solver.is_solved and not collecting.is_collecting else ""
            if collecting.capture.viewpoints_left and not collecting.is_collecting:
                return tr("Take {count}", count=several(len(collecting.capture.viewpoints_left), "view")), see, "Take one view"
            if collecting.capture.can_take_more and not collecting.is_collecting:
                more = TAKE_MORE
                return (see, more, "") if collecting.solver.is_good or collecting.capture.took_more else (more, see, "")
            if not (see or collecting.capture.rig is not None or collecting.is_collecting or collecting.solver.is_running):
                return OTHER_IMAGES, "", ""
            return see, "", ""
        more = "Collect more" if collecting.capture.can_collect else "Back to the views"
        if self.calibrating.result is None:
            return "", more, ""
        keep = KEEP_OLD if self.calibrating.has_previous else NOT_NOW
        if self.calibrating.result.sign == "pass":
            return "Accept", more, keep
        return (more, ANYWAY, keep) if collecting.capture.can_collect else (keep, ANYWAY, more)

    def _do_next(self) -> None:
        self.footer.show_message("")
        offered = self.footer.words[0]
        if self.step == SETUP:
            self.collecting.begin(self.setup.value())
        elif offered == "See the result":
            self._conclude()
        elif offered == OTHER_IMAGES:
            self.show_step(SETUP)
        elif self.step == COLLECT:
            self._take(offered)
        else:
            self._decide(offered)

    def _do_second(self) -> None:
        offered = self.footer.words[1]
        if offered == "See the result":
            self._conclude()
        elif self.step == COLLECT:
            self._take(offered)
        else:
            self._decide(offered)

    def _decide(self, offered: str) -> None:
        """Accept the result, keep the previous one, or go back to the views."""
        if offered in ("Accept", ANYWAY):
            self._accept()
        elif offered in (KEEP_OLD, NOT_NOW):
            self.close()
        else:
            self.show_step(COLLECT)

    def _take(self, offered: str) -> None:
        if offered == TAKE_MORE:
            self.collecting.capture.take_more(MORE)
        else:
            self.collecting.capture.take()

    def _do_third(self) -> None:
        if self.step == COLLECT:
            self.collecting.capture.take(1)
        else:
            self._decide(self.footer.words[2])

    def _resume(self) -> None:
        kept = self.collecting.kept()
        if kept is not None:
            self.footer.show_message("")
            self.collecting.resume(kept.folder)

    def _begun(self) -> None:
        self.calibrating.forget_result()
        self.show_step(COLLECT)

    def _conclude(self) -> None:
        self.result.show_none(JUDGING)
        self.calibrating.conclude()
        self.show_step(RESULT)

    @Slot(object)
    def _show_result(self, found: Result) -> None:
        self.result.show_result(found)
        if self.calibrating.is_checking:
            self.result.show_checking(0.0)
        self.refresh()

    @Slot(object)
    def _show_checked(self, found: Result | None) -> None:
        self.result.show_checked(found)
        self.refresh()

    def _accept(self) -> None:
        if self.calibrating.accept():
            self.accept()

    def _show_help(self) -> None:
        self.help.show_page(HELP_PAGE)

    def done(self, code: int) -> None:
        """Stop the jobs of this wizard; everything collected is on disk."""
        self.collect.end()
        self.calibrating.close()
        super().done(code)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Close as Escape does."""
        self.done(QDialog.DialogCode.Rejected)
        event.accept()
