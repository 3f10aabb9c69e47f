"""The command line: `measureapp COMMAND …`. One file per command group; each has `register(app)`."""

from measureapp.cli.main import main

__all__ = ["main"]
