# SPDX-License-Identifier: GPL-3.0-or-later
"""Reference solutions by quadrature of textbook Green's functions, independent of samcontact."""
