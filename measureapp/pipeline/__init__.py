"""The order of the stages, and the only place that knows it.

Images of the board become a rig calibration, fringe stacks become clouds, clouds become a part, the part becomes
dimensions and a report. Everything here works on a rig's images and read-backs alone.
"""
