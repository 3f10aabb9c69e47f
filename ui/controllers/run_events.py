"""Transfer of run events to the session."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Slot

from ui.look.language.words import tr
from ui.look.wording import percent
from ui.messages import CALIBRATION, SHOW_CALIBRATION
from ui.session import RunNow, Session, ViewpointStatus
from ui.workers.job import Job

if TYPE_CHECKING:
    from collections.abc import Callable

    from measureapp.acquire.events import AcquisitionEvent, ImageTaken, RunEnded
    from measureapp.pipeline.events import CloudsKept, Event, ExposuresChosen, MemoryShort, ProcessingEvent, ResultKept, ValidityKnown


ENTERED: Mapping[str, tuple[ViewpointStatus, str]] = {  # state of a run's viewpoint -> state and note shown
    "waiting": ("waiting", ""),
    "moving": ("moving", ""),
    "confirming": ("moving", ""),
    "settling": ("settling", ""),
    "capturing": ("capturing", ""),
    "checking": ("checking", ""),
    "storing": ("storing", ""),
    "skipped": ("skipped", ""),
    "kept": ("stored", "earlier images kept"),
}


class RunEvents(QObject):
    """Applies events of a run to the session. `sink` is for the job's thread, `apply` for the window's thread."""

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session

    def sink(self, job: Job) -> Callable[[Event], None]:
        """Return the event handler for the job's thread: images go to the mailbox, other events to the window's thread."""
        from measureapp.acquire.events import ImageTaken

        images = self._session.images

        def receive(event: Event) -> None:
            if isinstance(event, ImageTaken):
                images.put(event.camera, event)
            job.emit_event(event)

        return receive

    @Slot(object)
    def apply(self, event: Event) -> None:
        """Apply one event to the session."""
        from measureapp.acquire.events import AcquisitionEvent

        if isinstance(event, AcquisitionEvent):
            self._apply_acquisition(event)
        else:
            self._apply_processing(event)

    def _apply_acquisition(self, event: AcquisitionEvent) -> None:
        from measureapp.acquire import events as e

        session = self._session
        match event:
            case e.RunStarted():
                session.await_viewpoints(event.viewpoint_ids)
                session.tell("The scan started.")
            case e.RunPaused():
                session.set_run(RunNow("paused", event.message, event.hint))
                session.tell(event.message, event.hint, "warning")
            case e.RunResumed():
                session.set_run(RunNow("running"))
                session.tell("The scan continues.")
            case e.RunEnded():
                self._report_end(event)
            case _:
                self._apply_viewpoint(event)

    def _apply_viewpoint(self, event: AcquisitionEvent) -> None:
        from measureapp.acquire import events as e

        session = self._session
        match event:
            case e.ViewpointStarted():
                session.set_viewpoint(event.viewpoint_id, "moving")
            case e.ViewpointEntered():
                self._enter(event.viewpoint_id, str(event.state))
            case e.ImageTaken():
                self._show_capture(event)
            case e.ViewpointRetaken():
                session.set_viewpoint(event.viewpoint_id, "moving", event.reason)
                session.tell(
                    tr("Viewpoint {viewpoint_id} is taken again: {reason}", viewpoint_id=event.viewpoint_id, reason=event.reason),
                    "",
                    "warning",
                )
            case e.ViewpointStored():
                session.set_viewpoint(event.viewpoint_id, "stored", f"{event.seconds:.1f} s")
            case e.ViewpointFailed():
                if event.viewpoint_id in session.viewpoints:  # not one of a calibration
                    session.set_viewpoint(event.viewpoint_id, "failed", event.reason)
                session.tell(
                    tr("Viewpoint {viewpoint_id} failed: {reason}", viewpoint_id=event.viewpoint_id, reason=event.reason),
                    "The scan continues with the next one.",
                    "warning",
                )
            case e.ViewpointSkipped():
                session.tell(
                    tr("Viewpoint {viewpoint_id} was skipped.", viewpoint_id=event.viewpoint_id), "Retake it if you need it after all."
                )
            case e.ViewpointQueued():
                session.tell(tr("Viewpoint {viewpoint_id}: {reason}", viewpoint_id=event.viewpoint_id, reason=event.reason))

    def _apply_processing(self, event: ProcessingEvent) -> None:
        from measureapp.pipeline import events as e

        session = self._session
        match event:
            case e.ExposuresChosen():
                self._report_exposures(event)
            case e.CalibrationReady():
                session.set_calibration(event.calibration)
                session.tell("The rig is calibrated.")
            case e.CloudsKept() | e.ResultKept() | e.MemoryShort():
                session.tell(_course(event))
            case e.ViewReady():
                session.add_view(event.view)
            case e.ViewFailed():
                session.set_viewpoint(event.viewpoint_id, "failed", event.reason)
                session.tell(
                    tr("Viewpoint {viewpoint_id} has no cloud: {reason}", viewpoint_id=event.viewpoint_id, reason=event.reason),
                    "Its images are stored.",
                    "warning",
                )
            case e.PartElsewhere():
                session.tell(event.sentence, "", "warning")
            case e.StitchReady():
                session.set_stitched(event.stitched)
                if event.stitched.axis_doubt:
                    session.tell(event.stitched.axis_doubt, "", "warning", cause=CALIBRATION, remedy=SHOW_CALIBRATION)
            case e.SurfaceFailed():
                session.tell(tr("No surface: {reason}", reason=event.reason), event.remedy, "warning")
            case e.InspectionReady():
                session.set_inspection(event.inspection)
            case e.ValidityKnown():
                self._report_validity(event)

    def _enter(self, viewpoint_id: str, state: str) -> None:
        """Show the state of a viewpoint; one that failed or was stored has an event of its own."""
        if viewpoint_id in self._session.viewpoints and state in ENTERED:
            status, note = ENTERED[state]
            self._session.set_viewpoint(viewpoint_id, status, note)

    def _show_capture(self, event: ImageTaken) -> None:
        known = self._session.viewpoints.get(event.viewpoint_id)
        if known is not None and known.status in {"waiting", "moving"}:
            self._session.set_viewpoint(event.viewpoint_id, "capturing")

    def _report_exposures(self, event: ExposuresChosen) -> None:
        """Report the exposures that a probe has chosen."""
        times = ", ".join(f"{exposure_us / 1000:g}" for exposure_us in event.exposures_us)
        where = tr("Viewpoint {viewpoint_id}: exposures", viewpoint_id=event.viewpoint_id) if event.viewpoint_id else "Exposures"
        shares = tr(
            "{decodable_share} of the lit pixels decodable, {planned_share} as planned",
            decodable_share=percent(event.decodable_share),
            planned_share=percent(event.planned_share),
        )
        self._session.tell(
            tr("{where} of {times}\xa0ms chosen by a probe: {figures}.", where=where, times=times, figures=shares), event.note
        )

    def _report_validity(self, event: ValidityKnown) -> None:
        """Report age and temperature before the scan, and camera drift after it."""
        self._session.set_validity(event.validity)
        drift = event.validity.drift
        if drift is None:
            for warning in event.validity.warnings:
                self._session.tell(warning, "", "warning", cause=CALIBRATION, remedy=SHOW_CALIBRATION)
        elif drift.status in ("watch", "drifted"):
            self._session.tell(
                drift.sentence, "", "error" if drift.status == "drifted" else "warning", cause=CALIBRATION, remedy=SHOW_CALIBRATION
            )

    def _report_end(self, event: RunEnded) -> None:
        if event.reason == "failed":
            self._session.tell(event.message or "The scan failed.", "", "error")
        elif event.reason == "done":
            self._session.tell("All images are taken.", "The clouds are computed and stitched.")
            if event.message:
                self._session.tell(event.message, "", "warning")


def _course(event: CloudsKept | ResultKept | MemoryShort) -> str:
    """Return in words what is not computed again, or not at once."""
    from measureapp.pipeline import events as e

    match event:
        case e.CloudsKept(count, of, placed_anew):
            if placed_anew:
                return tr("{count} of {of} clouds kept, placed anew.", count=count, of=of)
            return tr("{count} of {of} clouds kept as they were.", count=count, of=of)
        case e.ResultKept(what):
            if what == "calibration":
                return tr("The calibration is kept: it would come out as it is.")
            return tr("The stitched cloud is kept: it would come out as it is.")
        case e.MemoryShort(threads, usual, needed, available):
            return tr(
                "{threads} thread in place of {usual} detects the board: these would need about {needed} GiB of memory, and {available} GiB "
                "are available.",
                threads=threads,
                usual=usual,
                needed=f"{needed:.1f}",
                available=f"{available:.1f}",
            )
