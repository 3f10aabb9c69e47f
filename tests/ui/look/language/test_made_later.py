"""What is made after a language was chosen is in it: menus, dialogs, forms of fields, problems of what was entered, sentences of the core."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

import pytest
from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QMenu, QWidget

from measureapp.data.identification import LABELS, Identification
from measureapp.data.rig import HeadRules
from measureapp.devices.plugin_loader import load_all
from measureapp.inspection.programming.proposals import Proposal
from measureapp.language.catalogue import read_catalogue
from measureapp.language.translator import Translator
from tests.ui.look.language.displayed import displayed_texts
from ui.actions.actions import Action, Actions
from ui.controllers.report_header import ReportHeader, TemplateChoice
from ui.look.language.sources import ROOT, catalogue_file
from ui.look.language.words import translated
from ui.pages.inspection.create_bar import CONSTRUCTIONS, CreateBar, proposal_words
from ui.pages.plan.generate_dialog import GenerateDialog
from ui.pages.report_header import HeaderDialog
from ui.pages.rig.rig_editor import RigEditor
from ui.widgets.field_editors import ChoiceEditor
from ui.widgets.model_form import FieldRows, GroupEditor

SETTERS = {  # of Qt, which display what they get as it is
    *("addAction", "addMenu", "addItem", "setText", "setToolTip", "setWindowTitle", "setSuffix", "setPrefix", "setTitle"),
    *("setPlaceholderText", "setAccessibleName", "setAccessibleDescription", "setSpecialValueText"),
}
WORD = re.compile(r"[A-Za-z]{3}")
SHOWN_ELSEWHERE = {"second_screen"}  # a window of another program, on the projector
UNITS = {"min"}


def untranslated(node: ast.expr) -> bool:
    """Whether an argument is English for certain: a constant, or a message of an error."""
    if isinstance(node, ast.Constant):
        return isinstance(node.value, str) and WORD.search(node.value) is not None and node.value.strip() not in UNITS
    if isinstance(node, ast.Name):
        return node.id.isupper() and len(node.id) > 1
    if isinstance(node, ast.Subscript):
        return untranslated(node.value)
    if isinstance(node, ast.IfExp):
        return untranslated(node.body) or untranslated(node.orelse)
    if isinstance(node, ast.JoinedStr):
        return any(untranslated(piece.value if isinstance(piece, ast.FormattedValue) else piece) for piece in node.values)
    return isinstance(node, ast.Attribute) and node.attr in ("message", "hint", "verdict")


def english_setters() -> Iterator[str]:
    for path in sorted((ROOT / "ui").rglob("*.py")):
        if SHOWN_ELSEWHERE & set(path.relative_to(ROOT / "ui").parts):
            continue
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            setter = isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in SETTERS
            if setter and node.args and untranslated(node.args[0]):
                yield f"{path.relative_to(ROOT)}:{node.lineno} {ast.unparse(node)}"


def test_no_setter_of_qt_gets_an_english_constant():
    assert "\n".join(english_setters()) == ""


def test_no_message_is_merely_joined_with_its_hint():
    """A joined text is of no template, so that it would stay in English: see `with_hint`."""
    found = []
    for path in sorted((ROOT / "ui").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.JoinedStr):
                names = {one.attr for one in ast.walk(node) if isinstance(one, ast.Attribute)}
                found += [f"{path.relative_to(ROOT)}:{node.lineno}"] if {"message", "hint"} <= names else []
    assert not found


@pytest.fixture
def chinese(application) -> Iterator[Translator]:
    made = Translator()
    made.use(read_catalogue(catalogue_file("zh_CN")))
    return made


def test_menus_of_a_page_are_in_the_language_that_was_chosen_before(filled, speaking, english_left):
    speaking("zh_CN")
    menu = QMenu(filled)
    filled.pages["inspection"].side.actions._fill(menu)
    assert len(menu.actions()) > 10 and not english_left(displayed_texts(menu))
    offers = filled.pages["calibration"].offers
    assert offers and not english_left(("menu", action.text()) for action in offers.values())


def test_constructions_and_proposals_are_in_the_language(application, window, speaking, english_left, monkeypatch):
    speaking("zh_CN")
    bar = window.pages["inspection"].findChild(CreateBar)
    monkeypatch.setattr(bar._creating, "constructions", lambda _names: tuple(CONSTRUCTIONS))
    bar.show_proposals()
    assert len(bar.menu.actions()) == len(CONSTRUCTIONS) and not english_left(displayed_texts(bar.menu))
    said = [proposal_words(Proposal(kind, (), ({"nominal": 3.0},))) for kind in ("diameter", "pitch_circle", "angle", "cone_angle")]
    assert not english_left(("proposal", words.replace("mm", "")) for words in said)


def test_keywords_are_found_in_the_language_that_the_window_began_in(application, window, speaking):
    speaking("zh_CN")
    late = Actions(window)
    late.register(Action("late", translated("Settings…"), list, window.actions_.action("settings").keywords))
    assert [action.id for action in late.find("⟦language")] == ["late"]


def test_every_field_of_a_rig_and_of_its_drivers_has_its_texts_in_the_language(application, rig, qtbot, speaking, english_left):
    speaking("zh_CN")
    editor = RigEditor(application.look, rig, None, load_all())
    qtbot.addWidget(editor)
    for name in editor.sections:
        editor.show_section(name)
    forms = [editor, *(form_of(model, qtbot) for model in setting_models())]
    texts = [text for form in forms for text in field_texts(form)]
    assert len(forms) > 8 and not english_left(texts)
    assert sum(kind == "tooltip" and bool(text) for kind, text in texts) > 150
    assert ("choice", "⟦Software⟧") in texts and ("choice", "⟦{bits} bit ({name})⟧".format(bits=8, name="Mono8")) in texts


def test_values_of_choices_follow_the_language_and_names_of_cameras_do_not(application, qtbot, speaking):
    form = form_of(HeadRules, qtbot)
    cameras = ChoiceEditor(["left", "Name"])
    qtbot.addWidget(cameras)
    speaking("zh_CN")
    boxes = form.editors["sequence"].box, cameras.box
    assert [[box.itemText(place) for place in range(2)] for box in boxes] == [["⟦Software⟧", "⟦Hardware⟧"], ["left", "Name"]]
    speaking("en")
    assert form.editors["sequence"].box.currentText() == "Software" and form.raw() == {"sequence": "software"}


def test_the_names_of_drivers_are_translated(chinese):
    for offer in load_all():
        assert chinese.renewed(offer.row.name) != offer.row.name


def setting_models() -> list[type]:
    """Return the settings of all drivers that are shipped, and of their links."""
    models: list[type] = []
    for row in load_all():
        for driver in getattr(row, "drivers", {}).values():
            models += [one for one in (driver.settings, driver.link) if one is not None]
    return models


def form_of(model: type, qtbot) -> FieldRows:
    made = FieldRows(model)
    qtbot.addWidget(made)
    return made


def field_texts(form: QWidget) -> Iterator[tuple[str, str]]:
    """Yield labels, tooltips and choices of all fields, also of those that are folded."""
    for rows in (form, *form.findChildren(FieldRows)):
        if isinstance(rows, FieldRows):
            for editor in rows.editors.values():
                yield "accessible name", editor.accessibleName()
                yield "tooltip", editor.toolTip()
                if isinstance(editor, GroupEditor):
                    yield from field_texts(editor.rows)
                for choice in (editor, *editor.findChildren(ChoiceEditor)):
                    if isinstance(choice, ChoiceEditor):
                        yield from (("choice", choice.box.itemText(place)) for place in range(choice.box.count()))


def test_the_header_of_a_report_is_in_the_language(application, qtbot, speaking, english_left, chinese):
    speaking("zh_CN")
    own = TemplateChoice("")
    dialog = HeaderDialog(application.look, ReportHeader(Identification(), "", None, own, (own,)))
    qtbot.addWidget(dialog)
    assert not english_left(displayed_texts(dialog))
    for name, entered in (("temperature_c", "warm"), ("humidity_percent", "120"), ("part_temperature", "cold")):
        dialog.fields[name].setText(entered)
        dialog.accept_button.click()
        assert f"⟦{LABELS[name]}⟧" in dialog.problem.text() and not english_left([("problem", dialog.problem.text())])
        dialog.fields[name].clear()
    assert chinese.renewed("Temperature (°C): Enter a number.") == "温度 (°C)：请输入数字。"


def test_the_suffix_of_a_number_follows_the_language(application, window, qtbot, speaking, english_left):
    dialog = GenerateDialog(application.look, application.controllers.planning)
    qtbot.addWidget(dialog)
    speaking("zh_CN")
    assert not english_left(displayed_texts(dialog))
    speaking("en")
    assert dialog.count.suffix() == " viewpoints"


def test_an_impossible_waiting_time_is_refused_in_words(application, filled, speaking):
    from measureapp.planning import edit

    planning = application.controllers.planning
    planning.edit("Set the waiting time", lambda plan: edit.set_settle(plan, [next(iter(plan)).id], 100.0))
    assert application.session.messages[-1].text == "This is impossible: Settling time: Must be at most 60."


def test_the_state_of_a_plan_follows_the_language(application, filled, qtbot, speaking, english_left):
    page = filled.pages["plan"]
    filled.show_page("plan")
    qtbot.waitUntil(lambda: " · " in page.state.text(), timeout=30_000)
    before = page.state.text()
    speaking("zh_CN")
    assert not english_left([("state", page.state.text())])
    speaking("en")
    assert page.state.text() == before


@pytest.mark.parametrize(
    ("english", "words"),
    [
        ("view04: image 7 at 40 ms", "view04：图像 7，40 ms"),
        ("Plate top: 22851 points, 377 rejected, blade tops: 4181 points, 12 rejected", ""),
        ("The datums plate top do not fix the location of bore: free are translation along z, rotation about x", ""),
        ("Surroundings", "周围物体"),
        ("Take 10 more views, each with another tilt and place, to average the noise.", "以平均噪声。"),
        ("a.png is not a readable image. Use an undamaged PNG, TIFF or BMP of 8 or 16 bit.", "16 位 PNG、TIFF 或 BMP。"),
        ("part/stacks has 0.0 GB free; the images need 0.5 GB and 0.5 GB more.", "另需预留 0.5 GB"),
        ("The board is too dark: its white is 40 of 255.", "太暗"),
        ("Adds 0.021 mm (k = 2), at worst 0.131 mm, to a length of 300 mm in this volume: usable.", "可用。"),
    ],
)
def test_sentences_of_the_core_are_not_mixed(chinese, english, words):
    said = chinese.renewed(english)
    assert words in said
    assert not re.findall(
        r"\b(?:image|points|rejected|location|free|translation|rotation|Surroundings|usable|Use|noise|free|white)\b", said
    ), said


def test_chinese_names_can_be_read_in_an_english_window(application):
    assert application.language.name == "en"
    assert any("CJK SC" in family for family in QFontDatabase.families())
