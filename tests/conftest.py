# SPDX-License-Identifier: GPL-3.0-or-later
"""What all tests need."""

import signal

import hypothesis

# A shell starts its background jobs with Ctrl-C ignored, and children inherit that: tests that
# press it would wait for ever.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# What a test asks for says how much is tried; no clock does.
hypothesis.settings.register_profile("project", deadline=None, derandomize=True, database=None)
hypothesis.settings.load_profile("project")
