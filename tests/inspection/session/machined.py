"""A block with a bore, and a program that measures it; single entries can be changed."""

from __future__ import annotations

from typing import Any

import numpy as np
from inspection.machined_part import Part

from measureapp.data.inspection_program import InspectionProgram

UP, SIDE = [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]


def machined_part(noise_mm: float = 0.01, count: int = 3000):
    part = Part(np.random.default_rng(5), noise_mm)
    part.square([0, 0, 30], UP, SIDE, count=count)
    part.square([0, 0, 0], [0, 0, -1], SIDE, count=count)
    part.square([30, 0, 15], SIDE, [0, 1, 0], half_mm=14, count=count)
    part.round([50, 0, 15], 8.0, length_mm=28, hole=True, count=2 * count)
    return part.at_its_place()


def program_of(**changes: Any) -> InspectionProgram:
    """Return the program; a change is a whole value of the program, or entries of the feature or dimension of this name."""
    features = [
        {"name": "top", "shape": "plane", "point_mm": [0, 0, 30], "direction": UP},
        {"name": "base", "shape": "plane", "point_mm": [0, 0, 0], "direction": [0, 0, -1]},
        {"name": "side", "shape": "plane", "point_mm": [30, 0, 15], "direction": SIDE},
        {"name": "bore", "shape": "cylinder", "point_mm": [50, 0, 15], "direction": UP, "radius_mm": 8, "hole": True},
        {"name": "mid", "shape": "midplane", "of": ["top", "base"]},
        *changes.pop("extra_features", []),
    ]
    dimensions = [
        {"name": "height", "kind": "distance", "features": ["top", "base"], "nominal": 30},
        {"name": "mid to base", "kind": "distance", "features": ["mid", "base"], "nominal": 15},
        {"name": "diameter", "kind": "diameter", "features": ["bore"], "nominal": 16},
        {"name": "position", "kind": "position", "features": ["bore"], "datums": ["base", "side", "front"], "upper_tolerance": 0.2},
        *changes.pop("extra_dimensions", []),
    ]
    dimensions[3]["datums"] = ["base"]
    dimensions[3]["kind"] = "perpendicularity"
    whole: dict[str, Any] = {"name": "block", "alignment": "none"}
    for name, change in changes.items():
        entry = next((one for one in (*features, *dimensions) if one["name"] == name), None)
        if entry is None:
            whole[name] = change
        else:
            entry.update(change)
            if "tolerance" in change:
                entry.pop("upper_tolerance", None)
    return InspectionProgram.model_validate({**whole, "features": features, "dimensions": dimensions})
