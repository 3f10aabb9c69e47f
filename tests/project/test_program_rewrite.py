import pytest

from measureapp.data.deviation_scale import DeviationScale
from measureapp.errors import InputError
from measureapp.inspection.programming.edits import add, change, duplicate, move, remove, rename, set_alignment, set_tolerance
from measureapp.inspection.session.graph import Node
from measureapp.project.program_file import parse_program
from measureapp.project.program_rewrite import format_program, rewrite_program
from measureapp.resources import resource

TEXT = """# Block with a bore
schema_version = 1
name = "block"
alignment = "none"  # as clamped

# the upper face
[[features]]
name = "top"
shape = "plane"
point_mm = [0, 0, 30]  # from the drawing
direction = [0, 0, 1]

[[features]]
name = "base"
shape = "plane"
point_mm = [0, 0, 0]
direction = [0, 0, -1]

# function: fits the rail
[[dimensions]]
name = "height"
kind = "distance"
features = ["top", "base"]
nominal = 30  # mm
upper_tolerance = 0.1

[[dimensions]]
name = "flat"
kind = "flatness"
features = ["top"]
upper_tolerance = 0.05
"""
HEIGHT, TOP = Node("dimension", "height"), Node("feature", "top")


def rewritten(edit):
    program = edit(parse_program(TEXT))
    text = rewrite_program(TEXT, program)
    assert parse_program(text) == program
    return text


def test_a_program_without_edits_keeps_every_character():
    assert rewrite_program(TEXT, parse_program(TEXT)) == TEXT


def test_a_tolerance_changes_its_lines_only():
    text = rewritten(lambda program: set_tolerance(program, "height", "H7"))
    assert 'tolerance = "H7"' in text and "# function: fits the rail" in text and "nominal = 30  # mm" in text
    assert text.count("\n") == TEXT.count("\n")


def test_a_rename_keeps_comments_and_changes_references():
    text = rewritten(lambda program: rename(program, TOP, "cover"))
    assert '# the upper face\n[[features]]\nname = "cover"' in text and 'features = ["cover", "base"]' in text
    assert "point_mm = [0, 0, 30]  # from the drawing" in text


def test_a_moved_entry_takes_its_comments_along():
    text = rewritten(lambda program: move(program, HEIGHT, 1))
    assert text.index('name = "flat"') < text.index("# function: fits the rail") < text.index('name = "height"')


def test_entries_are_added_removed_and_duplicated():
    assert 'name = "height 2"' in rewritten(lambda program: duplicate(program, HEIGHT)[0])
    assert "rail" not in rewritten(lambda program: remove(program, [HEIGHT]))
    grown = rewritten(lambda program: add(program, "alignment", {"name": "to base", "alignment": "datums:base"}))
    assert "[[alignments]]" in grown


@pytest.mark.parametrize("own", ["", "[deviation_scale]\n# agreed with the customer\nsteps = 20\n", "deviation_scale = { steps = 20 }\n"])
def test_a_colour_scale_is_stored_beside_what_stays(own):
    head, rest = TEXT.split("\n# the upper face")
    inline = own.startswith("deviation")
    text = f"{head}{own}\n# the upper face{rest}" if inline else f"{TEXT}\n{own}"
    program = parse_program(text)
    scale = DeviationScale(tolerance_mm=(-0.05, 0.02), range_mm=(-0.1, 0.1), ramp="rainbow")
    changed = rewrite_program(text, program.model_copy(update={"deviation_scale": scale}))
    assert parse_program(changed).deviation_scale == scale
    assert "# function: fits the rail" in changed and ("# agreed" in changed) == ("# agreed" in text)
    assert changed.count("deviation_scale") == 1 and "steps" not in changed
    assert rewrite_program(changed, parse_program(changed)) == changed


@pytest.mark.parametrize(
    ("given", "words"), [("tolerance_mm = [0.1, -0.1]", "tolerance_mm is above"), ("range_mm = [0.1, 0.1]", "range_mm is not below")]
)
def test_a_colour_scale_with_exchanged_ends_is_refused(given, words):
    with pytest.raises(InputError, match=words):
        parse_program(f"{TEXT}\n[deviation_scale]\n{given}\n")


def test_the_alignment_changes_in_its_line():
    assert "# as clamped" in rewritten(lambda program: set_alignment(program, "datums:base"))


def test_a_changed_nested_value_is_written_in_one_line():
    assert "cut = { band_mm = 1.5 }" in rewritten(lambda program: change(program, TOP, {"cut": {"band_mm": 1.5}}))


@pytest.mark.parametrize("name", ["gypsum/program", "gear/tolerances", "impeller/program", "impeller/blades", "sphere_plate/program"])
def test_sample_programs_survive_edits_of_their_first_dimension(name):
    text = (resource("parts") / f"{name}.toml").read_text(encoding="utf-8")
    program = parse_program(text)
    first = program.dimensions[0]
    edited = rename(program, Node("dimension", first.name), f"{first.name} new")
    assert parse_program(rewrite_program(text, edited)) == edited
    assert parse_program(format_program(program)) == program
    assert rewrite_program(text, program) == text
