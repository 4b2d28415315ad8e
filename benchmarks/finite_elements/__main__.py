# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.finite_elements: two contacts by finite elements and by samcontact."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
