# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.adhesion_peers: adhesive contact with other codes."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
