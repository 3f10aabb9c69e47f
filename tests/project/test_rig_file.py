"""Rig descriptions by name."""

from __future__ import annotations

import pytest

from measureapp.errors import InputError
from measureapp.project.rig_file import read_rig


def test_a_rig_that_is_not_there_is_refused_with_the_names_of_those_that_are():
    with pytest.raises(InputError, match="There is no rig 'nosuch'") as refused:
        read_rig("nosuch")
    assert "paper" in refused.value.hint
