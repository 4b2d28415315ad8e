# SPDX-License-Identifier: GPL-3.0-or-later
"""Going on with what was interrupted: who a run is, its files, and one process at a time.

Nothing here is public: runs, wear, tugging and sweeps take a folder or file, and do the rest.
"""
