"""The command line: `measureapp COMMAND …`. One file per command group; each has `register(app)`."""

import os

# Set before NumPy loads: the matrices are small, and more threads would not be faster but spend up to three quarters of the processor
# time waiting for each other. An explicit setting of the user takes precedence.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from measureapp.cli.main import main

__all__ = ["main"]
