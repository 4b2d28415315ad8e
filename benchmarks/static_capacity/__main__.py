# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.static_capacity: page of the loads for imprints of 1e-4 D."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
