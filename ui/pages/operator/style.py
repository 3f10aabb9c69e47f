"""Style of operator mode: large letters and targets, readable at two metres; a sheet of its own below the window's style."""

from __future__ import annotations

from string import Template

from ui.look.theme import Theme

CARD_PX = (336, 384)
DARK_LETTERS = "#182126"
SHEET = Template("""
#operator, #operator QScrollArea, #operator QWidget#clear { background: $window; border: none; }
#operator QLabel { background: transparent; color: $text; font-size: 18px; }
#operator QLabel[op="soft"] { color: $soft; font-size: 18px; }
#operator QLabel[op="strong"] { font-size: 20px; font-weight: 600; }
#operator QLabel[op="heading"] { font-size: 24px; font-weight: 600; }
#operator QLabel[op="title"] { font-size: 32px; font-weight: 600; }
#operator QLabel[op="step"] { font-size: 40px; font-weight: 600; }
#operator QLabel[op="value"] { font-size: 36px; font-weight: 600; }
#operator QLabel[op="error"] { color: $error; font-size: 20px; font-weight: 600; }
#operator QLabel[op="count"] { font-size: 20px; font-weight: 600; }

#operator QFrame#operator-bar { background: $surface; border: none; border-bottom: 1px solid $line; }
#operator QFrame#operator-strip { background: $surface; border: none; border-top: 1px solid $line; }
#operator QFrame#operator-card { background: $surface; border: 1px solid $line; border-radius: 8px; }
#operator QFrame#operator-words { background: $raised; border: 2px solid $line; border-radius: 8px; }
#operator QFrame#operator-words[level="error"] { border-color: $error; }
#operator QFrame#operator-call { background: $amber; border: none; }
#operator QFrame#operator-call QLabel { color: $dark_letters; font-size: 20px; font-weight: 600; }

#operator QPushButton[op] { background: $surface; color: $text; border: 2px solid $line; border-radius: 8px; font-size: 20px; }
#operator QPushButton[op="normal"], #operator QPushButton[op="primary"] { padding: 0 24px; min-height: 56px; }
#operator QPushButton[tall="true"] { min-height: 80px; }
#operator QPushButton[op]:focus { border-color: $accent; }
#operator QPushButton[op]:pressed { background: $accent_soft; border-color: $accent; }
#operator QPushButton[op]:checked { background: $accent_soft; border-color: $accent; }
#operator QPushButton[op]:disabled { color: $faint; background: $sunken; }
#operator QPushButton[op="primary"] { background: $accent; color: $accent_on; border-color: $accent; font-weight: 600; }
#operator QPushButton[op="primary"]:focus { border-color: $text; }
#operator QPushButton[op="primary"]:pressed { background: $accent_pressed; }
#operator QPushButton[op="primary"]:disabled { background: $sunken; color: $faint; border-color: $line; }
#operator QPushButton[op="stop"] { background: $fail; color: #ffffff; border-color: $fail; font-size: 28px; font-weight: 700; min-height: 96px; }
#operator QPushButton[op="stop"]:focus { border-color: $text; }
#operator QPushButton[op="stop"]:pressed { background: $fail_pressed; }
#operator QPushButton[op="quiet"] { border-color: transparent; background: transparent; padding: 0 16px; min-height: 48px; font-size: 18px; }
#operator QPushButton[op="quiet"]:focus { border-color: $accent; }
#operator QPushButton[op="quiet"]:disabled { background: transparent; }
#operator QFrame#operator-call QPushButton { color: $dark_letters; border-color: $dark_letters; }
#operator QPushButton[op="key"] { font-size: 28px; padding: 0; min-height: 72px; }
#operator QPushButton[op="key"][low="true"] { font-size: 22px; min-height: 48px; }
#operator QPushButton[op="card"] { text-align: left; padding: 0; min-height: ${card}px; }

#operator QLineEdit { background: $surface; color: $text; border: 2px solid $line; border-radius: 8px; font-size: 24px; padding: 0 16px; min-height: 56px; }
#operator QLineEdit:focus { border-color: $accent; }
#operator QLineEdit[invalid="true"] { border-color: $error; }
#operator QProgressBar { background: $sunken; border: none; border-radius: 12px; min-height: 24px; max-height: 24px; }
#operator QProgressBar::chunk { background: $accent; border-radius: 12px; }
#operator QScrollBar:vertical { width: 24px; }
#operator QScrollBar::handle { min-height: 64px; border-radius: 8px; background: $faint; margin: 4px; }
""")


def operator_sheet(theme: Theme) -> str:
    """Return the style sheet of operator mode."""
    fail = theme.colours["verdict_fail"]
    error = "#B3263A" if theme.shade == "light" else "#FF8A98"  # red letters with enough contrast on each background
    return SHEET.substitute(
        theme.colours,
        card=str(CARD_PX[1] - 4),
        fail=fail,
        fail_pressed="#A93547",
        error=error,
        amber=theme.colours["verdict_not_proven"],
        dark_letters=DARK_LETTERS,
    )


def letters_on(verdict: str) -> str:
    """Return the colour of letters on the colour of a verdict."""
    return DARK_LETTERS if verdict in ("not proven", "not measured") else "#FFFFFF"
