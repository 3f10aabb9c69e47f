"""Dialogs for files and folders, which open where the user was last for the same purpose."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QWidget

from ui.settings.settings import Settings


def choose_file(parent: QWidget, title: str, kinds: str, purpose: str, settings: Settings) -> Path | None:
    """Let the user choose a file; ``purpose``: such as "nominal", by which the folder is remembered."""
    chosen, _ = QFileDialog.getOpenFileName(parent, title, str(settings.folder(purpose)), kinds)
    return _kept(chosen, purpose, settings)


def choose_folder(parent: QWidget, title: str, purpose: str, settings: Settings) -> Path | None:
    """Let the user choose a folder that exists."""
    chosen = QFileDialog.getExistingDirectory(parent, title, str(settings.folder(purpose)))
    if chosen:
        settings.set_folder(purpose, Path(chosen).parent)
    return Path(chosen) if chosen else None


def choose_new(parent: QWidget, title: str, name: str, purpose: str, settings: Settings, kinds: str = "") -> Path | None:
    """Let the user name a file or folder that is to be written."""
    chosen, _ = QFileDialog.getSaveFileName(parent, title, str(settings.folder(purpose) / name), kinds)
    return _kept(chosen, purpose, settings)


def _kept(chosen: str, purpose: str, settings: Settings) -> Path | None:
    if not chosen:
        return None
    settings.set_folder(purpose, Path(chosen).parent)
    return Path(chosen)
