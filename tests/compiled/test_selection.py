"""The environment variable MEASUREAPP_KERNELS selects compiled kernels or their NumPy reference."""

from __future__ import annotations

import pytest

from measureapp.compiled.selection import VARIABLE, use_reference
from measureapp.errors import InputError


def test_compiled_kernels_are_the_default(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(VARIABLE, raising=False)
    assert not use_reference()


@pytest.mark.parametrize(("choice", "reference"), [("compiled", False), ("reference", True)])
def test_the_variable_selects_at_run_time(monkeypatch: pytest.MonkeyPatch, choice: str, reference: bool) -> None:
    monkeypatch.setenv(VARIABLE, choice)
    assert use_reference() is reference


@pytest.mark.parametrize("choice", ["numpy", "Reference", ""])
def test_any_other_value_is_refused_in_one_sentence(monkeypatch: pytest.MonkeyPatch, choice: str) -> None:
    monkeypatch.setenv(VARIABLE, choice)
    with pytest.raises(InputError) as caught:
        use_reference()
    assert str(caught.value) == f"The environment variable MEASUREAPP_KERNELS is '{choice}', but must be 'compiled' or 'reference'."
