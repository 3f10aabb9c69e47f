"""Dialogs for files open where the user was last for the same purpose."""

from __future__ import annotations

from pathlib import Path
from unittest.mock import patch

from PySide6.QtWidgets import QFileDialog, QWidget

from ui.look.look import Look
from ui.settings.dialogs import choose_file, choose_folder, choose_new
from ui.settings.settings import Settings
from ui.widgets.path_field import PathField

ASKED = ("getOpenFileName", "getSaveFileName", "getExistingDirectory")


class Window(QWidget):
    def __init__(self) -> None:
        super().__init__()
        self.settings = Settings()


class Dialogs:
    """Answers file dialogs, and keeps where they opened."""

    def __init__(self, answer: Path) -> None:
        self.starts: list[str] = []
        self._answer = answer

    def __enter__(self) -> Dialogs:
        def one(_parent, _title, start, *_more):
            self.starts.append(start)
            return str(self._answer), ""

        def folder(_parent, _title, start):
            self.starts.append(start)
            return str(self._answer)

        self._patch = patch.multiple(QFileDialog, getOpenFileName=one, getSaveFileName=one, getExistingDirectory=folder)
        self._patch.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self._patch.stop()


def test_each_purpose_has_a_folder_of_its_own(qtbot, tmp_path):
    window = Window()
    qtbot.addWidget(window)
    inner = QWidget(window)
    nominals, exports = tmp_path / "nominals", tmp_path / "exports"
    nominals.mkdir()
    exports.mkdir()
    with Dialogs(nominals / "part.stl"):
        assert choose_file(inner, "Nominal", "*.stl", "nominals") == nominals / "part.stl"
    with Dialogs(exports / "report.pdf"):
        choose_new(inner, "Export", "report.pdf", "exports")
    with Dialogs(tmp_path) as dialogs:
        choose_file(inner, "Nominal", "*.stl", "nominals")
        choose_new(inner, "Export", "other.pdf", "exports")
        choose_folder(inner, "Export", "exports", start=nominals)
    assert dialogs.starts == [str(nominals), str(exports / "other.pdf"), str(nominals)]


def test_a_field_for_a_path_begins_at_what_it_holds_and_else_where_its_purpose_was(qtbot, tmp_path):
    window = Window()
    qtbot.addWidget(window)
    field = PathField(Look("light"), "Plan", "None", "plans", files="Plans (*.toml)")
    field.setParent(window)
    with Dialogs(tmp_path / "plan.toml") as dialogs:
        field.browse.click()
        field.browse.click()
        field.setValue(None)
        field.browse.click()
    assert dialogs.starts == [str(Path.home()), str(tmp_path / "plan.toml"), str(tmp_path)]


def test_no_other_code_of_the_window_asks_for_files(qtbot):
    """So that no dialog forgets its folder."""
    root = Path(__file__).resolve().parents[3] / "ui"
    asking = [path.name for path in root.rglob("*.py") if any(name in path.read_text(encoding="utf-8") for name in ASKED)]
    assert asking == ["dialogs.py"]
