"""Bar codes: a scanner's keys become one code, which is never guessed."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from measureapp.data.part_program import PartProgramFacts
from measureapp.language.catalogue import read_catalogue
from measureapp.language.translator import Translator
from ui.controllers.operator_codes import CodeFields, check_code, clean_code, find_program, read_code
from ui.controllers.operator_nouns import Entered
from ui.look.language.sources import catalogue_file
from ui.look.language.words import translated
from ui.pages.operator.scanner import FEWEST, SLOWEST_S, Scanner, TypedFast

CROSS = PartProgramFacts(
    name="Cross", part_number="GC-180", code_pattern=r"(?P<part>GC-180)\|(?P<serial>[A-Z0-9-]+)(?:\|(?P<order>[A-Z0-9-]+))?"
)
GEAR = PartProgramFacts(name="Gear", part_number="GW-24", code_pattern=r"(?P<part>[A-Z]+-\d+)\|(?P<serial>[A-Z0-9-]+)")
PLAIN = PartProgramFacts(name="Plain", part_number="PL-1")
PROGRAMS = (CROSS, None, GEAR, PLAIN)


@pytest.mark.parametrize(
    ("typed", "code"),
    [("]d2GC-180\x1dA7\r", "GC-180\x1dA7"), ("]C1123\t", "123"), ("\x1dGC-180", "GC-180"), ("  plain \n", "plain"), ("", "")],
)
def test_prefix_separators_and_line_ends_are_taken_off(typed, code):
    assert clean_code(typed) == code


def test_a_code_states_part_serial_number_and_order():
    assert read_code("]d2GC-180\x1dS-9\x1dA-77", CROSS) == CodeFields("GC-180", "S-9", "A-77")
    assert read_code("GC-180|S-9", CROSS) == CodeFields("GC-180", "S-9")
    assert read_code("GC-180|S-9|A-77|more", CROSS) is None  # only the whole code counts


def test_a_code_chooses_its_program_and_an_unknown_one_chooses_none():
    assert (find_program("GC-180|S-9", PROGRAMS).program, find_program("GW-24|7", PROGRAMS).program) == (0, 2)
    assert find_program("PL-1", PROGRAMS).program == 3
    for unknown in ("4711", "XX-1|S-9", "", "GC-18"):
        assert find_program(unknown, PROGRAMS).kind == "unknown"


def test_a_code_that_fits_two_programs_is_left_to_the_operator():
    other = PartProgramFacts(name="Other", code_pattern=r"(?P<serial>GC-180\|.*)")
    found = find_program("GC-180|S-9", (CROSS, other))
    assert found.kind == "ambiguous" and found.names == ("Cross", "Other")


def test_the_code_of_another_part_is_a_wrong_part():
    wrong = check_code("GC-180|S-9", GEAR, PROGRAMS)
    assert wrong.kind == "wrong part" and wrong.fields.part == "GC-180"
    assert check_code("GW-24|7", CROSS, PROGRAMS).kind == "wrong part"
    assert check_code("S-9", CROSS, PROGRAMS).kind == "unknown"
    assert check_code("S-9", PLAIN, PROGRAMS).fields.serial == "S-9"  # the operator sees and confirms it


def test_a_pattern_must_be_one_and_name_what_it_finds():
    for pattern in ("(", "(?P<serial>a)(?P<lot>b)", "no group"):
        with pytest.raises(ValueError, match=r"regular expression|name the groups"):
            PartProgramFacts(name="x", code_pattern=pattern)


def test_slow_keys_are_typed_by_a_person():
    typed, now_s = TypedFast(), 0.0
    for letter in "ABCD":
        typed.add(letter, now_s)
        now_s += SLOWEST_S * 1.01
    assert typed.end(now_s) == ""
    for letter in "ABCD"[: FEWEST - 1]:
        typed.add(letter, now_s)
        now_s += SLOWEST_S / 10
    assert typed.end(now_s) == ""  # too short
    for letter in "ABCD":
        typed.add(letter, now_s)
        now_s += SLOWEST_S / 10
    assert typed.end(now_s) == "ABCD"


@pytest.fixture
def scan(workshop, monkeypatch):
    now_s = [0.0]
    monkeypatch.setattr(workshop.screens.scanner, "_clock", lambda: now_s[0])

    def scan(code, end=Qt.Key.Key_Return):
        handle = workshop.window.windowHandle()
        for letter in code:
            now_s[0] += 0.002
            QTest.keyClick(handle, Qt.Key.Key_F8 if letter == "\x1d" else letter)
        QTest.keyClick(handle, end)
        now_s[0] += 1.0

    return scan


def test_a_scan_before_the_start_presses_nothing_and_is_compared_with_the_part(workshop, scan):
    screens, operator = workshop.screens, workshop.operator
    scan("]d2GC-180\x1dS-9\x1dA-77")
    screens.identify.fields["operator"].setText("Name")
    operator.identify(screens.identify.value())
    assert screens.screens.currentWidget() is screens.load
    pressed = []
    screens.load.start.pressedOnce.connect(lambda: pressed.append(True))
    screens.load.start.setEnabled(True)
    screens.load.start.setFocus()
    scan("GC-180 S-1")
    assert not pressed and "was not entered" in screens._words.text() and operator.entered.serial == "S-9"
    scan("]d2GC-180\x1dS-9\x1dA-77")
    assert not pressed and screens._words.text() == "The code belongs to this part."


def test_what_an_operator_typed_is_never_translated(workshop, monkeypatch):
    chinese = Translator()
    chinese.use(read_catalogue(catalogue_file("zh_CN")))
    monkeypatch.setattr("ui.look.language.words.TRANSLATOR", chinese)
    screens, operator = workshop.screens, workshop.operator
    operator.choose(operator.shelf.cards[0])
    assert translated("Name") != "Name"
    operator.entered = Entered(operator="Name")
    operator.enteredChanged.emit()
    assert screens.identify.fields["operator"].text() == "Name"


@pytest.mark.parametrize("end", [Qt.Key.Key_Return, Qt.Key.Key_Tab])
def test_a_scan_is_taken_wherever_the_focus_is_and_the_field_is_as_before(workshop, scan, end):
    screens = workshop.screens
    screens.home.search.setText("old words")
    screens.home.search.setFocus()
    scan("GC-999|S9", end)
    assert screens.home.search.text() == "old words"
    assert "belongs to no part program" in screens._words.text() and screens.screens.currentWidget() is screens.home
    scan("]d2GC-180\x1dS-9\x1dA-77", end)
    assert screens.screens.currentWidget() is screens.identify
    assert [screens.identify.fields[name].text() for name in ("serial", "order")] == ["S-9", "A-77"]
    screens.identify.fields["remarks"].setFocus()
    scan("GW-24|G-1", end)
    assert screens._words.text() == "Wrong part: the code is of part GW-24, this program measures part GC-180."
    assert screens.identify.fields["serial"].text() == "S-9" and screens.identify.fields["remarks"].text() == ""


def test_a_person_types_into_the_field_as_ever(workshop):
    search = workshop.screens.home.search
    search.setFocus()
    for letter in "gear":
        QTest.keyClick(workshop.window.windowHandle(), letter, delay=60)
    assert search.text() == "gear"
    QTest.qWait(60)
    QTest.keyClick(workshop.window.windowHandle(), Qt.Key.Key_Return)
    assert workshop.operator.facts.name == "Gear"


def test_no_code_is_taken_where_none_is_wanted(qtbot, workshop):
    scanner = Scanner(lambda: False, workshop.screens)
    taken = []
    scanner.scanned.connect(taken.append)
    scanner.watch(workshop.window.windowHandle())
    for letter in "ABCDEF":
        QTest.keyClick(workshop.window.windowHandle(), letter)
    QTest.keyClick(workshop.window.windowHandle(), Qt.Key.Key_Return)
    workshop.window.windowHandle().removeEventFilter(scanner)
    assert not taken
