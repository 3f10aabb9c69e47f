"""Capture of board views by the rig for one calibration: those of the plan, then more where the solution suggests them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.controllers import collecting_work as work
from ui.controllers.rig_connection import RigConnection
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan, Viewpoint
    from measureapp.data.rig import RigDescription
    from ui.controllers.collecting import CollectingController
    from ui.session import Session


class RigCapture:
    """Takes the views of one collection; ``rig`` is None if its images are recorded ones.

    Raises
    ------
    InputError
        The kinematic model that the rig description names cannot be read.
    """

    def __init__(self, collecting: CollectingController, session: Session, rig: RigDescription | None = None) -> None:
        from measureapp.project.geometry.robot_file import arm_of

        self._arm = None if rig is None else arm_of(rig)
        self._collecting, self._session = collecting, session
        self.rig = rig
        self.connection: RigConnection | None = None  # since the first view was taken
        self._planned: tuple[ScanPlan | None, tuple[Viewpoint, ...]] | None = None  # of a plan
        self._more = 0  # views beyond those planned that are still to be taken

    @property
    def viewpoints_left(self) -> tuple[Viewpoint, ...]:
        """The planned viewpoints from which no view was taken, or only a removed one."""
        snapshot = self._collecting.now
        if snapshot is None or self.rig is None:
            return ()
        taken = {image.name for view in snapshot.observations if view.status != "removed" for image in view.images.values()}
        return tuple(viewpoint for viewpoint in self._views_of(self.rig, self._session.plan) if viewpoint.id not in taken)

    @property
    def can_take_more(self) -> bool:
        """Whether the rig can take views beyond those planned that add information."""
        interim = self._collecting.solver.interim
        return interim is not None and interim.suggestion is not None

    @property
    def can_collect(self) -> bool:
        """Whether views can be added, planned ones or others."""
        return bool(self.viewpoints_left) or self.can_take_more

    @property
    def took_more(self) -> bool:
        """Whether views beyond those planned were taken before."""
        return any(view.name.startswith(work.BEYOND_PLAN) for view in self._collecting.views)

    def take(self, most: int | None = None) -> None:
        """Take the planned views that are still missing, at most so many of them."""
        self._take(self.viewpoints_left[:most])

    def take_more(self, count: int) -> None:
        """Take views beyond those planned, each at the viewpoint that adds most information after the one before was solved."""
        self._more = count
        self.take_next()

    def take_next(self) -> None:
        """Take the view that the newest solution suggests, if more views were requested."""
        if not self._more:
            return
        interim = self._collecting.solver.interim
        suggestion = None if interim is None else interim.suggestion
        self._more = 0 if suggestion is None else self._more - 1
        if suggestion is not None:
            self._take((suggestion.viewpoint,))

    def stop(self) -> None:
        """Take no more views beyond those planned."""
        self._more = 0

    def close(self) -> None:
        """Disconnect the rig."""
        if self.connection is not None and not self.connection.borrowed:
            self.connection.rig.close()

    def _views_of(self, rig: RigDescription, plan: ScanPlan | None) -> tuple[Viewpoint, ...]:
        """Return the planned viewpoints, calculated once per plan: joint angles for all of them take some tenths of a second."""
        from measureapp.planning.calibration_views import calibration_viewpoints

        if self._planned is None or self._planned[0] is not plan:
            kind = self._collecting.kind
            self._planned = plan, calibration_viewpoints(rig, plan, kind.motions, guide_at_zero=kind.guide_at_zero, arm=self._arm)
        return self._planned[1]

    def _take(self, viewpoints: tuple[Viewpoint, ...]) -> None:
        collected, rig, connection, live = self._collecting.collected, self.rig, self.connection, self._collecting.images.live
        if collected is None or rig is None or self._collecting.is_collecting or not viewpoints:
            return
        held = self._session.connection

        def run(job: Job) -> None:
            job.report(0, 1, "Connecting the rig")
            connected = connection
            if connected is not None and connected.rig.latch.reason and not connected.borrowed:
                connected.rig.close()  # it was stopped: connecting anew is the reset, with fresh read-backs
                connected = None
            connected = connected or work.connect_rig(job, rig, collected.setup.board, held)
            work.take(job, connected.rig, viewpoints, collected, live)

        self._collecting.run("Taking images of the board", run)
