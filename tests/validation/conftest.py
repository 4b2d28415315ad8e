# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixture `measured`: compare a number with its reference and store it for validation.md."""

import pytest

import validation_page
from validation_page import Measured, Row

OPTION = "--write-validation"
ROWS = pytest.StashKey[list[Row]]()


def pytest_addoption(parser):
    parser.addoption(OPTION, action="store_true", help="write docs/validation.md from this run")


def writes(config):
    # The option is unknown when pytest meets this file only while it collects.
    return config.getoption(OPTION, False)


def pytest_configure(config):
    config.stash[ROWS] = []
    chosen = config.option.markexpr or config.option.keyword or any("::" in a for a in config.args)
    if writes(config) and chosen:
        raise pytest.UsageError(f"{OPTION} needs all tests of tests/validation")


def pytest_sessionfinish(session, exitstatus):
    if writes(session.config) and exitstatus == pytest.ExitCode.OK:
        validation_page.write(session.config.stash[ROWS])


@pytest.fixture
def measured(request):
    stored = None if writes(request.config) else validation_page.load()
    found = Measured(request.node.nodeid, stored)
    failed = request.session.testsfailed
    yield found
    request.config.stash[ROWS] += found.rows
    if request.session.testsfailed == failed:
        found.complete()
