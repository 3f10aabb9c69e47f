"""The order of the stages, and the only place that knows it.

Images of the board become a rig calibration, fringe stacks become clouds, clouds become a part, the part becomes
dimensions and a report. Everything here works on a rig's images and read-backs alone.
"""

from measureapp.pipeline.rig_calibration import calibrate_rig, solve_calibration
from measureapp.pipeline.run import NewProject, Outcome, ScanRequest, process, process_project, scan_into_project

__all__ = ["NewProject", "Outcome", "ScanRequest", "calibrate_rig", "process", "process_project", "scan_into_project", "solve_calibration"]
