# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.stability: cost and accuracy of extreme cases."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
