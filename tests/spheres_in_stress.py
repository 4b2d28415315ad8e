# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere far below the surface of a body under uniform stress, against Eshelby and Goodier."""

import numpy as np

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)


def errors(ratio, per_radius):
    """Errors next to a sphere and of its mean stress, relative to the disturbance.

    ratio: of Young's moduli, 0 for a void. The sphere lies four radii below the surface, in a
    uniform initial stress along x. The first error is a root mean square over the full cells of
    the matrix within 1.5 radii.
    """
    radius = 1e-4
    h, depth, layers = radius / per_radius, 4 * radius, 6 * per_radius
    grid = sc.Grid(4 * per_radius + 1, 4 * per_radius + 1, h, h, dz=h)
    stressed = STEEL.with_residual_stress([0.0, 1.0], [1e8, 1e8], [0.0, 0.0])
    material = sc.Material.elastic(ratio * STEEL.E, STEEL.nu) if ratio > 0 else None
    place = (0.0, 0.0, depth)
    one = (
        sc.Inclusion.void(place, radius)
        if material is None
        else sc.Inclusion.sphere(place, radius, material)
    )
    sim = sc.Simulation(
        grid,
        sc.Material.rigid(),
        sc.Heterogeneous(stressed, [one]),
        sc.surfaces.paraboloid(grid, 5e-3),
        on_border="warn",
        tol=1e-4,
        image_tol=1e-5,
    )
    state = sim.state.at_layers(layers)
    found, share = state.stress(2), state.share(2)
    exact = sc.inclusions.eshelby_sphere(STEEL, material, [1e8, 0, 0, 0, 0, 0], radius=radius)
    at = np.meshgrid(grid.x, grid.y, grid.depths(layers) - depth, indexing="ij")
    around = (share == 0.0) & (np.linalg.norm(at, axis=0) < 1.5 * radius)
    expected = exact.stress(*at)[:, around]
    disturbance = np.linalg.norm(expected - exact.remote_stress[:, None])
    within = found[:, share == 1.0].mean(axis=1)
    deviation = np.linalg.norm(exact.interior_stress - exact.remote_stress)
    return (
        np.linalg.norm(found[:, around] - expected) / disturbance,
        np.linalg.norm(within - exact.interior_stress) / deviation,
    )
