"""Geometrical tolerances that are chosen by clicking: their frame while it is chosen, why one is refused, and the edit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from ui.controllers.programming import ProgrammingController, added_words
from ui.look.language.words import for_name, tr
from ui.look.wording import sentence_case
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.control_frame import ControlFrame
    from measureapp.data.feature import Feature
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.inspection.programming.tolerance_frames import ToleranceChoice


class Tolerancing:
    """Adds and changes geometrical tolerances of the edited program."""

    def __init__(self, session: Session, programming: ProgrammingController) -> None:
        self._session, self._programming = session, programming

    @property
    def program(self) -> InspectionProgram | None:
        """The edited program, if it can be changed."""
        state = self._programming.state
        return state.program if state is not None and self._programming.can_change else None

    def names(self) -> tuple[str, ...]:
        """Return the features of the program, each copy of a pattern by its name."""
        from measureapp.data.inspection_program import copy_names

        program = self.program
        return () if program is None else tuple(name for one in program.features for name in copy_names(one.name, one.repeat))

    def letters(self) -> dict[str, str]:
        """Return the letter of each datum by its feature."""
        from measureapp.data.datum_letters import letters_of

        return {} if self.program is None else letters_of(self.program)

    def choice_of(self, name: str) -> ToleranceChoice | None:
        """Return what a dimension of the program states; None: it is no geometrical tolerance with a frame."""
        from measureapp.data.control_frame import CHARACTERISTICS
        from measureapp.inspection.programming.tolerance_frames import ToleranceChoice

        program = self.program
        entry = None if program is None else next((one for one in program.dimensions if one.name == name), None)
        return None if entry is None or entry.kind not in CHARACTERISTICS else ToleranceChoice.of(entry)

    def first_choice(self, feature: str, datums: Sequence[str], width_mm: float) -> ToleranceChoice | None:
        """Return what a new tolerance of a feature begins with; None without a program or a feature."""
        from measureapp.inspection.programming.tolerance_frames import first_choice

        program = self.program
        return None if program is None or not feature else first_choice(program, feature, datums, width_mm, self._features())

    def shape(self, feature: str) -> str:
        """Return the shape of a feature; empty: it is not known."""
        program = self.program
        known = self._features()
        if feature in known:
            return str(known[feature].shape)
        return "" if program is None else next((str(one.shape) for one in program.features if one.name == feature), "")

    def frame(self, choice: ToleranceChoice, former: str) -> ControlFrame | None:
        """Return the frame that a choice would have."""
        from measureapp.inspection.programming.tolerance_frames import frame_of

        program = self.program
        shapes = {name: str(one.shape) for name, one in self._features().items()}
        return None if program is None else frame_of(program, choice, shapes, former)

    def refusal(self, choice: ToleranceChoice, former: str) -> str:
        """Return why a choice cannot be used, in one sentence; empty: it can."""
        from measureapp.inspection.programming.tolerance_frames import refusal

        program = self.program
        return tr("No program is at hand, or a job is running.") if program is None else refusal(program, choice, self._features(), former)

    def apply(self, choice: ToleranceChoice, former: str) -> str:
        """Add or change a tolerance, which is measured at once; return its name, empty if it was refused."""
        from measureapp.inspection.programming.tolerance_frames import with_tolerance

        program = self.program
        if program is None or self.refusal(choice, former):
            return ""
        name = with_tolerance(program, choice, former, for_name)[1]
        words = tr("Tolerance of {name} changed.", name=sentence_case(name)) if former else added_words(name)
        return name if self._programming.edit(lambda program: with_tolerance(program, choice, former, for_name)[0], words) else ""

    def _features(self) -> Mapping[str, Feature]:
        """Return the nominal features, and the measured ones that have no nominal."""
        from measureapp.inspection.programming.nominals import nominals_of

        inspection, program = self._session.inspection, self.program
        measured = {} if inspection is None else {one.name: one for one in inspection.features}
        return measured if program is None else {**measured, **nominals_of(program)}
