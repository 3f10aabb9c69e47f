"""The buttons of a running scan, and what it does in words."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.look.wording import with_hint
from ui.session import RunNow
from ui.widgets.basic import Button, label, row


class RunBar(QWidget):
    """Pause or resume, skip, retake; and why the scan is paused."""

    pauseClicked = Signal()
    resumeClicked = Signal()
    skipClicked = Signal()
    retakeClicked = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.words = label("", "soft", wrap=True)
        self.pause = Button("Pause", look, "pause", "normal", "Pause as soon as the rig is safe; nothing stored is lost")
        self.resume = Button("Resume", look, "run", "primary", "Continue the paused scan")
        self.skip = Button("Skip", look, "skip", "normal", "Do not take the chosen viewpoint, or the present one")
        self.retake = Button(
            "Retake", look, "again", "normal", "Take the chosen viewpoint again; its images are kept until the new ones are stored"
        )
        for button, signal in (
            (self.pause, self.pauseClicked),
            (self.resume, self.resumeClicked),
            (self.skip, self.skipClicked),
            (self.retake, self.retakeClicked),
        ):
            button.clicked.connect(signal)
        layout = row(self.words, self.pause, self.resume, self.skip, self.retake)
        layout.setStretch(0, 1)
        self.setLayout(layout)

    def show_run(self, run: RunNow, words: str, *, can_retake: bool, is_taking: bool) -> None:
        """Show the state of the run; ``words`` while nothing has paused it. What is taken can be paused and skipped."""
        running = run.state != "idle" and is_taking
        self.pause.setVisible(is_taking and run.state in ("running", "pausing"))
        self.pause.setEnabled(run.state == "running")
        self.resume.setVisible(run.state == "paused")
        self.skip.setVisible(running)
        self.retake.setVisible(can_retake)
        paused = with_hint(run.cause, run.remedy) or "Paused."
        pausing = run.cause or "Pausing: the rig comes to a safe stop…"
        self.words.setText(
            translated(pausing) if run.state == "pausing" else translated(paused) if run.state == "paused" else translated(words)
        )
