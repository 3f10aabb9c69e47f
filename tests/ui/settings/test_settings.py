"""Settings survive a restart; whatever the file holds, the window opens."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QRect
from PySide6.QtWidgets import QSplitter, QWidget

from ui.settings.layout import fitted, keep_window, remember, restore_window
from ui.settings.settings import SCHEMA, Settings

SCREEN = QRect(0, 0, 1920, 1040)
LEAST = QRect(0, 0, 1280, 648)


@pytest.fixture
def file(tmp_path, qapp):
    return tmp_path / "MeasureApp" / "settings.ini"


def test_what_is_set_is_there_at_the_next_start(file, tmp_path):
    first = Settings(file)
    first.set_text("theme", "dark")
    first.set_text("page", "clouds")
    first.set_folder("nominal", tmp_path)
    first.set_numbers("splitter-clouds", (300, 500))
    first.save()
    again = Settings(file)
    assert again.text("theme") == "dark" and again.text("page") == "clouds"
    assert again.folder("nominal") == tmp_path
    assert again.numbers("splitter-clouds") == (300, 500)
    assert f"schema = {SCHEMA}" in again.lines()


def test_a_setting_announces_its_change_once(file, qtbot):
    settings, told = Settings(file), []
    settings.changed.connect(told.append)
    settings.set_text("theme", "dark")
    settings.set_text("theme", "dark")
    assert told == ["theme"]
    with pytest.raises(ValueError, match="theme cannot be 'pink'"):
        settings.set_text("theme", "pink")


@pytest.mark.parametrize(
    "foreign",
    [
        "[window]\ntheme=@Variant(\\0\\0\\0\\x7f)\npage=\nrole=a, b\n[layout]\nwindow=x y z\nsplitter-clouds=@Invalid()\n[folders]\nnominal=/nowhere\\0\n",
        "no ini at all\n[[[",
        "[General]\nschema=later\n[window]\ntheme=7\n",
        b"\xff\xfe\x00\x80 not text",
        "",
    ],
)
def test_foreign_values_give_the_defaults_and_never_an_error(file, foreign):
    file.parent.mkdir()
    file.write_bytes(foreign if isinstance(foreign, bytes) else foreign.encode())
    settings = Settings(file)
    assert settings.text("theme") == "system" and settings.text("page") == "rig" and settings.text("role") == "engineer"
    assert settings.numbers("window") == () and settings.numbers("splitter-clouds") == ()
    assert settings.folder("nominal").is_dir()
    settings.set_text("theme", "light")
    settings.save()
    assert Settings(file).text("theme") == "light"


def test_settings_of_the_first_version_are_taken_over(file):
    file.parent.mkdir()
    file.write_text("[General]\nschema=1\nshade=dark\n", encoding="utf-8")
    settings = Settings(file)
    assert settings.text("theme") == "dark" and not settings.is_newer
    assert f"schema = {SCHEMA}" in settings.lines() and "shade = dark" not in settings.lines()


def test_settings_of_a_newer_version_are_read_as_far_as_known_and_keep_their_number(file):
    file.parent.mkdir()
    file.write_text("[General]\nschema=99\n[window]\ntheme=dark\nhologram=on\n", encoding="utf-8")
    settings = Settings(file)
    assert settings.is_newer and settings.text("theme") == "dark"
    settings.save()
    assert "schema = 99" in Settings(file).lines()


def test_a_folder_that_cannot_be_written_is_no_reason_to_stop(tmp_path, qapp):
    blocked = tmp_path / "a file"
    blocked.write_text("", encoding="utf-8")
    settings = Settings(blocked / "settings.ini")
    settings.set_text("theme", "dark")
    settings.save()
    assert settings.text("theme") == "dark"


@pytest.mark.parametrize(
    ("wanted", "placed"),
    [
        (QRect(100, 100, 1300, 800), QRect(100, 100, 1300, 800)),
        (QRect(1700, 20, 1300, 800), QRect(1700, 20, 1300, 800)),  # enough of the title bar is in sight
        (QRect(0, 0, 4000, 3000), QRect(0, 0, 1920, 1040)),
        (QRect(0, 0, 200, 100), QRect(0, 0, 1280, 648)),
    ],
)
def test_a_window_comes_back_where_it_was(wanted, placed):
    assert fitted(wanted, [SCREEN], LEAST) == placed


@pytest.mark.parametrize("lost", [QRect(2500, 100, 1300, 800), QRect(100, -900, 1300, 800), QRect(-1290, 0, 1300, 800)])
def test_a_window_of_a_screen_that_is_gone_comes_to_the_first_one(lost):
    assert SCREEN.contains(fitted(lost, [SCREEN], LEAST))


def test_splitters_and_windows_keep_their_sizes(file, qtbot):
    settings = Settings(file)
    for wide in (300, 600):
        splitter = QSplitter()
        qtbot.addWidget(splitter)
        for _ in range(2):
            splitter.addWidget(QWidget())
        splitter.resize(1000, 100)
        remember(splitter, "clouds", settings)
        splitter.show()
        if wide == 600:
            assert splitter.sizes()[0] == 300
        splitter.moveSplitter(wide, 1)
    window = QWidget()
    qtbot.addWidget(window)
    window.setGeometry(40, 50, 700, 500)
    keep_window(window, settings)
    window.setGeometry(0, 0, 300, 300)
    restore_window(window, settings)
    assert window.size().width() == 700
    settings.forget_layout()
    assert settings.numbers("window") == ()
