"""All texts that may be displayed: those of the window's code, and the messages of the core."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from measureapp.report.language import layout_texts, read_layout
from measureapp.resources import resource
from ui.look.field_words import field_words, tip_words
from ui.look.language.core import ROOT, Core, children, name_of, reached_files
from ui.look.language.errors import told_texts
from ui.look.language.templates import PLACEHOLDER, WORDS, escaped, has_sentence, is_text, template

TOLD = {
    ("calibrate", "kinds"),
    ("calibrate", "guidance"),
    ("calibrate", "draft"),
    ("calibrate", "cameras", "drift"),
    ("calibrate", "motions", "axis_diagnostics"),
    ("calibrate", "motions", "linear_guide"),
    ("calibrate", "motions", "rotation_axis"),
    ("calibrate", "rig", "doubts"),
    ("data", "pattern_sets"),
    ("pipeline", "chosen_views"),
    ("pipeline", "lengths"),
    ("register", "joint", "axis_doubt"),
    ("register", "joint", "registration"),
    ("inspection", "certified_lengths"),
    ("inspection", "verdict"),
    ("inspection", "value"),
    ("inspection", "blades"),
    ("inspection", "features"),
    ("inspection", "session"),
    ("inspection", "tolerances"),
    ("inspection", "alignment"),
    ("pipeline", "consistency"),
    ("data", "consistency"),
    ("data", "surroundings"),
    ("data", "axis_motions"),
    ("data", "identification"),
    ("fringe", "patterns", "check"),
    ("planning", "collision"),
    ("planning", "reach"),
    ("planning", "travel"),
    ("planning", "generate"),
    ("register", "clouds"),
    ("register", "pairs"),
    ("register", "stitch"),
    ("reconstruct", "why"),
    ("reconstruct", "diagnosis"),
    ("pipeline", "noise"),
    ("pipeline", "assemble"),
    ("inspection", "repeats"),
    ("report", "compose"),
    ("report", "cross_sections"),
    ("report", "deviation_pictures"),
    ("report", "header"),
    ("report", "part_pictures"),
    ("report", "series", "capability"),
    ("report", "valid_pixels"),
}  # rooms and files whose sentences the window displays, or reports state
FORMS = (
    *("measureapp/data/rig.py", "measureapp/data/cell.py", "measureapp/data/length_certificate.py", "plugins/*/settings.py"),
    *("measureapp/simulate/options.py", "measureapp/simulate/sensor.py"),  # of the virtual rig
)
"""Files of models whose fields the window shows as forms, labelled after their names."""
FIXED = {
    ("inspection", "programming"),  # words of the names that it proposes
    ("report", "printed"),
    ("report", "repeats"),
    ("report", "series"),
    ("report", "xlsx"),
}  # of which only constants are translated
LAYOUTS = ("report/report.typ", "report/series.typ", "report/repeats.typ", "report/report.html")
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
                yield escaped(tip_words(str(given.value.value)))


def core_texts() -> dict[str, str]:
    """Return the messages of the core and the plugins that may reach the window, as templates: {text: room}."""
    core = Core(reached_files())
    found: dict[str, str] = {}
    for module, tree in core.trees.items():
        place = module.split(".")[1:]
        if not module.startswith("measureapp"):
            continue
        if tuple(place[:2]) in TOLD or tuple(place) in TOLD:
            found.update(dict.fromkeys((*_texts(tree), *_sentences(tree)), place[0]))
        elif tuple(place[:2]) in FIXED:
            found.update(dict.fromkeys(_texts(tree), place[0]))
    for path in LAYOUTS:
        found.update(dict.fromkeys(layout_texts(read_layout(resource(path))), "report"))
    for text, module in told_texts(core).items():
        found.setdefault(text, module.split(".")[1])
    return found


def _nodes_and_parents(tree: ast.Module) -> tuple[list[ast.AST], dict[ast.AST, ast.AST]]:
    """Return all nodes level by level, and the node that each stands in."""
    nodes: list[ast.AST] = [tree]
    parents: dict[ast.AST, ast.AST] = {}
    for node in nodes:  # which grows meanwhile
        below = children(node)
        parents.update(dict.fromkeys(below, node))
        nodes += below
    return nodes, parents


def _texts(tree: ast.Module) -> Iterator[str]:
    nodes, parents = _nodes_and_parents(tree)
    for node in nodes:
        if not (isinstance(node, ast.Constant) and isinstance(node.value, str)) or isinstance(parents[node], ast.JoinedStr | ast.Expr):
            continue
        parent = parents[node]
        direct = (
            isinstance(parent, ast.Call) and name_of(parent.func) in ("tr", "later", "several", "label", "word") and node in parent.args
        )
        if WORDS.search(PLACEHOLDER.sub("", node.value)) and (direct or (is_text(node.value) and not _is_internal(node, parents))):
            yield node.value
            if isinstance(parent, ast.Call) and name_of(parent.func) == "several" and len(parent.args) == 2:
                yield node.value + "s"  # as `several` forms it


def _sentences(tree: ast.Module) -> Iterator[str]:
    """Yield the texts with values in them, as templates."""
    nodes, parents = _nodes_and_parents(tree)
    for node in nodes:
        is_part = isinstance(parents.get(node), ast.FormattedValue)
        if isinstance(node, ast.JoinedStr) and not is_part and not _is_internal(node, parents) and has_sentence(text := template(node)):
            yield text


def _is_internal(node: ast.AST, parents: dict[ast.AST, ast.AST]) -> bool:
    """Whether a string is compared, looked up, logged or names something inside the program."""
    child: ast.AST = node
    while child in parents:
        parent = parents[child]
        if isinstance(parent, ast.Compare | ast.Assert | ast.MatchValue) or (isinstance(parent, ast.Subscript) and child is parent.slice):
            return True
        if isinstance(parent, ast.Call) and child is not parent.func:
            name = name_of(parent.func)
            if name in UNTRANSLATED or (
                name in LOGS and isinstance(parent.func, ast.Attribute) and "log" in ast.unparse(parent.func.value)
            ):
                return True
        if isinstance(parent, ast.stmt):
            return False
        child = parent
    return False


def catalogue_file(language: str) -> Path:
    """Return the file of a language."""
    return ROOT / "resources" / "languages" / f"measureapp_{language}.ts"
