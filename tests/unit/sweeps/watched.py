# SPDX-License-Identifier: GPL-3.0-or-later
"""An executor that acts while a sweep is running."""

import threading


class Watched:
    """An executor that calls something, once, when some of its tasks are done."""

    def __init__(self, executor, count, action):
        self.executor, self.left, self.action = executor, count, action
        self.lock = threading.Lock()

    def submit(self, *task):
        future = self.executor.submit(*task)
        future.add_done_callback(self._done)
        return future

    def _done(self, _):
        with self.lock:
            self.left -= 1
            due = self.left == 0
        if due:
            self.action()
