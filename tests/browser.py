# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages in headless Chromium, served by this process."""

from __future__ import annotations

import functools
import shutil
import threading
from contextlib import contextmanager
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

import pytest
from selenium import webdriver
from selenium.webdriver.chrome.service import Service

SWITCHES = (
    "--headless=new",
    "--no-sandbox",  # containers have none, and the pages are our own
    "--disable-dev-shm-usage",
    "--disable-gpu",
    "--window-size=1200,900",
)
NEVER = 10**12
"""Milliseconds: pages are as slow as the machine is busy."""


def _program(*names):
    found = [path for path in map(shutil.which, names) if path]
    if not found:
        pytest.fail(
            f"{names[0]} is missing: apt-get install chromium chromium-driver "
            "(on Ubuntu chromium-browser chromium-chromedriver)"
        )
    return found[0]


@contextmanager
def chromium(*more):
    """Return a driver of the browser, started with additional switches."""
    options = webdriver.ChromeOptions()
    options.binary_location = _program("chromium", "chromium-browser", "google-chrome")
    for switch in (*SWITCHES, *more):
        options.add_argument(switch)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    options.timeouts = {"script": NEVER, "pageLoad": NEVER}
    driver = webdriver.Chrome(options=options, service=Service(_program("chromedriver")))
    driver.command_executor.client_config.timeout = None
    try:
        yield driver
    finally:
        driver.quit()


@contextmanager
def served(folder):
    """Serve the files of a folder; yield its address and the list of requested paths."""
    asked = []

    class Handler(SimpleHTTPRequestHandler):
        def log_message(self, *_):
            asked.append(self.path)

    server = ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(Handler, directory=str(folder))
    )
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}", asked
    finally:
        server.shutdown()
        thread.join()
        server.server_close()
