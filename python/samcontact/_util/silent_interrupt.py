# SPDX-License-Identifier: GPL-3.0-or-later
"""Silent exit of the command ``samcontact`` on Ctrl-C while its modules are loaded.

Otherwise Python would print a traceback. No results exist at this stage; later, `commands.signals`
handles interruptions.
"""

import signal
import sys
import threading
from pathlib import PurePath


def is_command(script: str, words: list[str]) -> bool:
    """Whether Python was started by the ``samcontact`` script or ``python -m samcontact``."""
    if script == "-m":  # while Python searches for the module
        return words[words.index("-m") + 1 :][:1] == ["samcontact"]
    return PurePath(script).name == "samcontact"


if (
    is_command(sys.argv[0] if sys.argv else "", sys.orig_argv)
    and threading.current_thread() is threading.main_thread()
    and signal.getsignal(signal.SIGINT) is signal.default_int_handler
):
    signal.signal(signal.SIGINT, signal.SIG_DFL)
