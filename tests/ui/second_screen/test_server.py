"""Commands of a driver, and what happens when the screen goes."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtGui import QGuiApplication

from ui.second_screen.screens import native_size_px
from ui.second_screen.server import Server
from ui.second_screen.window import PatternWindow


class Talk:
    """A server, and the lines that it wrote."""

    def __init__(self, application: QGuiApplication) -> None:
        self.screen = application.primaryScreen()
        self.width, self.height = native_size_px(self.screen)
        self.window = PatternWindow(self.screen, self.width, self.height)
        self.window.showFullScreen()
        self.lines: list[dict[str, Any]] = []
        self.server = Server(self.screen, self.window, self.width, self.height, lambda line: self.lines.append(json.loads(line)))

    def ask(self, **command: Any) -> dict[str, Any]:
        self.server.receive(json.dumps({"id": 7} | command))
        return self.lines[-1]


@pytest.fixture
def talk(qapp: QGuiApplication) -> Iterator[Talk]:
    made = Talk(qapp)
    yield made
    made.window.close()
    made.window.destroy()
    made.window.deleteLater()
    made.server.deleteLater()


@pytest.fixture
def loaded(talk: Talk, tmp_path: Path) -> Talk:
    images = np.arange(3, dtype=np.uint8)[:, None, None] * np.ones((talk.height, talk.width), np.uint8)
    images.tofile(tmp_path / "images.raw")
    assert talk.ask(do="load", file=str(tmp_path / "images.raw")) == {"id": 7, "count": 3}
    return talk


def test_loading_makes_it_dark(loaded: Talk) -> None:
    assert loaded.ask(do="state") == {"id": 7, "shown": -2}


def test_images_uniform_light_and_dark_read_back(loaded: Talk) -> None:
    assert loaded.ask(do="show", index=2) == {"id": 7, "shown": 2}
    assert loaded.ask(do="show", level=255)["shown"] == -1
    assert loaded.ask(do="show", level=0)["shown"] == -2
    assert loaded.ask(do="state")["shown"] == -2


def test_an_image_that_does_not_exist_is_refused_and_nothing_changes(loaded: Talk) -> None:
    loaded.ask(do="show", index=1)
    assert "none is 3" in loaded.ask(do="show", index=3)["error"]
    assert loaded.ask(do="state")["shown"] == 1


@pytest.mark.parametrize("line", ["rubbish", "[]", "{}", '{"id": 1}', '{"id": 1, "do": "dance"}', '{"id": 1, "do": "show"}'])
def test_what_is_no_command_is_refused_in_words(talk: Talk, line: str) -> None:
    talk.server.receive(line)
    assert "cannot be executed" in talk.lines[-1]["error"]


def test_a_file_of_another_size_is_refused(talk: Talk, tmp_path: Path) -> None:
    (tmp_path / "images.raw").write_bytes(bytes(1001))
    assert "cannot be executed: ValueError" in talk.ask(do="load", file=str(tmp_path / "images.raw"))["error"]


def test_no_pattern_appears_on_another_screen_when_this_one_is_gone(loaded: Talk, qapp: QGuiApplication) -> None:
    loaded.ask(do="show", index=1)
    qapp.screenRemoved.emit(loaded.screen)
    assert loaded.lines[-1]["event"] == "lost"
    assert "was disconnected" in loaded.lines[-1]["error"]
    assert not loaded.window.isVisible()
    refusal = loaded.ask(do="show", index=1)
    assert refusal["lost"] and "was disconnected" in refusal["error"]


def test_a_changed_mode_is_a_loss(loaded: Talk) -> None:
    loaded.screen.refreshRateChanged.emit(120.0)
    assert "mode of the screen" in loaded.lines[-1]["error"]
    assert loaded.ask(do="state")["lost"]
