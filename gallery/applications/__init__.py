# SPDX-License-Identifier: GPL-3.0-or-later
"""Applications: nine engineering tasks answered by commands, with pages in docs/applications."""
