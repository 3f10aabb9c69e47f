"""Rig descriptions by name."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from measureapp.data.rig import RigDescription
from measureapp.errors import InputError
from measureapp.project.rig_file import read_rig


def test_a_rig_that_is_not_there_is_refused_with_the_names_of_those_that_are():
    with pytest.raises(InputError, match="There is no rig 'nosuch'") as refused:
        read_rig("nosuch")
    assert "paper" in refused.value.hint


@pytest.mark.parametrize(
    ("field", "value"), [("name", ""), ("standoff_mm", -1.0), ("standoff_mm", 1e99), ("exposures_us", (-5,)), ("exposures_us", ())]
)
def test_a_rig_that_cannot_be_is_refused(field, value):
    with pytest.raises(ValidationError, match=field):
        RigDescription.model_validate(read_rig("paper").model_dump() | {field: value})
