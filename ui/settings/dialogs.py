"""Dialogs for files and folders, which open where the user was last for the same purpose; the window remembers."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QWidget

from ui.look.language.words import translated
from ui.settings.settings import Settings


def choose_file(parent: QWidget, title: str, kinds: str, purpose: str, start: Path | None = None) -> Path | None:
    """Let the user choose a file.

    Parameters
    ----------
    purpose : such as "nominals", by which the folder is remembered
    start : file or folder to begin at; None: where the user was last for this purpose
    """
    chosen, _ = QFileDialog.getOpenFileName(parent, translated(title), str(start or _remembered(parent, purpose)), translated(kinds))
    return _kept(parent, chosen, purpose)


def choose_folder(parent: QWidget, title: str, purpose: str, start: Path | None = None) -> Path | None:
    """Let the user choose a folder that exists; see `choose_file`."""
    return _kept(parent, QFileDialog.getExistingDirectory(parent, translated(title), str(start or _remembered(parent, purpose))), purpose)


def choose_new(parent: QWidget, title: str, name: str, purpose: str, kinds: str = "", start: Path | None = None) -> Path | None:
    """Let the user name a file or folder that is to be written; see `choose_file`."""
    chosen, _ = QFileDialog.getSaveFileName(parent, translated(title), str(start or _remembered(parent, purpose) / name), translated(kinds))
    return _kept(parent, chosen, purpose)


def _remembered(parent: QWidget, purpose: str) -> Path:
    settings = _settings_of(parent)
    return Path.home() if settings is None else settings.folder(purpose)


def _kept(parent: QWidget, chosen: str, purpose: str) -> Path | None:
    if not chosen:
        return None
    settings = _settings_of(parent)
    if settings is not None:
        settings.set_folder(purpose, Path(chosen).parent)
    return Path(chosen)


def _settings_of(widget: QWidget) -> Settings | None:
    """Return the settings of the main window to which a widget belongs; None for one that stands alone."""
    owner: QWidget | None = widget
    while owner is not None:
        settings = getattr(owner, "settings", None)
        if isinstance(settings, Settings):
            return settings
        owner = owner.parentWidget()
    return None
