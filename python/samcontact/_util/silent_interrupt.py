# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C while the command ``samcontact`` is loaded ends it as it ends any program: silently.

Python would print the place in some library that was being imported. Nothing is under way that
could be lost; from then on `commands.signals` takes care.
"""

import signal
import sys
import threading
from pathlib import PurePath


def is_command(script: str, words: list[str]) -> bool:
    """Whether Python was started for it: by the script, or by ``python -m samcontact``."""
    if script == "-m":  # while the module is looked for
        return words[words.index("-m") + 1 :][:1] == ["samcontact"]
    return PurePath(script).name == "samcontact"


if (
    is_command(sys.argv[0] if sys.argv else "", sys.orig_argv)
    and threading.current_thread() is threading.main_thread()
    and signal.getsignal(signal.SIGINT) is signal.default_int_handler
):
    signal.signal(signal.SIGINT, signal.SIG_DFL)
