"""All texts that may be displayed: those of the window's code, and the messages of the core."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from measureapp.resources import resource
from ui.look.field_words import field_words, tip_words

ROOT = resource("languages").parent.parent
WORDS = re.compile(r"[A-Za-z]{2}")
PLACEHOLDER = re.compile(r"\{\w+[^{}]*\}")
SENTENCE = re.compile(r"(^|[^\w.-])[a-zµ]{3,}")  # rather than the name of a view
CODE = re.compile(r"""px;|vec3\(|%\(|color: |->|"do": """)  # style sheets, shaders and formats of the log
NAMES = re.compile(r"[\w./\\*#:+-]*")  # of files, keys and settings
MESSAGES = {  # calls of the core whose texts reach the window
    "InputError", "StorageError", "FitError", "DeviceError", "PlanError", "CalibrationError", "ReconstructError", "RegisterError", "InspectionError",
    "DecodeError", "MeasureError", "UnitQuestion", "AmbiguousPart", "BoardDetectionError", "DiskFailed", "DiskFull", "DeviceLost", "Damaged",
    "report", "warn", "Cancelled",
}  # fmt: skip
TOLD = {
    ("calibrate", "kinds"),
    ("calibrate", "guidance"),
    ("calibrate", "draft"),
    ("inspection", "certified_lengths.py"),
    ("inspection", "verdict.py"),
    ("inspection", "value.py"),
    ("inspection", "blades"),
    ("inspection", "features"),
    ("inspection", "session"),
    ("inspection", "tolerances"),
    ("inspection", "alignment"),
    ("pipeline", "consistency"),
    ("data", "consistency.py"),
    ("data", "surroundings.py"),
    ("data", "axis_motions.py"),
    ("data", "identification.py"),
    ("fringe", "patterns", "check.py"),
    ("planning", "collision"),
    ("planning", "reach.py"),
    ("planning", "travel.py"),
    ("planning", "generate.py"),
    ("register", "clouds"),
    ("register", "pairs"),
    ("register", "stitch.py"),
    ("reconstruct", "why.py"),
    ("reconstruct", "diagnosis"),
}  # rooms and files whose sentences the window displays
REFUSING = {
    ("data", "deviation_scale.py"),
    ("data", "dimension_program.py"),
    ("data", "feature_program.py"),
    ("data", "inspection_program.py"),
    ("data", "part_temperature.py"),
    ("data", "standard_tolerances.py"),
    ("data", "tolerance_text.py"),
}  # files whose `ValueError` says why what was entered cannot be used
FORMS = (
    *("measureapp/data/rig.py", "measureapp/data/cell.py", "measureapp/data/length_certificate.py", "plugins/*/settings.py"),
    *("measureapp/simulate/options.py", "measureapp/simulate/sensor.py"),  # of the virtual rig
)
"""Files of models whose fields the window shows as forms, labelled after their names."""
UNTRANSLATED = {
    "TypeVar",
    "setObjectName",
    "setProperty",
    "getattr",
    "hasattr",
    "resource",
    "compile",
    "setStyleSheet",
    "QKeySequence",
    "ValueError",
}
LOGS = {"debug", "info", "warning", "exception", "error"}


def window_texts() -> dict[str, str]:
    """Return the texts of the window by the room they are used in first: {text: room}."""
    found: dict[str, str] = {}
    for path in sorted((ROOT / "ui").rglob("*.py")):
        place = path.relative_to(ROOT / "ui").parts
        if place[:2] == ("look", "language"):
            continue
        for text in _texts(ast.parse(path.read_text(encoding="utf-8"))):
            found.setdefault(text, place[1] if place[0] in ("pages", "wizards") and len(place) > 2 else place[0].removesuffix(".py"))
    for words in _field_texts():
        found.setdefault(words, "look")
    return found


def _field_texts() -> Iterator[str]:
    """Yield the labels and tooltips of the fields of all models that forms are made of."""
    for path in sorted(path for pattern in FORMS for path in ROOT.glob(pattern)):
        for one in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(one, ast.ClassDef) and one.bases:
                for field in one.body:
                    if isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name):
                        yield field_words(field.target.id)[0]
                        yield from _descriptions(field)


def _descriptions(field: ast.AnnAssign) -> Iterator[str]:
    if isinstance(field.value, ast.Call):
        for given in field.value.keywords:
            if given.arg == "description" and isinstance(given.value, ast.Constant):
                yield tip_words(str(given.value.value)).replace("{", "{{").replace("}", "}}")


def core_texts() -> dict[str, str]:
    """Return the messages of the core and the plugins that may reach the window, as templates: {text: room}."""
    found: dict[str, str] = {}
    files = [
        (place, ast.parse(path.read_text(encoding="utf-8")))
        for folder in ("measureapp", "plugins")
        for path in sorted((ROOT / folder).rglob("*.py"))
        if (place := path.relative_to(ROOT / folder).parts)[0] not in ("cli", "simulate", "peers")
    ]
    hints = {name for _, tree in files for argument in _arguments(tree, MESSAGES) if (name := _name(argument)).isupper()}
    for place, tree in files:
        if place[:2] in TOLD or place in TOLD:
            found.update(dict.fromkeys((*_texts(tree), *_sentences(tree)), place[0]))
        told = _arguments(tree, MESSAGES | {"ValueError"} if place in REFUSING else MESSAGES)
        for text in (text for one in (*told, *_hints(tree, hints)) for text in _messages(one)):
            found.setdefault(text, place[0].removesuffix(".py"))
    return found


def _arguments(tree: ast.Module, calls: set[str]) -> Iterator[ast.expr]:
    """Yield the arguments of all calls of these names."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and _name(node.func) in calls:
            yield from (*node.args, *(one.value for one in node.keywords))


def _hints(tree: ast.Module, names: set[str]) -> Iterator[ast.expr]:
    """Yield the sentences that are the module's constants of these names: hints that several errors give."""
    for node in tree.body:
        is_named = isinstance(node, ast.Assign) and any(_name(target) in names for target in node.targets)
        if is_named and any(text.endswith(".") for text in _messages(node.value)):
            yield node.value


def _texts(tree: ast.Module) -> Iterator[str]:
    parents = {child: node for node in ast.walk(tree) for child in ast.iter_child_nodes(node)}
    for node in ast.walk(tree):
        if not (isinstance(node, ast.Constant) and isinstance(node.value, str)) or isinstance(parents[node], ast.JoinedStr | ast.Expr):
            continue
        parent = parents[node]
        direct = isinstance(parent, ast.Call) and _name(parent.func) in ("tr", "later", "several", "label") and node in parent.args
        if WORDS.search(PLACEHOLDER.sub("", node.value)) and (direct or (_is_text(node.value) and not _is_internal(node, parents))):
            yield node.value
            if isinstance(parent, ast.Call) and _name(parent.func) == "several" and len(parent.args) == 2:
                yield node.value + "s"  # as `several` forms it


def _sentences(tree: ast.Module) -> Iterator[str]:
    """Yield the texts with values in them, as templates."""
    parents = {child: node for node in ast.walk(tree) for child in ast.iter_child_nodes(node)}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr) and not isinstance(parents[node], ast.FormattedValue) and not _is_internal(node, parents):
            yield from (text for text in _messages(node) if SENTENCE.search(PLACEHOLDER.sub("", text)))


def _is_text(value: str) -> bool:
    """Whether a string reads like a text for people: several words, or one with a capital letter."""
    if CODE.search(value):
        return False
    bare = PLACEHOLDER.sub("", value).strip()
    if bare != value and " " in value and re.search(r"[a-z]{3}", bare):
        return True
    return bool(bare) and (NAMES.fullmatch(bare) is None or re.fullmatch(r"[A-Z][a-z-]+[….]?", bare) is not None)


def _is_internal(node: ast.AST, parents: dict[ast.AST, ast.AST]) -> bool:
    """Whether a string is compared, looked up, logged or names something inside the program."""
    child: ast.AST = node
    while child in parents:
        parent = parents[child]
        if isinstance(parent, ast.Compare | ast.Assert | ast.MatchValue) or (isinstance(parent, ast.Subscript) and child is parent.slice):
            return True
        if isinstance(parent, ast.Call) and child is not parent.func:
            name = _name(parent.func)
            if name in UNTRANSLATED or (
                name in LOGS and isinstance(parent.func, ast.Attribute) and "log" in ast.unparse(parent.func.value)
            ):
                return True
        if isinstance(parent, ast.stmt):
            return False
        child = parent
    return False


def _messages(node: ast.expr) -> Iterator[str]:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        if _is_text(node.value):
            yield node.value.replace("{", "{{").replace("}", "}}")
    elif isinstance(node, ast.JoinedStr):
        text, count = "", 0
        for piece in node.values:
            if isinstance(piece, ast.Constant):
                text += str(piece.value).replace("{", "{{").replace("}", "}}")
            else:
                count += 1
                text += f"{{v{count}}}"
        if WORDS.search(PLACEHOLDER.sub("", text)):
            yield text
    elif isinstance(node, ast.IfExp):
        yield from _messages(node.body)
        yield from _messages(node.orelse)


def _name(node: ast.expr) -> str:
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def catalogue_file(language: str) -> Path:
    """Return the file of a language."""
    return ROOT / "resources" / "languages" / f"measureapp_{language}.ts"
