#!/usr/bin/env python3
"""Sets MeasureApp up in this checkout, then runs or tests it. Needs nothing but Python 3.11, 3.12 or 3.13.

This file keeps to words that older Pythons can read, so that they can say what is missing.
"""

import sys

USAGE = """usage: python3 installer/bootstrap.py run [ARGUMENTS ...]
       python3 installer/bootstrap.py test [PYTEST ARGUMENTS ...]
       python3 installer/bootstrap.py proofs [ROOMS ...]

run    opens the application with the demo project; without a screen runs the demo and says where its report is.
       Further arguments go to `measureapp gui --demo`, or to `measureapp demo` where there is no screen.
test   checks style, types and import rules, then runs the tests. Further arguments go to pytest.
proofs runs the slow tests of all rooms, or of those named (`pipeline`, `benchmarks`), one file after the other, and measures virtual
       parts on every rig; `proofs/proofs.md` and `.json` state accuracy, coverage and speed. Ended early, it goes on where it was.

All first set up what is missing: the virtual environment `.venv` in the checkout with the locked packages, and on
Debian and Ubuntu the system libraries (as root; otherwise the line to run is printed). Exit code 2: the set-up is incomplete.
"""


def main(arguments):
    """Run one of the three commands and return its exit code."""
    if not (3, 11) <= sys.version_info[:2] <= (3, 13):
        sys.stderr.write(
            "MeasureApp needs Python 3.11, 3.12 or 3.13; this is Python %d.%d. "
            "Install one of these and start again with it, for example: python3.12 installer/bootstrap.py run\n" % sys.version_info[:2]
        )
        return 2
    if not arguments or arguments[0] in ("-h", "--help"):
        sys.stdout.write(USAGE)
        return 0 if arguments else 2
    import steps

    if arguments[0] not in steps.STEPS:
        sys.stderr.write("There is no command %r.\n\n%s" % (arguments[0], USAGE))
        return 2
    return steps.perform(arguments[0], arguments[1:])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
