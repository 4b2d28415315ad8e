# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of bodies with inclusions and of the functions that evaluate them."""

import numpy as np

import samcontact as sc
from samcontact.fatigue import FatigueField

STEEL = sc.Material.elastic(2e11, 0.3).with_thermal(40.0, 1.2e-5, 1e-5)
OXIDE = sc.Material.elastic(4e11, 0.25).with_thermal(30.0, 8e-6, 1e-5)
SPHERE = sc.Inclusion.sphere([0.0, 0.0, 6e-5], 3e-5, OXIDE)
BODY = sc.Heterogeneous(STEEL, [SPHERE])
GRID = sc.Grid(12, 12, 7e-6, 7e-6, dz=7e-6)
GAP = sc.surfaces.paraboloid(GRID, 1e-2)
STATE = sc.Simulation(GRID, sc.Material.rigid(), BODY, GAP).step(load=0.4)
AXES = {"x": np.asarray(GRID.x), "y": np.asarray(GRID.y), "z": np.asarray(STATE.depths)}
FIELD = FatigueField("max_von_mises", {}, np.asarray(STATE.von_mises(2)), "Pa", AXES, 2)
BOX = [[-1e-4, 1e-4], [-1e-4, 1e-4], [0.0, 1e-4]]
FLAT = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
TENSION = [0.0, 0.0, 1e8, 0.0, 0.0, 0.0]
SPHERE_IN_STRESS = sc.inclusions.eshelby_sphere(STEEL, OXIDE, TENSION)
MISFIT = sc.inclusions.MisfitSphere(2e11, 0.3, 1e-3, 1e-5, 3e-5)
FIT = sc.inclusions.weibull_fit([1.0, 2.0, 3.0, 5.0])
STEEL_OXIDES = sc.inclusions.LargestInclusion(2e-5, 4e-6, 1.5e-4, 12)
OXIDE_OF_STATE = sc.Inclusion.sphere([0.0, 0.0, 6e-5], 3e-6, OXIDE)
PLAIN_STATE = sc.Simulation(GRID, sc.Material.rigid(), STEEL, GAP).step(load=0.4)
(FINE_BOX,) = sc.inclusions.fine_boxes(PLAIN_STATE, [OXIDE_OF_STATE], cells_per_radius=4.0)
POINTS = {"x": 3e-5, "y": np.array([3e-5, 4e-5]), "z": 1e-5}

CALLS = [
    (
        "Inclusion",
        sc.Inclusion,
        {
            "center": [0.0, 0.0, 6e-5], "radii": [1e-5, 2e-5, 3e-5], "axes": FLAT.tolist(),
            "material": OXIDE, "misfit": 1e-3,
        },
    ),
    (
        "Inclusion.sphere",
        sc.Inclusion.sphere,
        {
            "center": [0.0, 0.0, 6e-5], "radius": 1e-5, "material": OXIDE,
            "misfit": [1e-3, 0.0, 0.0, 0.0, 0.0, 0.0],
        },
    ),
    (
        "Inclusion.ellipsoid",
        sc.Inclusion.ellipsoid,
        {
            "center": [0.0, 0.0, 6e-5], "radii": [1e-5, 2e-5, 3e-5], "material": OXIDE,
            "misfit": 1e-3, "axes": FLAT.tolist(),
        },
    ),
    ("Inclusion.metric", SPHERE.metric, {}),
    ("Heterogeneous", sc.Heterogeneous, {"matrix": STEEL, "inclusions": [SPHERE]}),
    (
        "Heterogeneous",
        sc.Heterogeneous,
        {
            "matrix": STEEL,
            "measured": sc.Heterogeneous.voxels(
                STEEL, OXIDE, np.ones((2, 2, 2), dtype=int), 1e-5, (0.0, 0.0, 1e-5)
            ).measured,
        },
    ),
    (
        "Heterogeneous.random",
        sc.Heterogeneous.random,
        {
            "matrix": STEEL, "material": OXIDE, "fraction": 0.05, "radius": (2e-5, 0.1), "box": BOX,
            "seed": 1, "gap": 0.1, "cover": 1e-6, "misfit": 1e-3, "radius_limits": (1e-5, 4e-5),
            "cluster": (3.0, 5e-5),
        },
    ),
    (
        "Heterogeneous.voxels",
        sc.Heterogeneous.voxels,
        {
            "matrix": STEEL, "materials": [OXIDE], "labels": 0.5 * np.ones((2, 2, 2)), "dx": 1e-5,
            "origin": [0.0, 0.0, 1e-5],
        },
    ),
    ("Heterogeneous.cells_on", BODY.cells_on, {"grid": GRID, "check": True}),
    ("Heterogeneous.fraction_on", BODY.fraction_on, {"grid": GRID}),
    ("Heterogeneous.cells_per_radius", BODY.cells_per_radius, {"grid": GRID}),
    ("Heterogeneous.volume_in", BODY.volume_in, {"box": BOX}),
    ("Heterogeneous.yield_stress_at", BODY.yield_stress_at, {"z": [1e-5, 2e-5]}),
    ("Heterogeneous.residual_stress_at", BODY.residual_stress_at, {"z": [1e-5, 2e-5]}),
    ("State.share", STATE.share, {"body": 2}),
    ("State.phase_strains", STATE.phase_strains, {"body": 2}),
    ("State.phase", STATE.phase, {"body": 2}),
    ("State.disturbance", STATE.disturbance, {"body": 2}),
    (
        "inclusions.thermal_misfit",
        sc.inclusions.thermal_misfit,
        {"inclusion": OXIDE, "matrix": STEEL, "temperature_change": -100.0},
    ),
    (
        "inclusions.eshelby_sphere",
        sc.inclusions.eshelby_sphere,
        {"matrix": STEEL, "material": OXIDE, "stress": TENSION, "misfit": 1e-3, "radius": 1e-5},
    ),
    ("inclusions.EshelbySphere.stress", SPHERE_IN_STRESS.stress, POINTS),
    (
        "inclusions.MisfitSphere",
        sc.inclusions.MisfitSphere,
        {"E": 2e11, "nu": 0.3, "misfit": 1e-3, "radius": 1e-5, "depth": 3e-5},
    ),
    ("inclusions.MisfitSphere.stress", MISFIT.stress, POINTS),
    (
        "inclusions.MisfitSphere.surface_displacement",
        MISFIT.surface_displacement,
        {"distance": [0.0, 1e-5]},
    ),
    (
        "inclusions.interface_stress",
        sc.inclusions.interface_stress,
        {"stress": TENSION, "eigenstrain": [1e-3] * 6, "normal": FLAT, "matrix": STEEL},
    ),
    ("inclusions.interfaces", sc.inclusions.interfaces, {"state": STATE, "body": 2}),
    (
        "inclusions.fine_boxes",
        sc.inclusions.fine_boxes,
        {
            "state": PLAIN_STATE, "inclusions": [OXIDE_OF_STATE], "body": 2,
            "cells_per_radius": 4.0, "within": 1.5, "tol": 1e-3,
        },
    ),
    (
        "inclusions.fine_field",
        sc.inclusions.fine_field,
        {"boxes": [FINE_BOX, FINE_BOX], "criterion": sc.fatigue.max_von_mises},
    ),
    ("inclusions.FineBox.interfaces", FINE_BOX.interfaces, {}),
    ("inclusions.FineBox.eigenstrain_on", FINE_BOX.eigenstrain_on, {"grid": GRID}),
    ("inclusions.interfaces", sc.inclusions.interfaces, {"state": STATE, "numbers": (0,)}),
    (
        "inclusions.statistics",
        sc.inclusions.statistics,
        {"states": [STATE, STATE], "body": 2, "within": 1.5, "slope": 0.3},
    ),
    ("inclusions.peaks", sc.inclusions.peaks, {"field": FIELD, "body": BODY, "within": 1.5}),
    (
        "inclusions.matrix_field",
        sc.inclusions.matrix_field,
        {"field": FIELD, "body": BODY, "within": 1.5},
    ),
    (
        "inclusions.butterflies",
        sc.inclusions.butterflies,
        {"field": FIELD, "body": BODY, "within": 1.5, "sectors": 12},
    ),
    ("inclusions.weibull_fit", sc.inclusions.weibull_fit, {"lives": [1.0, 2.0, 3.0]}),
    ("inclusions.WeibullFit.life", FIT.life, {"failed": 0.1}),
    ("inclusions.WeibullFit.shape_interval", FIT.shape_interval, {"confidence": 0.9}),
    (
        "inclusions.WeibullFit.life_interval",
        FIT.life_interval,
        {"failed": 0.1, "confidence": 0.9},
    ),
    (
        "inclusions.LargestInclusion",
        sc.inclusions.LargestInclusion,
        {"location": 2e-5, "scale": 4e-6, "area": 1.5e-4, "fields": 12},
    ),
    (
        "inclusions.LargestInclusion.fit",
        sc.inclusions.LargestInclusion.fit,
        {"maxima": [1e-5, 2e-5, 3e-5, 1.5e-5, 2.5e-5, 1.7e-5], "area": 1.5e-4},
    ),
    *(
        (f"inclusions.LargestInclusion.{name}", getattr(STEEL_OXIDES, name), {"volume": 1e-7})
        for name in ("return_period", "expected_in", "interval")
    ),
    (
        "inclusions.LargestInclusion.draw",
        STEEL_OXIDES.draw,
        {"volume": 1e-7, "count": 3, "seed": 1},
    ),
]  # fmt: skip
