"""Each input of a project changed by itself: exactly what depends on it is computed again, and what is kept equals what would be computed."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from demo_fixture import Demo, linked_copy
from scipy.spatial import cKDTree

from measureapp.data.board import BoardView
from measureapp.data.decode_limits import DecodeLimits
from measureapp.data.measurement import Inspection, Measurement
from measureapp.data.view_choices import ViewChoices
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.pipeline import assemble, measure, rig_calibration, run, surface
from measureapp.pipeline.axes_check import before_axes_check, without_contradictions
from measureapp.pipeline.events import Event, ResultKept
from measureapp.pipeline.kept_results import kept_calibration
from measureapp.pipeline.run import process_project
from measureapp.progress import NoProgress
from measureapp.project import kept_deviation
from measureapp.project.folder import ProjectFolder
from measureapp.project.fringes.decode_limits_file import save_decode_limits
from measureapp.project.geometry.files import read_mesh
from measureapp.project.journal import disk
from measureapp.report.drawing import Drawing
from measureapp.report.project import compose_project

OF_CLOUD = ("points_mm", "normals", "sigma_mm", "grey", "view", "sampled_view")
SAME_SURFACE_MM = 0.01
OF_VIEW = ("points_mm", "normals", "sigma_mm", "grey", "pixel", "cameras")
COMPUTED = {
    "calibration": (rig_calibration, "solve_views"),
    "clouds": (measure, "compute_stored"),
    "stitched cloud": (assemble, "stitch"),
    "surface": (surface, "reconstruct_surface"),
    "inspection": (assemble, "inspect_stitched"),
}
ALL_BUT_CALIBRATION = {"clouds", "stitched cloud", "surface", "inspection"}
VIEWS = ("view01", "view03", "view05")  # from all sides, so that all is measured as with twice as many
Change = Callable[[ProjectFolder], None]


@pytest.fixture
def project(demo: Demo, tmp_path: Path) -> ProjectFolder:
    return ProjectFolder.open(linked_copy(demo.folder, tmp_path / "p"))


@dataclass(frozen=True)
class Made:
    """A project with its results, and what was computed from its images alone."""

    folder: Path
    measurement: Measurement
    computed: set[str]


@pytest.fixture(scope="module", params=[VIEWS, pytest.param(None, marks=pytest.mark.slow)], ids=["three views", "all views"])
def made(request: pytest.FixtureRequest, demo: Demo, tmp_path_factory: pytest.TempPathFactory) -> Made:
    """The demo computed from its images; the results of all its views are those of its scan, those of three these."""
    bare = ProjectFolder.open(linked_copy(demo.folder, tmp_path_factory.mktemp("bare") / "p"))
    shutil.rmtree(bare.results)
    chosen = request.param or bare.stored_viewpoints()
    with bare.lock():
        for name in set(bare.stored_viewpoints()) - set(chosen):
            bare.frames.discard(name)
    measurement, computed, _ = process(ProjectFolder.open(bare.path))
    return Made(demo.folder if request.param is None else bare.path, measurement, computed)


@pytest.fixture
def copied(made: Made, tmp_path: Path) -> ProjectFolder:
    return ProjectFolder.open(linked_copy(made.folder, tmp_path / "p"))


def process(project: ProjectFolder, inspection: Inspection | None = None) -> tuple[Measurement, set[str], list[Event]]:
    """Process a project without its report, or its inspection where one is given; return what was computed and the events, too."""
    computed, events = set[str](), list[Event]()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(run, "write_reports", lambda *_: {})
        for name, (module, function) in COMPUTED.items():
            whole = getattr(module, function)

            def noted(*given: Any, name: str = name, whole: Any = whole, **named: Any) -> Any:
                computed.add(name)
                return inspection if inspection is not None and name == "inspection" else whole(*given, **named)

            patch.setattr(module, function, noted)
        return process_project(project, events.append, NoProgress()).measurement, computed, events


def assert_equal(one: Measurement, other: Measurement) -> None:
    """Compare all numbers of clouds and dimensions bit by bit; surfaces, whose sums are in the order of threads, by their distance."""
    assert one.mesh is not None and other.mesh is not None
    for mesh, beside in ((one.mesh, other.mesh), (other.mesh, one.mesh)):
        distances_mm, _ = cKDTree(mesh.vertices_mm).query(beside.vertices_mm)
        assert np.mean(distances_mm < SAME_SURFACE_MM) > 0.999
    pairs = [(one.stitched, other.stitched, OF_CLOUD)]
    pairs += [(mine.cloud, theirs.cloud, OF_VIEW) for mine, theirs in zip(one.views, other.views, strict=True)]
    for mine, theirs, names in pairs:
        for name in names:
            assert getattr(mine, name).tobytes() == getattr(theirs, name).tobytes(), name
    for mine, theirs in zip(one.stitched.placements, other.stitched.placements, strict=True):
        assert mine.part_from_camera.matrix.tobytes() == theirs.part_from_camera.matrix.tobytes()
        assert replace(mine, part_from_camera=theirs.part_from_camera, kinematic=theirs.kinematic).verdict == theirs.verdict
    assert one.inspection is not None and other.inspection is not None
    assert one.inspection.dimensions == other.inspection.dimensions
    assert one.consistency == other.consistency
    assert one.validity.axes == other.validity.axes


def test_without_any_change_all_is_kept_but_the_inspection_and_equals_what_is_computed_from_the_images(
    made: Made, copied: ProjectFolder
) -> None:
    kept, computed, events = process(copied)
    assert computed == {"inspection"}
    assert [event.what for event in events if isinstance(event, ResultKept)] == ["calibration", "stitched"]
    scratch = made.measurement
    assert made.computed == ALL_BUT_CALIBRATION
    assert_equal(kept, scratch)
    stored = copied.measurement()
    assert stored is not None
    assert_equal(stored, scratch)
    assert stored.stitched_from == scratch.stitched_from != ""


def test_a_report_takes_deviation_and_pictures_from_the_process_before_and_another_nominal_has_them_made_again(
    project: ProjectFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    made, compute, draw = list[str](), kept_deviation.compute_deviation, Drawing.draw
    monkeypatch.setattr(
        kept_deviation, "compute_deviation", lambda *given, **named: (made.append("deviation"), compute(*given, **named))[1]
    )
    monkeypatch.setattr(Drawing, "draw", lambda drawing, progress: (made.append("pictures"), draw(drawing, progress))[1])
    first = compose_project(project)
    assert made == [] and first.pictures and first.deviation is not None and first.deviation.pictures
    with project.lock():
        another_nominal(project)
    assert compose_project(project).deviation is not None
    assert made == ["deviation", "pictures"]


@pytest.mark.slow
def test_a_calibration_that_is_kept_equals_the_one_solved_from_the_images(project: ProjectFolder) -> None:
    kept = kept_calibration(project)
    assert kept is not None
    files = {name: (project.path / "calibration" / name).read_bytes() for name in ("cameras.json", "rig.json", "rig_uncertainty.npz")}
    for name in files:
        (project.path / "calibration" / name).unlink()
    rig_calibration.solve_calibration(project, lambda _: None, NoProgress(), run.Stopwatch())
    assert {name: (project.path / "calibration" / name).read_bytes() for name in files} == files


def another_tolerance(project: ProjectFolder) -> None:
    text = project.program_text(has_nominal=True)
    assert "nominal = 180\n" in text
    project.save_program(text.replace("nominal = 180\n", 'nominal = 180\ntolerance = "±0.9"\n'))


def a_refused_view(project: ProjectFolder) -> None:
    project.save_view_choices(ViewChoices(refused=("view03",)))


def another_hand_eye(project: ProjectFolder) -> None:
    """As from another session: there are no images of the board in the project that would replace it."""
    calibration, uncertainty = project.require_calibration(), project.rig_uncertainty()
    hand_eye = calibration.hand_eye
    turn = RigidTransform.from_parts(rotation_about([0, 1, 0], 1e-5), np.array([0.001, 0.002, -0.003]), "camera", "camera")
    shutil.rmtree(project.path / "calibration" / "views")
    moved = replace(calibration, hand_eye=replace(hand_eye, flange_from_camera=hand_eye.flange_from_camera @ turn))
    project.save_calibration(moved, uncertainty)


def other_limits(project: ProjectFolder) -> None:
    save_decode_limits(project.path, DecodeLimits(min_modulation=12.0))


def another_nominal(project: ProjectFolder) -> None:
    """The clouds are told from their surroundings by it."""
    assert project.nominal is not None
    nominal = read_mesh(project.nominal, "nominal")
    project.save_nominal(project.nominal, replace(nominal, vertices_mm=nominal.vertices_mm + 0.01))


@pytest.mark.parametrize("change", [another_nominal, a_refused_view, another_hand_eye, other_limits])
def test_results_of_a_changed_input_are_stale_at_once(project: ProjectFolder, change: Change) -> None:
    assert project.stale_results() == ()
    with project.lock():
        change(project)
    assert project.stale_results() != ()


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (another_tolerance, {"inspection"}),
        pytest.param(another_nominal, {"stitched cloud", "surface", "inspection"}, marks=pytest.mark.slow),
        pytest.param(a_refused_view, {"stitched cloud", "surface", "inspection"}, marks=pytest.mark.slow),
        (another_hand_eye, {"stitched cloud", "surface", "inspection"}),
        (other_limits, ALL_BUT_CALIBRATION),
    ],
)
def test_a_changed_input_has_exactly_that_computed_again_which_depends_on_it(
    copied: ProjectFolder, change: Change, expected: set[str]
) -> None:
    with copied.lock():
        change(copied)
    measurement, computed, _ = process(copied)
    assert computed == expected
    assert copied.stale_results() == ()
    stored = copied.measurement()
    assert stored is not None
    assert_equal(stored, measurement)
    _, computed, _ = process(copied, measurement.inspection)
    assert computed == {"inspection"}


def test_another_image_of_the_board_another_program_and_damage_keep_no_calibration(
    project: ProjectFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert kept_calibration(project) is not None
    with monkeypatch.context() as patch:
        patch.setattr("measureapp.pipeline.kept_results.fingerprint", lambda: "another program")
        assert kept_calibration(project) is None
    image = sorted((project.path / "calibration" / "views").glob("*/*.png"))[0]
    content = image.read_bytes()
    image.unlink()  # a link until now
    image.write_bytes(content[:-20] + bytes(20))
    assert kept_calibration(project) is None
    image.write_bytes(content)
    assert kept_calibration(project) is not None
    unknown = image.with_name("fourth.png")
    unknown.write_bytes(content)
    assert kept_calibration(project) is None
    unknown.unlink()
    view = project.board_views()[0]
    darker = {name: np.maximum(pixels, 1) - 1 for name, pixels in view.images.items()}
    with project.lock():
        project.save_board_view(BoardView(view.viewpoint_id, darker, view.readback, view.conditions))
    assert kept_calibration(project) is None


def test_files_of_the_same_size_and_time_are_not_read_again_and_all_others_are(
    project: ProjectFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    name = "stacks/view02/left.npy"
    contents = project.journal.contents()
    assert contents is not None
    known, path = contents.files[name], project.path / name
    read, whole = list[Path](), disk.state_of
    monkeypatch.setattr(disk, "state_of", lambda place, head=0: (read.append(place), whole(place, head))[1])
    assert project.journal.is_unchanged(name, known) and project.journal.is_unchanged(name, known)
    assert read == [path]
    compared = project.journal.compared_images()
    again = ProjectFolder.open(project.path)
    again.journal.contents()
    again.journal.take_as_compared(compared)
    assert again.journal.is_unchanged(name, known) and read.count(path) == 1  # opening a folder looks at its documents
    content = bytearray(path.read_bytes())
    content[-1] ^= 1
    path.unlink()  # a link until now
    path.write_bytes(content)
    assert not again.journal.is_unchanged(name, known)


def test_a_view_that_a_wrong_calibration_refused_is_tried_again_with_another(project: ProjectFolder) -> None:
    measurement = project.measurement()
    assert measurement is not None
    right, calibration = measurement.views, measurement.calibration
    turned = replace(right[2], readback=replace(right[2].readback, table_rad=right[2].readback.table_rad + 0.8))
    wrong = without_contradictions([*right[:2], turned, *right[3:]], calibration)
    refused = [view for view in wrong if not view.quality.accepted]
    assert [view.viewpoint_id for view in refused] == [right[2].viewpoint_id]
    assert before_axes_check(refused[0]).quality == right[2].quality
    assert before_axes_check(right[0]) is right[0]
