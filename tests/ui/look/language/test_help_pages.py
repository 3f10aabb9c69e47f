"""The help pages say the same in every language, in the words that the window displays in that language."""

from __future__ import annotations

import re
from collections import Counter

import pytest
from PySide6.QtGui import QTextDocument, QTextTable

from measureapp.errors import InputError
from measureapp.language.catalogue import Catalogue, Entry, read_catalogue
from measureapp.resources import resource
from ui.look.language import __main__ as command
from ui.look.language import help_pages
from ui.look.language.help_pages import help_file, outdated, page_names, read_help, renew
from ui.look.language.language import LANGUAGES

OTHERS = [language for language in LANGUAGES if language != "en"]
PAGES = [(language, name) for language in OTHERS for name in page_names()]
CODE, LINK = re.compile(r"`([^`]+)`"), re.compile(r"\]\(([^)]+)\)")
NAME = re.compile(r"\*\*(.+?)\*\*|(?<!\*)\*([^*\n]+?)\*(?!\*)")  # bold or italic
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?![\w.]*-D\b)")
COMMENT = re.compile(r"\s+# .*")
KINDS = {  # of lines, by how they begin
    "heading": r"#{1,6} ",
    "item": r"- ",
    "step": r"\d+\. ",
    "row": r"\|",
    "fence": r"```",
    "code": r" {4}",
}


def lines_of(text: str) -> list[tuple[str, str]]:
    """Return the kind and the text of each line; code without its comments."""
    found, fenced = [], False
    for line in text.splitlines():
        kind = next((kind for kind, begins in KINDS.items() if re.match(begins, line)), "text")
        fenced ^= kind == "fence"
        is_code = kind in ("fence", "code") or fenced
        level = line.split(" ")[0] if kind == "heading" else str(line.count("|")) if kind == "row" else ""
        found.append(("code" if is_code else kind + level, COMMENT.sub("", line) if is_code else line))
    return found


def names_in(line: str) -> list[str]:
    """Return what is bold or italic in a line outside of code."""
    return [bold or italic for bold, italic in NAME.findall(CODE.sub("", line))]


def expected_words(catalogue: Catalogue, name: str) -> str | None:
    """Return what the window displays for a name, without marks at its end; None for emphasis that is no name of the window."""
    bare = name.rstrip(".…")
    cases = (bare, bare[:1].upper() + bare[1:], bare[:1].lower() + bare[1:])
    sources = [name, *(one + mark for mark in ("", "…", ".") for one in cases)]
    found = next((made for one in sources if (made := catalogue.translation(one))), None)
    return None if found is None else found.rstrip("….。")


def missing_words(catalogue: Catalogue, english: str, translation: str) -> list[str]:
    """Return the names of a line that its translation does not state as the window does."""
    stated = Counter(part.rstrip("….。") for one in names_in(translation) for part in one.split(" → "))
    found = []
    for name in (part for one in names_in(english) for part in one.split(" → ")):
        words = expected_words(catalogue, name)
        if words is not None and not stated[words]:
            found.append(f"{name} = {words}")
        elif words is not None:
            stated[words] -= 1
    return found


def test_every_language_has_every_page_of_the_present_english_text():
    assert page_names()
    for language in OTHERS:
        assert page_names(language) == page_names()
        assert outdated(language) == [], "translate what has changed, then: python -m ui.look.language --help-page NAME"


@pytest.mark.parametrize(("language", "name"), PAGES)
def test_a_translation_has_the_lines_code_numbers_and_links_of_its_page(language, name):
    catalogue = read_catalogue(resource(f"languages/measureapp_{language}.ts"))
    english, translation = lines_of(read_help(name, None)), lines_of(read_help(name, catalogue))
    assert [kind for kind, _ in translation] == [kind for kind, _ in english]
    for (kind, text), (_, made) in zip(english, translation, strict=True):
        if kind == "code":
            assert made == text
            continue
        for what in (CODE, LINK):
            assert Counter(what.findall(made)) == Counter(what.findall(text)), made
        assert Counter(NUMBER.findall(CODE.sub("", made))) == Counter(NUMBER.findall(CODE.sub("", text))), made
        assert len(names_in(made)) == len(names_in(text)), made


@pytest.mark.parametrize(("language", "name"), PAGES)
def test_a_translation_names_buttons_and_pages_as_the_window_does(language, name):
    catalogue = read_catalogue(resource(f"languages/measureapp_{language}.ts"))
    lines = zip(read_help(name, None).splitlines(), read_help(name, catalogue).splitlines(), strict=True)
    assert [found for english, made in lines if (found := missing_words(catalogue, english, made))] == []


@pytest.mark.parametrize(("language", "name"), PAGES)
def test_emphasis_is_drawn_as_such(qapp, language, name):
    """Marks between ideographs and punctuation may be taken for asterisks."""
    document = QTextDocument()
    document.setMarkdown(read_help(name, read_catalogue(resource(f"languages/measureapp_{language}.ts"))))
    assert re.search(r"\*\*|`", document.toPlainText()) is None


def test_a_page_that_changed_is_named_until_its_translation_is_renewed(tmp_path, monkeypatch, capsys):
    (tmp_path / "zh_CN").mkdir()
    (tmp_path / "scan.md").write_text("# Scan\n", encoding="utf-8")
    (tmp_path / "zh_CN" / "scan.md").write_text("# 扫描\n", encoding="utf-8")
    monkeypatch.setattr(help_pages, "resource", lambda _path: tmp_path)
    catalogue = Catalogue("zh_CN")
    assert outdated("zh_CN") == ["scan"]
    assert command.main(["--help-page", "scan"]) == 0 and capsys.readouterr().out == ""
    assert outdated("zh_CN") == [] and read_help("scan", catalogue) == "# 扫描\n"
    (tmp_path / "scan.md").write_text("# Scan it\n", encoding="utf-8")
    (tmp_path / "plan.md").write_text("# Plan\n", encoding="utf-8")
    assert outdated("zh_CN") == ["plan", "scan"]
    assert read_help("plan", catalogue) == "# Plan\n", "a page without translation is shown in English"
    renew("scan", "zh_CN")
    assert outdated("zh_CN") == ["plan"] and help_file("scan", "zh_CN").read_text(encoding="utf-8").count("translates") == 1
    with pytest.raises(InputError):
        renew("plan", "zh_CN")


def test_a_name_in_other_words_than_the_window_is_found():
    catalogue = Catalogue("zh_CN", {text: Entry(text, made) for text, made in {"Save as…": "另存为…", "Residual": "残差"}.items()})
    english = "**Save as…** writes it, `x` **residual** and **Edit → Save as…** too; **Nowhere** is no name."
    assert missing_words(catalogue, english, "**另存为…** 写入，**残差**，**编辑 → 另存为…** 也是；**无处**不是名称。") == []
    assert missing_words(catalogue, english, "**保存为…** 写入，**余差**。") == [
        "Save as… = 另存为",
        "residual = 残差",
        "Save as… = 另存为",
    ]


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_line_of_a_page_is_cut_and_tables_have_the_colours_of_the_theme(application, window, qtbot, language):
    application.settings.set_text("language", language)
    window.help.resize(640, 500)
    for name in page_names():
        window.help.show_page(name)
        qtbot.wait(10)
        browser = window.help.browser
        assert browser.horizontalScrollBar().maximum() == 0, name
        for table in (one for one in browser.document().rootFrame().childFrames() if isinstance(one, QTextTable)):
            assert table.format().borderBrush().color() == application.look.theme.colour("line")
    window.help.close()


def test_open_help_follows_the_language_and_the_theme_at_the_same_paragraph(application, window, qtbot):
    window.show_page("clouds")
    window.show_help()
    browser = window.help.browser
    bar = browser.verticalScrollBar()
    qtbot.waitUntil(lambda: bar.maximum() > 0)
    assert browser.toPlainText().startswith("Clouds") and bar.value() == 0
    heading = browser.document().find("Images, maps and profiles")
    bar.setValue(round(browser.document().documentLayout().blockBoundingRect(heading.block()).top()))
    application.settings.set_text("language", "zh_CN")
    application.language.retranslation.finish()
    assert browser.toPlainText().startswith("点云") and window.help.windowTitle() == "帮助"
    assert browser.cursorForPosition(browser.viewport().rect().topLeft()).block().text() == "图像、分布图和剖面"
    for theme in ("dark", "light"):
        application.settings.set_text("theme", theme)
        assert application.look.theme.colours["accent_text"].lower() in browser.document().toHtml().lower()
    browser.anchorClicked.emit("inspection.md")
    assert browser.toPlainText().startswith("检测") and bar.value() == 0
    application.settings.set_text("language", "en")
    application.language.retranslation.finish()
    assert browser.toPlainText().startswith("Inspect") and window.help.windowTitle() == "Help"
    window.help.close()
