# SPDX-License-Identifier: GPL-3.0-or-later
"""A valid call of every public closed form, with all arguments."""

import math

import numpy as np

import samcontact as sc

INF = float("inf")
E, NU = 210e9, 0.3
E_STAR = E / (2 * (1 - NU**2))

STEEL = sc.Material.elastic(E, NU)
SOFT = sc.Material.linear_hardening(E, NU, 1e9, 21e9)
HOT = SOFT.with_thermal(50.0, 12e-6, 1.4e-5)
SURFACE_GRID = sc.Grid(7, 5, 1e-5, 2e-5)

POINT = sc.hertz.point(1e-2, E_STAR, load=10.0)
ELLIPSE = sc.hertz.elliptic(1e-2, 2e-2, E_STAR, load=10.0)
LINE = sc.hertz.line(1e-2, E_STAR, load_per_length=1e4)
COLLISION = sc.asperities.Collision(1e-3, 2e-3, 4e-6)
MEASURED = sc.measured.MeasuredSurface(1e-6 * np.arange(48.0).reshape(8, 6) ** 0.5, 1e-5, 2e-5)
X, Y, Z = np.array([0.0, 1e-5]), np.array([2e-5, 1e-5]), np.array([1e-5, 3e-5])

ELASTIC = {"E": E, "nu": NU}
RACE = sc.bearings.RaceContact(3e-3, 4e-2)
SPHERE = {"R": 1e-2, "E_star": E_STAR, "nu": NU, "yield_stress": 1e9}
RECTANGLE = {"X": X, "Y": Y, "a": 1e-5, "b": 2e-5}
HEAT = {"conductivity": 50.0, "diffusivity": 1.4e-5, "time": 1e-4, "velocity": (1.0, 0.5)}
FACES = {"low": -1e-3, "high": 1e-3, "method": "exact"}
TABLE = {"x": X, "y": Y, "a": 1e-5, "b": 2e-5, "tol": 1e-4, **HEAT}

STRESS = 1e8 * np.sin(np.arange(3 * 6 * 2.0)).reshape(3, 6, 2)
FATIGUE = sc.fatigue.dang_van(STRESS, slope=0.3)

CALLS = [
    ("fatigue.dang_van", sc.fatigue.dang_van, {"states": STRESS, "slope": 0.3}),
    ("fatigue.crossland", sc.fatigue.crossland, {"states": STRESS, "slope": 0.3}),
    ("fatigue.findley", sc.fatigue.findley, {"states": STRESS, "k": 0.3}),
    (
        "fatigue.fatemi_socie",
        sc.fatigue.fatemi_socie,
        {"states": STRESS, "k": 0.3, "yield_stress": 1e9, "material": STEEL},
    ),
    ("fatigue.orthogonal_shear", sc.fatigue.orthogonal_shear, {"states": STRESS, "axis": "y"}),
    (
        "fatigue.cycle",
        sc.fatigue.cycle,
        {"states": STRESS, "plastic_strain": 1e-12 * STRESS},
    ),
    (
        "fatigue.steady_cycle",
        sc.fatigue.steady_cycle,
        {
            "state": STRESS.reshape(6, 3, 2, 1),
            "axis": "y",
            "plastic_strain": 1e-12 * STRESS.reshape(6, 3, 2, 1),
        },
    ),
    ("fatigue.FatigueField.margin", FATIGUE.margin, {"limit": 3e8}),
    (
        "Grid",
        sc.Grid,
        {"nx": 3, "ny": 4, "dx": 1e-5, "dy": 2e-5, "nz": 2, "dz": 1e-5, "periodic": "y"},
    ),
    (
        "Material",
        sc.Material,
        {
            "law": "perfect_plastic",
            "parameters": {"E": E, "nu": NU, "yield_stress": 1e9},
            "kinematic": ((1e9, 0.0), (2e9, 3.0)),
            "thermal": (50.0, 12e-6, 1.4e-5),
            "softening": sc.softening.JohnsonCook(1800.0, 1.0),
            "yield_profile": ((0.0, 1e-3), (2.0, 1.0)),
            "residual_stress": ((0.0, 1e-3), (-1e8, 0.0), (-2e8, 0.0), (0.0, 0.0)),
            "free_faces": None, "relaxation_terms": None,
        },
    ),
    ("Material.elastic", sc.Material.elastic, ELASTIC),
    ("Material.rigid", sc.Material.rigid, {}),
    ("Material.perfect_plastic", sc.Material.perfect_plastic, {**ELASTIC, "yield_stress": 1e9}),
    (
        "Material.linear_hardening",
        sc.Material.linear_hardening,
        {**ELASTIC, "yield_stress": 1e9, "tangent_modulus": 1e9},
    ),
    (
        "Material.with_yield_profile",
        SOFT.with_yield_profile,
        {"z": [0.0, 1e-3], "factor": [2.0, 1.0]},
    ),
    (
        "Material.with_residual_stress",
        SOFT.with_residual_stress,
        {"z": [0.0, 1e-3], "sxx": [-1e8, 0.0], "syy": [-2e8, 0.0], "sxy": [1e8, 0.0]},
    ),
    ("Material.with_free_faces", STEEL.with_free_faces, FACES),
    ("Material.yield_factor", SOFT.yield_factor, {"z": Z}),
    ("Material.yield_stress_at", SOFT.yield_stress_at, {"z": Z}),
    ("Material.residual_stress_at", SOFT.residual_stress_at, {"z": Z}),
    ("Material.swift", sc.Material.swift, {**ELASTIC, "B": 945e6, "C": 20.0, "n": 0.12}),
    (
        "Material.voce",
        sc.Material.voce,
        {**ELASTIC, "yield_stress": 1e9, "saturation_stress": 2e9, "rate": 50.0},
    ),
    (
        "Material.tabulated",
        sc.Material.tabulated,
        {**ELASTIC, "plastic_strain": [0.0, 1e-3], "stress": [1e9, 2e9]},
    ),
    (
        "Material.with_kinematic_hardening",
        SOFT.with_kinematic_hardening,
        {"modulus": 1e9, "recovery": 2.0},
    ),
    (
        "Material.with_kinematic_hardening",
        SOFT.with_kinematic_hardening,
        {"modulus": [1e9, 2e9], "recovery": [0.0, 3.0]},
    ),
    (
        "Material.with_thermal",
        SOFT.with_thermal,
        {"conductivity": 50.0, "expansion": 1e-5, "diffusivity": 1e-5},
    ),
    ("Material.with_softening", SOFT.with_softening, {"law": sc.softening.JohnsonCook(1.8e3, 1.0)}),
    ("Material.yield_stress", SOFT.yield_stress, {"g": [0.0, 1e-3]}),
    ("Material.plastic_work", SOFT.plastic_work, {"g": [0.0, 1e-3]}),
    ("Material.uniaxial_stress", SOFT.uniaxial_stress, {"strain": [0.0, 1e-3]}),
    (
        "Relief",
        sc.Relief,
        {"heights": np.zeros((3, 5)), "first": 2, "periodic": False, "worn": np.ones((3, 5))},
    ),
    (
        "asperities.Collision",
        sc.asperities.Collision,
        {"R1": 1e-3, "R2": 2e-3, "interference": 1e-6},
    ),
    *(
        (f"asperities.Collision.{name}", getattr(COLLISION, name), {"angle": 0.01})
        for name in ("offset", "separation", "approach", "advance")
    ),
    (
        "asperities.Collision.grid",
        COLLISION.grid,
        {
            "increments": 8, "cells_per_increment": 1, "width": 1.8, "depth": 1.9, "dy": 1.0,
            "dz": 1.0,
        },
    ),
    (
        "bearings.LoadZone.load",
        sc.bearings.load_zone(100.0, 200.0, 8, 0.5).load,
        {"psi": 0.3},
    ),
    (
        "bearings.ball_load",
        sc.bearings.ball_load,
        {"radial_load": 1e3, "balls": 8, "contact_angle": 0.3, "epsilon": 0.5, "exponent": 1.5},
    ),
    *(
        (
            "bearings.ball_on_race",
            sc.bearings.ball_on_race,
            {
                "ball_diameter": 8e-3, "pitch_diameter": 4e-2, "contact_angle": 0.3,
                "race": "outer", **groove,
            },
        )
        for groove in ({"groove_radius": 4.2e-3}, {"conformity": 0.52})
    ),
    (
        "bearings.load_zone",
        sc.bearings.load_zone,
        {
            "radial_load": 100.0, "axial_load": 200.0, "balls": 8, "contact_angle": 0.5,
            "exponent": 1.5,
        },
    ),
    (
        "bearings.palmgren_deformation",
        sc.bearings.palmgren_deformation,
        {"race": RACE, "load": 1e3, "ball_diameter": 8e-3},
    ),
    (
        "bearings.roller_on_race",
        sc.bearings.roller_on_race,
        {
            "roller_diameter": 8e-3, "pitch_diameter": 4e-2, "crown_radius": 0.5,
            "contact_angle": 0.3, "race": "inner",
        },
    ),
    (
        "bearings.static_load_rating",
        sc.bearings.static_load_rating,
        {
            "races": [sc.bearings.RaceContact(3e-3, math.inf)], "balls": 8,
            "contact_angle": 0.3, "pressure": 4e9, "length": 1e-2, "rows": 2, "E_star": 1.1e11,
        },
    ),
    ("bearings.sjovall", sc.bearings.sjovall, {"epsilon": 0.5, "exponent": 1.5}),
    (
        "bearings.stribeck_load",
        sc.bearings.stribeck_load,
        {"radial_load": 1e3, "balls": 8, "contact_angle": 0.3},
    ),
    *(
        (f"critical.{name}", getattr(sc.critical, name), SPHERE)
        for name in ("green", "green_cylinder", "jackson_green", "onset", "onset_cylinder")
    ),
    ("critical.kogut_etsion", sc.critical.kogut_etsion, {**SPHERE, "hardness": 3e9}),
    (
        "critical.onset_cylinder_over_depth",
        sc.critical.onset_cylinder_over_depth,
        {"R": 1e-2, "E_star": E_STAR, "body": SOFT},
    ),
    (
        "critical.onset_over_depth",
        sc.critical.onset_over_depth,
        {"R": 1e-2, "E_star": E_STAR, "body": SOFT, "friction": 0.2},
    ),
    ("critical.onset_sliding", sc.critical.onset_sliding, {**SPHERE, "friction": 0.2}),
    *(
        (
            f"flattening.{name}", getattr(sc.flattening, name),
            {"interference": [0.0, 1e-6], **SPHERE},
        )
        for name in ("jackson_green", "kogut_etsion")
    ),
    (
        "dents.furrow",
        sc.dents.furrow,
        {"grid": SURFACE_GRID, "depth": 1e-6, "half_width": 3e-5, "along": "y", "position": 1e-5},
    ),
    (
        "dents.spherical",
        sc.dents.spherical,
        {"grid": SURFACE_GRID, "depth": 1e-6, "radius": 3e-5, "x": 1e-5, "y": 1e-5},
    ),
    *(
        (f"hardness.{name}", getattr(sc.hardness, name), {"HV": [300.0, 450.0]})
        for name in ("flow_stress_from_vickers", "yield_from_vickers")
    ),
    ("heat.factors", sc.heat.factors, {"friction": 0.2, "speed": 1.0, "partition": 0.4}),
    (
        "heat.partition",
        sc.heat.partition,
        {"body1": HOT, "body2": HOT, "radius": 1e-4, "velocity1": 0.5, "velocity2": 1.0},
    ),
    (
        "heat_kernels.steady_temperature",
        sc.heat_kernels.steady_temperature,
        {**RECTANGLE, "z": Z, "conductivity": 50.0},
    ),
    (
        "heat_kernels.steady_stress",
        sc.heat_kernels.steady_stress,
        {**RECTANGLE, "z": Z, "E": E, "expansion": 1e-5, "conductivity": 50.0},
    ),
    (
        "heat_kernels.steady_displacement",
        sc.heat_kernels.steady_displacement,
        {**RECTANGLE, "nu": NU, "expansion": 1e-5, "conductivity": 50.0, "r0": 1.0},
    ),
    ("heat_kernels.temperature", sc.heat_kernels.temperature, {**TABLE, "z": 1e-5}),
    (
        "heat_kernels.displacement",
        sc.heat_kernels.displacement,
        {**TABLE, "nu": NU, "expansion": 1e-5},
    ),
    (
        "heat_kernels.stress",
        sc.heat_kernels.stress,
        {**TABLE, **ELASTIC, "z": 1e-5, "expansion": 1e-5},
    ),
    ("hertz.effective_modulus", sc.hertz.effective_modulus, {"body1": STEEL, "body2": SOFT}),
    *(
        ("hertz.point", sc.hertz.point, {"R": 1e-2, "E_star": E_STAR, driver: value})
        for driver, value in (("load", 10.0), ("approach", 1e-6), ("p0", 1e9))
    ),
    *(
        (
            "hertz.elliptic",
            sc.hertz.elliptic,
            {"Rx": 1e-2, "Ry": 2e-2, "E_star": E_STAR, driver: value},
        )
        for driver, value in (("load", 10.0), ("approach", 1e-6), ("p0", 1e9))
    ),
    *(
        ("hertz.line", sc.hertz.line, {"R": 1e-2, "E_star": E_STAR, driver: value})
        for driver, value in (("load_per_length", 1e4), ("p0", 1e9))
    ),
    ("hertz.PointContact.pressure", POINT.pressure, {"x": X, "y": Y}),
    *(
        (f"hertz.{type(contact).__name__}.{name}", getattr(contact, name), {**depth, "nu": NU})
        for contact in (POINT, ELLIPSE, LINE)
        for name, depth in (("axis_stress", {"z": Z}), ("max_von_mises", {}))
    ),
    ("hertz.PointContact.gap", POINT.gap, {"x": X, "y": Y}),
    (
        "hertz.PointContact.stress",
        POINT.stress,
        {"x": X, "y": Y, "z": Z, "nu": NU, "friction": 0.1},
    ),
    ("hertz.EllipticContact.pressure", ELLIPSE.pressure, {"x": X, "y": Y}),
    ("hertz.LineContact.pressure", LINE.pressure, {"x": X}),
    ("hertz.LineContact.stress", LINE.stress, {"x": X, "z": Z, "nu": NU, "friction": 0.1}),
    ("shakedown.elliptic", sc.shakedown.elliptic, {"k": 2.0, "friction": 0.1}),
    *(
        (f"shakedown.{name}", getattr(sc.shakedown, name), {"friction": 0.2, "nu": NU})
        for name in ("line_kinematic", "point", "point_kinematic", "point_lower_bound")
    ),
    *(
        (
            f"shakedown.{name}",
            getattr(sc.shakedown, name),
            {"friction": 0.2, "nu": NU, "criterion": "tresca"},
        )
        for name in ("first_yield", "line")
    ),
    *(
        (f"kernels.{name}", getattr(sc.kernels, name), {**RECTANGLE, **rest})
        for name, rest in (
            ("pressure_displacement", {**ELASTIC, "axis": "x"}),
            ("shear_displacement", {**ELASTIC, "along": "y", "axis": "x"}),
            ("pressure_stress", {"z": Z, "nu": NU}),
            ("shear_stress", {"z": Z, "nu": NU, "along": "y"}),
        )
    ),
    (
        "kernels.eigenstrain_displacement",
        sc.kernels.eigenstrain_displacement,
        {**RECTANGLE, "zc": 4e-5, "c": 1e-5, "nu": NU, "axis": "x"},
    ),
    (
        "kernels.eigenstrain_stress",
        sc.kernels.eigenstrain_stress,
        {**RECTANGLE, "z": Z, "zc": 4e-5, "c": 1e-5, **ELASTIC},
    ),
    (
        "measured.MeasuredSurface",
        sc.measured.MeasuredSurface,
        {"heights": ((0.0, 1e-6), (2e-6, 0.0)), "dx": 1e-5, "dy": 2e-5, "attrs": {}},
    ),
    ("measured.MeasuredSurface.detrended", MEASURED.detrended, {"trend": "center"}),
    ("measured.MeasuredSurface.filled", MEASURED.filled, {}),
    ("measured.MeasuredSurface.mirrored", MEASURED.mirrored, {"axis": "x"}),
    (
        "measured.MeasuredSurface.on",
        MEASURED.on,
        {
            "grid": SURFACE_GRID, "x": 1e-6, "y": 1e-6, "method": "linear", "average": False,
            "fill": 0.0, "periodic": "",
        },
    ),
    (
        "measured.MeasuredSurface.relief",
        MEASURED.relief,
        {
            "grid": SURFACE_GRID, "x": 1e-6, "y": 1e-6, "periodic": False, "method": "linear",
            "average": False, "fill": 0.0,
        },
    ),
    (
        "softening.JohnsonCook",
        sc.softening.JohnsonCook,
        {"melting": 1800.0, "m": 1.0, "reference": 300.0, "ambient": 350.0, "floor": 0.01},
    ),
    ("softening.JohnsonCook.__call__", sc.softening.JohnsonCook(1800.0, 1.0), {"rise": [1.0, 2.0]}),
    ("surfaces.cylinder", sc.surfaces.cylinder, {"grid": SURFACE_GRID, "R": 1e-2, "axis": "y"}),
    (
        "surfaces.from_heights",
        sc.surfaces.from_heights,
        {
            "grid": SURFACE_GRID, "heights_lower": np.zeros((7, 5)),
            "heights_upper": np.ones((7, 5)),
        },
    ),
    ("surfaces.paraboloid", sc.surfaces.paraboloid, {"grid": SURFACE_GRID, "Rx": 1e-2, "Ry": 2e-2}),
    (
        "surfaces.rough_self_affine",
        sc.surfaces.rough_self_affine,
        {
            "grid": SURFACE_GRID, "rms_height": 1e-7, "hurst": 0.8, "wavelength_min": 4e-5,
            "wavelength_max": 1e-4, "roll_off": 8e-5, "seed": 1,
        },
    ),
    (
        "surfaces.sinusoidal",
        sc.surfaces.sinusoidal,
        {"grid": SURFACE_GRID, "amplitude": 1e-7, "wavelength_x": 5e-5, "wavelength_y": 6e-5},
    ),
    ("surfaces.sphere", sc.surfaces.sphere, {"grid": SURFACE_GRID, "R": 1e-2}),
    ("units.si", sc.units.si, {"value": 3.0, "unit": "m"}),
    ("units.si", sc.units.si, {"value": "3 mm", "unit": "m"}),
]  # fmt: skip
