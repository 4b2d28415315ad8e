# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.viscous_peers: viscoelastic contact with tamaas."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
