"""Form (ISO 1101): flatness, straightness, roundness and cylindricity of the extracted cell means."""

from __future__ import annotations

import numpy as np
from scipy.optimize import linprog

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import Criterion, DimensionProgram
from measureapp.errors import FitError, InspectionError
from measureapp.geometry.feature import Shape
from measureapp.geometry.fits import fit
from measureapp.geometry.minimum_zone import fit_minimum_zone
from measureapp.geometry.shapes import tangents
from measureapp.inspection.features.cells import Cells, angles, around_count, cell_means, surface_keys
from measureapp.inspection.features.feature_errors import NOISE, STITCHING, ErrorSource
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.features.shapes import along_and_off
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.zone_noise import Zone, estimate_noise_free_width, propagate_view_errors
from measureapp.inspection.value import Value, assumed_placement_sigma, combine_budgets, require_direction, require_feature

LEAST_SECTIONS = 5
LEAST_ON_LINE = 6
LEAST_SLANT_DEG = 5.0
WORDS = {"minimum-zone": "minimum zone", "least-squares": "least squares"}


def evaluate_form(described: DimensionProgram, found: FoundFeature, settings: InspectionSettings) -> Value:
    """Evaluate the form deviation of one feature, corrected for noise, with its uncertainty.

    Raises
    ------
    InspectionError
        This form is not defined for the feature, or too little of it was measured.
    """
    feature = require_feature(found)
    if described.kind == "straightness" and feature.shape == "line":
        return evaluate_line_form(described.criterion, found, settings)
    cells = extract_cells(found, settings)
    if described.kind == "flatness":
        _require(found, "flatness", "plane")
        made = _zone("plane", cells, described.criterion, found.name, settings)
    elif described.kind == "cylindricity":
        _require(found, "cylindricity", "cylinder")
        _require_turn(cells, feature, settings, found.name)
        made = _zone("cylinder", cells, described.criterion, found.name, settings)
    elif described.kind == "roundness":
        _require(found, "roundness", "cylinder", "cone", "circle")
        made = _roundness(described.criterion, found, cells, settings)
    else:
        _require(found, "straightness", "plane", "cylinder", "cone")
        made = (
            _line_straightness(described, found, settings)
            if feature.shape == "plane"
            else _axis_straightness(described.criterion, found, cells, settings)
        )
    how = f"{filter_words(settings)}, {WORDS[described.criterion]}{made.how}; " + _draws(settings)
    return Value(made.value, combine_budgets(made.budget, {STITCHING: assumed_view_spread(found, settings)}), how)


def assumed_view_spread(found: FoundFeature, settings: InspectionSettings) -> float:
    """Return the assumed contribution of view positions to the form of a surface measured in several views without error model."""
    return assumed_placement_sigma(found, settings) if found.views > 1 else 0.0


def evaluate_line_form(criterion: Criterion, found: FoundFeature, settings: InspectionSettings) -> Value:
    """Straightness of an edge (cylinder about its points) or of a line on a face (strip about its cell means)."""
    how = f"{WORDS[criterion]}"
    if found.edge_profile is not None:
        points = found.edge_profile.points_mm
        width = zone_width("line", points, criterion, found.name)
        made = _remove_noise(
            [Zone.of("line", points, found.edge_profile.noise_mm, {})], width, criterion, settings, f", {len(points)} sections"
        )
    else:
        if len(found.points_mm) == 0:
            raise InspectionError(f"{found.name} is a constructed line without a measured surface")
        feature = require_feature(found)
        place = (found.points_mm - feature.point_mm) @ require_direction(feature)
        keys = np.floor((place - place.min()) / settings.form_cell_mm).astype(np.int64)[:, None]
        cells = cell_means(found, feature, keys)
        position = (cells.points_mm - feature.point_mm) @ require_direction(feature)
        width = _line_width(position, cells.deviations_mm, criterion)
        zone = Zone.of_profile(position, cells.deviations_mm, cells.noises_mm, cells.view_contributions)
        made = _remove_noise([zone], width, criterion, settings, "")
        how = f"{filter_words(settings)}, {how}"
    budget = combine_budgets(made.budget, {STITCHING: assumed_view_spread(found, settings)})
    return Value(made.value, budget, f"{how}{made.how}; " + _draws(settings))


def _zone(shape: Shape, cells: Cells, criterion: Criterion, name: str, settings: InspectionSettings) -> Value:
    width = zone_width(shape, cells.points_mm, criterion, name)
    return _remove_noise([Zone.of(shape, cells.points_mm, cells.noises_mm, cells.view_contributions)], width, criterion, settings, "")


def _remove_noise(zones: list[Zone], width: float, criterion: Criterion, settings: InspectionSettings, how: str) -> Value:
    true = estimate_noise_free_width(zones, width, criterion, settings.form_trials)
    words = [how, f"{width:.4f} mm less {true.shift_mm:.4f} mm by noise"]
    if true.by_noise:
        words.append(f"explained by noise alone: one-sided, at most {true.value_mm + 2 * true.sigma_mm:.4f} mm")
    return Value(true.value_mm, combine_budgets({NOISE: true.sigma_mm}, propagate_view_errors(zones, criterion)), "; ".join(words))


def extract_cells(found: FoundFeature, settings: InspectionSettings) -> Cells:
    """Return the means of a feature's points over the cells of its surface. Raises InspectionError."""
    feature = require_feature(found)
    if len(found.points_mm) == 0:
        raise InspectionError(f"{found.name} is a constructed feature without a measured surface")
    return cell_means(found, feature, surface_keys(found.points_mm, feature, settings.form_cell_mm))


def _draws(settings: InspectionSettings) -> str:
    return f"Monte Carlo, {settings.form_trials} draws"


def filter_words(settings: InspectionSettings) -> str:
    """Return the extraction filter in words."""
    return f"means of {settings.form_cell_mm:g} mm cells"


def zone_width(shape: Shape, points_mm: FloatArray, criterion: Criterion, name: str) -> float:
    """Return the form deviation of points from a shape. Raises InspectionError."""
    try:
        made = fit_minimum_zone(shape, points_mm).feature if criterion == "minimum-zone" else fit(shape, points_mm)
    except FitError as error:
        raise InspectionError(f"{name}: {error.message}") from error
    return made.form_error_mm


def find_full_sections(cells: Cells, around: int, settings: InspectionSettings, name: str) -> list[BoolArray]:
    """Return the mask (K,) of the cells of each sufficiently complete section. Raises InspectionError if there is none."""
    masks = [cells.keys[:, 0] == key for key in np.unique(cells.keys[:, 0])]
    shares = [len(np.unique(cells.keys[mask, 1])) / around for mask in masks]
    whole = [mask for mask, share in zip(masks, shares, strict=True) if share >= settings.least_turn]
    if not whole:
        raise InspectionError(
            f"{name}: no section is measured over more than {max(shares):.0%} of its circumference, {settings.least_turn:.0%} are needed"
        )
    return whole


def cells_per_turn(feature: Feature, settings: InspectionSettings) -> int:
    """Return the number of cells per turn of a round feature."""
    return around_count(feature.radius_mm or settings.form_cell_mm, settings.form_cell_mm)


def _require(found: FoundFeature, kind: str, *shapes: str) -> None:
    shape = require_feature(found).shape
    if shape not in shapes:
        raise InspectionError(f"{found.name} is a {shape}: {kind} is defined for a {' or '.join(shapes)}")


def _require_turn(cells: Cells, feature: Feature, settings: InspectionSettings, name: str) -> None:
    share = len(np.unique(cells.keys[:, 1])) / cells_per_turn(feature, settings)
    if share < settings.least_turn:
        raise InspectionError(f"{name}: only {share:.0%} of the circumference is measured, {settings.least_turn:.0%} are needed")


def _profile(feature: Feature, cells: Cells, section: BoolArray) -> tuple[FloatArray, float]:
    """Return points (K, 3) of one section projected into a plane normal to the axis, and the axial position of that plane."""
    axis = require_direction(feature)
    along, _, _ = along_and_off(cells.points_mm[section], feature.point_mm, axis)
    turn = angles(cells.points_mm[section], feature.point_mm, axis)
    tilt = feature.half_angle_rad or 0.0
    height = float(along.mean())
    radius = (feature.radius_mm or 0.0) - height * np.tan(tilt) + cells.deviations_mm[section] / np.cos(tilt)
    return np.column_stack([radius * np.cos(turn), radius * np.sin(turn), np.zeros_like(turn)]), height


def _roundness(criterion: Criterion, found: FoundFeature, cells: Cells, settings: InspectionSettings) -> Value:
    feature = require_feature(found)
    whole = find_full_sections(cells, cells_per_turn(feature, settings), settings, found.name)
    profiles = [_profile(feature, cells, section)[0] for section in whole]
    widths = [zone_width("circle", profile, criterion, found.name) for profile in profiles]
    lean = np.cos(feature.half_angle_rad or 0.0)
    zones = [
        Zone.of(
            "circle",
            profile,
            cells.noises_mm[section] / lean,
            {source: rows[section] / lean for source, rows in cells.view_contributions.items()},
        )
        for profile, section in zip(profiles, whole, strict=True)
    ]
    return _remove_noise(zones, max(widths), criterion, settings, ", " + f"the worst of {len(whole)} sections")


def _axis_straightness(criterion: Criterion, found: FoundFeature, cells: Cells, settings: InspectionSettings) -> Value:
    """Straightness of the axis: diameter of the cylinder about the centres of all sections (derived median line, ISO 14660-2)."""
    feature = require_feature(found)
    whole = find_full_sections(cells, cells_per_turn(feature, settings), settings, found.name)
    if len(whole) < LEAST_SECTIONS:
        raise InspectionError(f"{found.name}: its axis has only {len(whole)} complete sections, {LEAST_SECTIONS} are needed")
    side, lean = tangents(require_direction(feature)), np.cos(feature.half_angle_rad or 0.0)
    centres, spreads = [], []
    moved: dict[ErrorSource, list[FloatArray]] = {source: [] for source in cells.view_contributions}
    for section in whole:
        flat, height = _profile(feature, cells, section)
        turn = np.arctan2(flat[:, 1], flat[:, 0])
        design = np.column_stack([np.cos(turn), np.sin(turn), np.ones_like(turn)])
        centre = np.linalg.lstsq(design, np.hypot(flat[:, 0], flat[:, 1]), rcond=None)[0][:2]
        spreads.append(np.sqrt(np.linalg.inv(design.T @ design)[[0, 1], [0, 1]].max()))
        centres.append(feature.point_mm + height * require_direction(feature) + centre @ side)
        for source, rows in cells.view_contributions.items():
            moved[source].append(side.T @ (np.linalg.pinv(design)[:2] @ rows[section] / lean))
    width = zone_width("line", np.array(centres), criterion, found.name)
    across = tangents(require_direction(fit("line", np.array(centres))))
    by_views = {source: np.vstack([across[k] @ np.array(shifts) for k in range(2)]) for source, shifts in moved.items()}
    zone = Zone.of("line", np.array(centres), cells.noise_mm / lean * np.array(spreads), by_views)
    return _remove_noise([zone], width, criterion, settings, ", " + f"the axis through {len(whole)} sections")


def _line_straightness(described: DimensionProgram, found: FoundFeature, settings: InspectionSettings) -> Value:
    """Straightness of the lines of a plane along a given direction: the greatest of all lines."""
    feature = require_feature(found)
    normal = require_direction(feature)
    if described.along is None:
        raise InspectionError(f"{found.name} is a plane: its straightness needs `along`, the direction of the lines")
    wanted = np.asarray(described.along, float)
    line = wanted - (wanted @ normal) * normal
    if np.linalg.norm(line) < np.sin(np.radians(LEAST_SLANT_DEG)) * np.linalg.norm(wanted):
        raise InspectionError(f"{found.name}: `along` is perpendicular to the plane, which has no lines in that direction")
    line /= np.linalg.norm(line)
    offset = found.points_mm - feature.point_mm
    places = np.column_stack([offset @ np.cross(normal, line), offset @ line])
    keys = np.floor((places - places.min(axis=0)) / settings.form_cell_mm).astype(np.int64)
    cells = cell_means(found, feature, keys)
    lines = [mask for key in np.unique(cells.keys[:, 0]) if np.count_nonzero(mask := cells.keys[:, 0] == key) >= LEAST_ON_LINE]
    if not lines:
        raise InspectionError(f"{found.name}: no line is long enough for {LEAST_ON_LINE} cells of {settings.form_cell_mm:g} mm")
    position = (cells.points_mm - feature.point_mm) @ line
    widths = [_line_width(position[mask], cells.deviations_mm[mask], described.criterion) for mask in lines]
    zones = [
        Zone.of_profile(
            position[mask],
            cells.deviations_mm[mask],
            cells.noises_mm[mask],
            {source: rows[mask] for source, rows in cells.view_contributions.items()},
        )
        for mask in lines
    ]
    return _remove_noise(zones, max(widths), described.criterion, settings, ", " + f"the worst of {len(lines)} lines")


def _line_width(position: FloatArray, height: FloatArray, criterion: Criterion) -> float:
    """Return the height of the minimum-zone strip of a profile, or the range about its regression line."""
    design = np.column_stack([position, np.ones_like(position)])
    if criterion == "least-squares":
        return float(np.ptp(height - design @ np.linalg.lstsq(design, height, rcond=None)[0]))
    rows = np.vstack([np.column_stack([design, -np.ones_like(position)]), np.column_stack([-design, -np.ones_like(position)])])
    found = linprog([0, 0, 1], rows, np.concatenate([height, -height]), bounds=[(None, None)] * 3, method="highs")
    return float(2 * found.x[2])
