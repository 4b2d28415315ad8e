# SPDX-License-Identifier: GPL-3.0-or-later
"""What all tests need."""

import signal

# A shell starts its background jobs with Ctrl-C ignored, and children inherit that: tests that
# press it would wait for ever.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
