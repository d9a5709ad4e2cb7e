"""Programs that can be interrupted, however the tests were started.

A shell that starts something in the background makes it ignore interrupts, and everything that this starts does so too.
"""

from __future__ import annotations

import signal


def can_be_interrupted() -> None:
    """For `preexec_fn` of subprocess.Popen: the program gets interrupts as it does in a terminal."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
