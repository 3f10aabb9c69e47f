"""What errors say reaches the catalogue wherever it is written, is recognised with its values, and is read in Chinese in the window."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from measureapp.acquire.jog import jog
from measureapp.data.cloud import StitchedCloud
from measureapp.data.plan import FlangePose, ScanPlan
from measureapp.devices.plugin_loader import load_driver
from measureapp.errors import MeasureError
from measureapp.geometry.fits import fit
from measureapp.geometry.transform import RigidTransform
from measureapp.language.catalogue import LEAST_LETTERS, Catalogue, fixed_letters, placeholders, read_catalogue
from measureapp.language.translator import FORMATTER, Translator
from measureapp.planning import edit
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.robot_file import read_robot
from measureapp.project.plan_file import read_plan
from measureapp.project.program_file import parse_program
from measureapp.project.rig_file import read_rig
from measureapp.project.tables import read_angles, read_corners, read_poses
from measureapp.register.setups.spheres import match_spheres
from measureapp.register.surface.open import triangulate_open_patch
from measureapp.simulate.parts import make_part
from measureapp.simulate.worlds import read_world
from ui.look.language.core import Core
from ui.look.language.errors import told_texts
from ui.look.language.sources import catalogue_file

VALUES = ("4711", "25", "P-17", "37", "A-9", "3")
KEPT = re.compile(  # names, files, fields, keys of the program and of formats
    r"""`[^`]*`|'[^']*'|\S*[/\\._=\d]\S*|\b(MeasureApp|GiB|plugins|colour|flat|left|place|paper|height|bracket|gone|torus|sphere|plane|line|cone|cylinder|circle|camera|flange|table"""
    r"""|impeller|gypsum|gear|plate|casting|good|usual|bad|ideal|position|name|from|virtual|rig|TOML|JSON|STL|PLY|OBJ|URDF|PATH)\b"""
)


@pytest.fixture(scope="module")
def chinese_words() -> Catalogue:
    return read_catalogue(catalogue_file("zh_CN"))


def told_by(**files: str) -> set[str]:
    """Return what the errors of these modules say."""
    return set(told_texts(Core({name: ast.parse(text) for name, text in files.items()})))


def test_the_window_reaches_what_it_imports_and_no_command_line(read_sources):
    reached = set(read_sources.modules)
    assert {
        "measureapp.register.stitch",
        "measureapp.simulate.world",
        "plugins.robot_abb.driver",
        "ui.second_screen.__main__",
    } <= reached
    assert not [name for name in reached if name.startswith(("measureapp.cli", "measureapp.campaign", "measureapp.peers.rws"))]


def test_texts_of_every_class_of_errors_are_found():
    assert told_by(a="class Far(MeasureError): ...\nclass Farther(Far): ...\nraise Farther(f'{axis} is too far.', 'Move it.')") == {
        "{v1} is too far.",
        "Move it.",
    }
    assert told_by(a="class Far(MeasureError):\n def __init__(self, n):\n  super().__init__(f'Axis {n} is too far.')") == {
        "Axis {v1} is too far."
    }


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("HINT = 'Take it again.'\ndef f(): raise InputError(*[HINT])", {"Take it again."}),
        ("def f(n):\n hint = 'Take it.' if n else 'Leave it.'\n raise InputError(x, hint)", {"Take it.", "Leave it."}),
        ("def refuse(why): raise InputError(f'It failed: {why}.')\nrefuse('no light at all')", {"It failed: {v1}.", "no light at all"}),
        ("def why(n): return f'{n} views are dark'\nraise InputError('Bad: ' + why(3) + '.')", {"Bad: {v1}.", "{v1} views are dark"}),
        ('def f(n): raise InputError(f\'It is too {"far" if n else "near"}.\')', {"It is too {v1}.", "far", "near"}),
        ("bad = []\nbad.append(f'{n} is dark')\nraise InputError('; '.join(bad) + ' There.')", {"{v1} There.", "{v1} is dark"}),
        ("TOO = 'It is {far} away.'\nraise InputError(TOO.format(far=3))", {"It is {far} away."}),
        (
            "class A:\n def f(self): self._why = 'it went dark'\n def g(self): raise InputError(f'Lost: {self._why}.')",
            {"Lost: {v1}.", "it went dark"},
        ),
        ("class Row:\n hint: str\nrow = Row(hint='Allow it.')\nraise InputError(x, row.hint)", {"Allow it."}),
        ("def f(kind): raise kind('It moved.', 'Stop it.')", {"It moved.", "Stop it."}),
        ("raise InputError(f'{place}/stack.json', 'left')", set()),
    ],
)
def test_a_text_is_followed_to_where_it_is_written(code, said):
    assert told_by(a="class InputError(MeasureError): ...\n" + code) == said


def test_a_text_is_followed_into_other_modules():
    files = {
        "p.errors": "class InputError(MeasureError): ...",
        "p.words": "HINT = 'Take it again.'\ndef remedy(n): return f'Repeat view {n} once more.'",
        "p.user": "from p.errors import InputError\nfrom .words import HINT, remedy\nraise InputError(HINT, remedy(3))",
    }
    assert told_by(**files) == {"Take it again.", "Repeat view {v1} once more."}


def test_every_sentence_in_a_raised_error_is_translated(read_sources, chinese_words):
    """Told apart from the rule that collects them: all sentences written in a `raise` statement."""
    assert len(read_sources.raised) > 500
    assert not [f"{place} {text}" for place, text in read_sources.raised.items() if not chinese_words.translation(text)]


def test_every_message_is_recognised_with_its_values(read_sources, chinese_words):
    translator = Translator()
    translator.use(chinese_words)
    wrong = []
    for source in read_sources.told:
        names = placeholders(source)
        glued = set(re.findall(r"(?:\w|\}[.]?)\{(\w+)", source))  # where the value before it ends is unknown
        values = {name: "" if name in glued else VALUES[place % len(VALUES)] for place, name in enumerate(names)}
        if names and fixed_letters(source) < LEAST_LETTERS and not source.endswith("."):
            continue  # such as "{v1} from {v2}", which is recognised with numbers only
        text, wanted = (FORMATTER.vformat(one, (), values) for one in (source, chinese_words.translation(source) or ""))
        if translator.renewed(text) != wanted:
            wrong.append((text, translator.renewed(text)))
    assert not wrong


def test_values_that_touch_stay_together_in_their_order(chinese_words):
    for source, entry in chinese_words.entries.items():
        assert all(pair in entry.translation for pair in re.findall(r"\{v\d\}\{v\d\}", source)), source


def line_of_points(count: int) -> StitchedCloud:
    along = np.column_stack([np.arange(float(count)), np.zeros((count, 2))])
    ones = np.ones(count, np.float32)
    return StitchedCloud(along, np.tile(np.float32([0, 0, 1]), (count, 1)), ones, ones, np.zeros(count, np.int16), ())


def unit(to_frame: str, from_frame: str) -> RigidTransform:
    return RigidTransform.identity(to_frame, from_frame)


def written(folder: Path, name: str, text: str) -> Path:
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


PLAN = ScanPlan(
    name="plan", viewpoints=(edit.make_viewpoint("a", FlangePose(position_mm=(0, 0, 0), quaternion_wxyz=(1, 0, 0, 0)), 0.0, 0.0),)
)
PROGRAM = '[[features]]\nname = "place"\nshape = "sphere"\npoint_mm = [0, 0, 0]\n'
ERRORS: dict[str, Callable[[Path], object]] = {
    "FrameMismatch: product": lambda _: unit("part", "table") @ unit("guide", "part"),
    "FrameMismatch: rigid": lambda _: RigidTransform(2 * np.eye(4), "part", "camera"),
    "FitError": lambda _: fit("torus", np.eye(3)),
    "RegistrationError: few": lambda _: triangulate_open_patch(line_of_points(2)),
    "RegistrationError: line": lambda _: triangulate_open_patch(line_of_points(300)),
    "RegistrationError: memory": lambda _: triangulate_open_patch(line_of_points(300), free_bytes=lambda: 10),
    "RegistrationError: spheres": lambda _: match_spheres([], [], ("up", "down")),
    "LimitError: hand": lambda _: jog(None, "table", 400.0, NoProgress()),
    "PlanError: order": lambda _: edit.reorder(PLAN, ["a", "a"]),
    "PlanError: twice": lambda _: edit.add(PLAN, next(iter(PLAN))),
    "PluginError: none": lambda _: load_driver(None, "gone", "camera"),
    "PluginError: kind": lambda _: load_driver(None, "robot_abb", "camera"),
    "InputError: world": lambda _: read_world("gone"),
    "InputError: part": lambda _: make_part("gone"),
    "InputError: mesh": lambda folder: make_part(str(written(folder, "a.stl", "solid a\nfacet normal 0 0 1\n"))),
    "InputError: rig": lambda _: read_rig("gone"),
    "InputError: robot": lambda _: read_robot("gone"),
    "InputError: plan": lambda folder: read_plan(written(folder, "p.toml", 'name = "a b"\ncolour = 3')),
    "InputError: program": lambda _: parse_program('name = "bracket"\n' + PROGRAM + PROGRAM),
    "InputError: field": lambda _: parse_program('name = "bracket"\n' + PROGRAM.replace("[0, 0, 0]", '["x", 0, 0]')),
    "InputError: header": lambda folder: read_angles(written(folder, "t.csv", "a,b\n")),
    "InputError: rows": lambda folder: read_corners(written(folder, "t.csv", "position,camera,corner,x_px,y_px\n1.5,left,1,2,3\n")),
    "InputError: quaternion": lambda folder: read_poses(
        written(folder, "t.csv", "name,x_mm,y_mm,z_mm,qw,qx,qy,qz\na,0,0,0,2,0,0,0\n"), "base", "flange"
    ),
    "InputError: project": ProjectFolder.open,
}


def test_errors_are_read_in_chinese_in_the_window(application, window, tmp_path):
    application.settings.set_text("language", "zh_CN")
    application.language.retranslation.finish()
    read: dict[str, list[str]] = {}
    for name, provoke in ERRORS.items():
        with pytest.raises(MeasureError) as refused:
            provoke(tmp_path)
        assert type(refused.value).__name__ == name.partition(":")[0]
        application.session.tell(refused.value.message, refused.value.hint, "error")
        shown = window.strip.words
        left = re.findall(r"[A-Za-z]{3,}", KEPT.sub(" ", shown))
        if left or not re.search("[\u4e00-\u9fff]", shown):
            read[name] = [shown, *left]
    assert len(ERRORS) > 20 and not read
