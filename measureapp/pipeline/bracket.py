"""Automatic choice of exposures by a rig, from a probe of the scene."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from measureapp.acquire.engine import run_once
from measureapp.acquire.tasks.probe import ProbeTask
from measureapp.data.fringe import FringeStack, PatternSet
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.devices.rig import Rig
from measureapp.errors import DecodeError
from measureapp.fringe.exposures import bracket
from measureapp.fringe.exposures.bracket import BracketLimits, BracketProposal
from measureapp.fringe.exposures.probe import read_probe
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.pipeline.events import ExposuresChosen
from measureapp.progress import NoProgress, Progress


def propose_bracket(
    rig: Rig,
    patterns: PatternSet,
    limits: BracketLimits,
    viewpoint: Viewpoint | None = None,
    noise: Mapping[str, CameraNoise] | None = None,
    compare: Mapping[str, Sequence[int]] | None = None,
    progress: Progress | None = None,
) -> BracketProposal:
    """Take one pattern group at two exposures and propose an exposure bracket for the visible scene.

    The patterns remain loaded in the projector. The rig's default bracket is compared with the proposal.

    Parameters
    ----------
    limits : time for all images of one viewpoint, number of exposures, limits of the rig
    viewpoint : where to take the probe; None: at the present position
    noise : measured camera noise; the default model for other cameras
    compare : further brackets to predict, by name

    Raises
    ------
    DecodeError
        Nothing visible can be decoded: all dark, or saturated at the shortest probe exposure.
    DeviceError
        From the rig.
    """
    progress = progress or NoProgress()
    taken: list[FringeStack] = []
    images = pattern_images(patterns, rig.projector.width_px, rig.projector.height_px)
    run_once(rig, "probe", viewpoint, ProbeTask(patterns, images, taken.append), progress)
    probe = read_probe(taken[0], noise or {})
    return bracket.propose_bracket(probe, patterns, limits, compare={"rig": rig.description.exposures_us, **(compare or {})})


def limits_of(rig: Rig, budget_s: float, planned: Sequence[int]) -> BracketLimits:
    """Return the limits of a bracket with no more exposures than ``planned``, at the speed of the connected cameras."""
    readout_s, transfer_s = (max(times) for times in zip(*((one.readout_s, one.transfer_s) for one in rig.cameras.values()), strict=True))
    return BracketLimits(budget_s, len(planned), 1e3 * readout_s, 1e3 * transfer_s, longest_us=max(rig.description.exposures_us))


def choose_at(
    rig: Rig,
    plan: ScanPlan,
    bracket_s: float,
    noise: Mapping[str, CameraNoise] | None,
    on_event: Callable[[ExposuresChosen], None],
) -> Callable[[FringeStack, tuple[int, ...]], tuple[int, ...]]:
    """Return a function that chooses the exposures of one viewpoint from a probe taken there, within ``bracket_s``.

    A viewpoint whose probe shows nothing that can be decoded keeps the exposures planned.
    """

    def choose(probe: FringeStack, planned: tuple[int, ...]) -> tuple[int, ...]:
        limits = limits_of(rig, bracket_s, planned)
        try:
            proposal = bracket.propose_bracket(read_probe(probe, noise or {}), plan.patterns, limits, compare={"plan": planned})
        except DecodeError as error:
            on_event(ExposuresChosen(planned, 0.0, 0.0, f"The probe shows nothing to choose by: {error.message}", probe.viewpoint_id))
            return planned
        share, planned_share = proposal.figures.decodable_share, proposal.compared["plan"].decodable_share
        on_event(ExposuresChosen(proposal.exposures_us, share, planned_share, proposal.note, probe.viewpoint_id))
        return proposal.exposures_us

    return choose
