"""What the header shows of the project, the devices, the calibration and the disk."""

from __future__ import annotations

import shutil
from pathlib import Path

from PySide6.QtCore import QObject, QTimer

from ui.look.language.words import tr
from ui.look.wording import part_words, several, storage
from ui.pages.calibration_chip import calibration_state
from ui.session import Session
from ui.widgets.header import HeaderBar

DISK_INTERVAL_MS = 30_000
DISK_LOW_BYTES = 5e9


class HeaderState(QObject):
    """Watches the session and keeps the header up to date."""

    def __init__(self, session: Session, header: HeaderBar, parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._header = session, header
        session.projectChanged.connect(self._show_project)
        session.calibrationChanged.connect(self._show_calibration)
        session.rigChanged.connect(self._show_devices)
        session.cellChanged.connect(self._show_devices)
        self._timer = QTimer(self)
        self._timer.setInterval(DISK_INTERVAL_MS)
        self._timer.timeout.connect(self._show_disk)
        self._timer.start()
        self._show_project()
        self._show_calibration()

    def stop(self) -> None:
        """Watch the disk no longer."""
        self._timer.stop()

    def _show_project(self) -> None:
        session = self._session
        self._header.show_project(
            session.project_name, tr("Part: {part_words}", part_words=part_words(session.part)) if session.part else ""
        )
        self._show_disk()

    def _show_devices(self) -> None:
        chip, (words, colour, tip) = self._header.devices, self._devices()
        self._header.stop.setVisible(self._session.cell.connected or self._session.moving)
        chip.show_state(words, colour, tip)

    def _devices(self) -> tuple[str, str, str]:
        """Return words, colour and tip: the worst first."""
        rig, cell = self._session.rig, self._session.cell
        unready = [device.name for device in cell.devices if not device.status.ready]
        problems = [driver for driver in self._session.drivers if driver.problem and driver.allowed]
        if rig is None:
            return "No rig", "verdict_not_proven", ""
        if cell.stopped:
            return "Stopped", "verdict_fail", cell.stopped
        if unready:
            return tr("{count} not ready", count=several(len(unready), "device")), "verdict_fail", ", ".join(unready)
        if problems:
            return tr("{drivers} failed", drivers=several(len(problems), "driver")), "verdict_fail", problems[0].problem
        words = "Virtual rig" if rig.driver == "virtual_rig" else rig.name
        colour = "verdict_pass" if cell.connected or rig.driver == "virtual_rig" else "soft"
        return words, colour, tr("{name}, connected", name=rig.name) if cell.connected else tr("{name}, not connected", name=rig.name)

    def _show_calibration(self) -> None:
        state = calibration_state(self._session.calibration, self._session.rig, self._session.validity)
        self._header.calibration.show_state(state.words, state.colour, state.tip)

    def _show_disk(self) -> None:
        folder = self._session.folder or Path.home()
        while not folder.exists():
            folder = folder.parent
        free = shutil.disk_usage(folder).free
        colour = "verdict_fail" if free < DISK_LOW_BYTES else "soft"
        self._header.disk.show_state(tr("{size} free", size=storage(free)), colour, tr("Free space at {folder}", folder=folder))
