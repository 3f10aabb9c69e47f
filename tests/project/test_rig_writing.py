"""A rig description is written as TOML and read back equal."""

from __future__ import annotations

import tomllib
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
import tomli_w
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import SecretStr

from measureapp.data.board import AnyBoard, CharucoDescription, CheckerboardDescription
from measureapp.data.model import Model, toml_values
from measureapp.data.rig import DriverChoice, HeadRules, KeepOutBox, MotionRules, ParkPose, RigDescription
from measureapp.errors import StorageError
from measureapp.project.rig_file import has_comments, read_rig, write_rig


def composed() -> RigDescription:
    names = ("left", "right", "upper", "projector", "robot", "guide", "table")
    devices = {name: DriverChoice(driver="axis_modbus", settings={"drive": 'a "b" \\ ü', "speed": 0.5, "on": True}) for name in names}
    box = KeepOutBox(name="wall", low_mm=(0, 0, 0), high_mm=(1, 2, 3))
    motion = MotionRules(keep_out=(box,), settle_s=0.5, park=ParkPose(position_mm=(1, 2, 3), quaternion_wxyz=(1, 0, 0, 0)))
    changes = {"driver": "", "driver_settings": {}, "devices": devices, "links": {"bus": {"port": "COM3", "tries": [1, 2]}}}
    return read_rig("paper").model_copy(update={**changes, "motion": motion, "head": HeadRules(sequence="hardware")})


@pytest.mark.parametrize("rig", [read_rig("paper"), composed()], ids=["whole", "composed"])
def test_what_was_written_reads_back_equal(rig: RigDescription, tmp_path: Path) -> None:
    write_rig(tmp_path / "mine.toml", rig)
    assert read_rig(tmp_path / "mine.toml") == rig


def test_defaults_are_not_spelled_out(tmp_path: Path) -> None:
    write_rig(tmp_path / "mine.toml", read_rig("paper"))
    assert "keep_out" not in (tmp_path / "mine.toml").read_text(encoding="utf-8")


def test_a_folder_that_is_not_there_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(StorageError):
        write_rig(tmp_path / "file" / "mine.toml", read_rig("paper"))


TEXTS = st.text(st.characters(codec="utf-8"), max_size=20)
VALUES = st.recursive(
    st.booleans() | st.integers(-(2**63), 2**63 - 1) | st.floats(allow_nan=False, allow_infinity=False) | TEXTS,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(TEXTS, inner, max_size=3),
    max_leaves=8,
)


@given(table=st.dictionaries(TEXTS, VALUES, max_size=4))
@settings(max_examples=60, deadline=None)
def test_any_settings_read_back_equal(table: dict[str, object]) -> None:
    rig = composed().model_copy(update={"links": {"bus": table}})
    with TemporaryDirectory() as folder:
        write_rig(Path(folder) / "mine.toml", rig)
        assert read_rig(Path(folder) / "mine.toml") == rig


def test_a_missing_value_that_differs_from_the_default_is_written_as_none(tmp_path: Path) -> None:
    rig = read_rig("paper")
    forever = rig.model_copy(update={"calibration_rules": rig.calibration_rules.model_copy(update={"valid_days": None})})
    write_rig(tmp_path / "mine.toml", forever)
    assert 'valid_days = "none"' in (tmp_path / "mine.toml").read_text(encoding="utf-8")
    assert read_rig(tmp_path / "mine.toml") == forever


class Login(Model):
    password: SecretStr = SecretStr("")
    nickname: str | None = "a"
    board: AnyBoard = CheckerboardDescription(columns=9, rows=6, square_mm=10.0)


@pytest.mark.parametrize("board", [Login().board, CharucoDescription(kind="charuco", columns=9, rows=6, square_mm=10.0, marker_mm=7.0)])
def test_settings_for_a_file_have_passwords_in_clear_and_give_the_same_model(board: AnyBoard) -> None:
    login = Login(password=SecretStr("open"), board=board)
    values = toml_values(login)
    assert values["password"] == "open"
    assert Login.model_validate(tomllib.loads(tomli_w.dumps(values))) == login


def test_none_stays_a_text_where_a_text_is_possible() -> None:
    assert Login(nickname="none").nickname == "none"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('name = "a # b"\n', False),
        ("name = 'a # b'\n", False),
        ('name = """\n# a "quoted" line\n"""\n', False),
        ('name = "a \\" # b"\n', False),
        ('name = "a" # b\n', True),
        ("# don't\nname = 'a'\n", True),
    ],
)
def test_comments_are_found_outside_texts_only(text: str, expected: bool, tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(text, encoding="utf-8")
    tomllib.loads(text)
    assert has_comments(tmp_path / "mine.toml") == expected


def test_a_file_that_is_not_there_has_no_comments(tmp_path: Path) -> None:
    assert not has_comments(tmp_path / "mine.toml")
