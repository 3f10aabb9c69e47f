"""The command line: `measureapp COMMAND …`. One file per command group; each has `register(app)`."""

import os

# Before NumPy loads: the matrices here are small. More threads finish no sooner and take a third to three quarters of the processor
# time waiting for each other. Whoever knows better sets it.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from measureapp.cli.main import main

__all__ = ["main"]
