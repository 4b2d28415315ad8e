# SPDX-License-Identifier: GPL-3.0-or-later
"""Films do not depend on the number of threads."""

from openmp import outputs_with

FILM = """
import hashlib, warnings, samcontact as sc
warnings.simplefilter("ignore")
steel = sc.Material.elastic(207e9, 0.3)
oil = sc.Lubricant.roelands(0.04, 22e-9)
grid = sc.Grid(150, 145, 6e-6, 6e-6)
gap = sc.surfaces.paraboloid(grid, 0.01)
film = sc.lubrication.steady(
    grid, steel, steel, gap, load=20.0, speed=(1.0, 0.5), lubricant=oil, tol=1e-4
)
digest = hashlib.sha256(film.pressure.tobytes() + film.film.tobytes())
print(digest.hexdigest())
"""


def test_threads_change_no_digit():
    one, other = outputs_with(FILM, 1, 3)
    assert one.strip()
    assert other == one
