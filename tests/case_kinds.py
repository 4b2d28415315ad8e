# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of all kinds, as dictionaries; together they contain every section and field."""

SWIFT = {
    "law": "swift", "E": 210e9, "nu": 0.3, "B": 945e6, "C": 20.0, "n": 0.121,
    "kinematic": {"modulus": [1e9], "recovery": [5.0]},
    "thermal": {"conductivity": 46.0, "expansion": 11e-6, "diffusivity": 13e-6},
    "softening": {"kind": "johnson_cook", "melting": 1800.0, "m": 1.0, "reference": 300.0,
                  "ambient": 300.0, "floor": 0.1},
    "yield_profile": {"z": [0.0, 1e-5], "factor": [2.0, 1.5]},
    "residual_stress": {"z": [0.0, 1e-5], "sxx": [-1e8, 0.0], "syy": [-2e8, 0.0],
                        "sxy": [1e7, 0.0]},
}  # fmt: skip
VOCE = {
    "law": "voce", "E": 210e9, "nu": 0.3, "yield_stress": 1e9, "saturation_stress": 2e9,
    "rate": 50.0, "thermal": SWIFT["thermal"],
}  # fmt: skip
TABULATED = {
    "law": "tabulated", "E": 210e9, "nu": 0.3, "plastic_strain": [0.0, 1e-3], "stress": [1e9, 2e9],
    "thermal": SWIFT["thermal"],
}  # fmt: skip
LAYER = {"E": 420e9, "nu": 0.22, "thickness": 2e-6}
FACED = {
    "law": "elastic",
    "E": 210e9,
    "nu": 0.3,
    "free_faces": {"low": -24e-6, "high": 18e-6, "method": "exact"},
}
RELAXING = {
    "law": "elastic",
    "E": 3e9,
    "nu": 0.4,
    "relaxation": {"times": [1e-3, 0.1], "shares": [0.3, 0.2]},
}
COATED = {"law": "elastic", "E": 210e9, "nu": 0.3, "layers": [LAYER, LAYER | {"E": 70e9}]}
COLD = {name: value for name, value in SWIFT.items() if name not in ("thermal", "softening")}
INCLUDED = {
    "E": 390e9, "nu": 0.25, "center": [0.0, 1e-6, 35e-6], "radius": 25e-6, "misfit": -1e-3,
}  # fmt: skip
ELLIPSOID = {
    "shape": "ellipsoid", "center": [3e-5, 0.0, 6e-5], "radii": [25e-6, 26e-6, 28e-6],
    "axes": [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
}  # fmt: skip
DRAWN = {
    "E": 390e9, "nu": 0.25, "fraction": 0.25, "radius": 25e-6, "spread": 0.1,
    "radius_limits": [24.5e-6, 30e-6], "misfit": 1e-3, "seed": 1, "gap": 0.1, "cover": 1e-6,
    "box": [[-4e-5, 4e-5], [-4e-5, 4e-5], [0.0, 1.5e-4]],
    "cluster": {"members": 3.0, "distance": 6e-5},
}  # fmt: skip
HARDENED = {name: value for name, value in SWIFT.items() if name != "yield_profile"}
GRID = {"nx": 16, "ny": 14, "dx": 5e-6, "dy": 6e-6, "nz": 4, "dz": 5e-6}
ROUGH = {
    "kind": "self_affine", "rms_height": 1e-8, "hurst": 0.7, "seed": 1, "wavelength_min": 15e-6,
    "wavelength_max": 60e-6, "roll_off": 40e-6,
}  # fmt: skip
SURFACE = {"shape": "paraboloid", "Rx": 1e-3, "Ry": 2e-3, "roughness": ROUGH}
CONTACT = {
    "friction": 0.1, "tol": 1e-6, "increment_tol": 1e-3, "on_border": "warn",
    "residual_stress": "fast", "image_tol": 2e-3, "max_iterations": 50,
    "reach": 1e-4,
}  # fmt: skip
HEAT = {
    "factor": [1e-3, 2e-3], "velocity": [[1.0, 0.0], [0.5, 0.0]], "time": 1e-3, "reference": 0.5,
}  # fmt: skip
RAMP = {
    "load": 2.0, "increments": 2, "start": 0.5, "spacing": "power", "exponent": 3.0,
    "advance": [1e-5, 5e-6], "heat_factor": [3e-3, 1e-3],
}  # fmt: skip
DENT = {"kind": "dent", "depth": 1e-7, "radius": 3e-5, "x": 1e-6, "y": 2e-6}
FURROW = {"kind": "furrow", "depth": 1e-7, "half_width": 2e-5, "along": "x", "position": 1e-6}
BASE = {
    "title": "t", "grid": GRID, "body1": SWIFT, "body2": SWIFT, "surface": SURFACE,
    "contact": CONTACT, "heat": HEAT, "path": [RAMP],
}  # fmt: skip
ROLL = {
    "distance": 1e-5, "step": 5e-6, "passes": 2, "unload_increments": 3, "slide_to_roll": -0.1,
}  # fmt: skip
MEASURED = {
    "path": "h.npy", "channel": 0, "detrend": "none", "unit": "um", "dx": 2e-6, "dy": 3e-6,
    "y": 1e-6, "mirror": "x", "method": "linear", "average": True, "fill": 1e-7, "x": 2e-6,
}  # fmt: skip
MARCHED = {"factor": [0.0, 2e-3], "velocity": HEAT["velocity"], "history": [1e-6, 1e-3]}
COARSE_CELLS = {
    "grid": {"nx": 8, "ny": 7, "dx": 1e-5, "dy": 1.2e-5, "dz": 1e-5},
    "surface": SURFACE | {"roughness": ROUGH | {"wavelength_min": 3e-5}},
}
FLAT = {"shape": "paraboloid", "Rx": 1e-3}
ASPERITIES = {
    "title": "t",
    "asperities": {"R1": 1e-3, "R2": 2e-3, "interference": 2e-6, "passes": 2,
                "back_and_forth": True,
                "cells_per_increment": 2, "increments": 12, "width": 1.7, "depth": 1.5},
    "body1": COLD, "body2": COLD, "relief1": DENT, "relief2": ROUGH,
    "contact": {k: CONTACT[k] for k in ("tol", "increment_tol", "on_border", "residual_stress",
                                        "image_tol", "max_iterations", "reach")},
}  # fmt: skip
WEAR = {"threshold": 2e-3, "cycles": 3, "worn": [2], "window": [3, 5], "order": 1}
WARM = COLD | {"thermal": SWIFT["thermal"]}
STICKS = {
    "title": "t", "grid": GRID, "body1": COLD, "body2": COLD, "surface": FLAT,
    "contact": {"friction": {"coulomb": 0.3}},
}  # fmt: skip
GEAR = {
    "shape": "gear", "module": 4.5e-3, "teeth": [16, 24], "face_width": 14e-3,
    "pressure_angle": 0.349, "profile_shift": [0.18, 0.17],
    "tip_diameter": [82.5e-3, 118.4e-3], "crowning": 1e-5, "tip_relief": [2e-5, 3e-5],
    "relief_length": [5e-3, 6e-3], "relief_exponent": 1.5, "position": -6e-3, "torque": 0.1,
    "sharing": "linear",
}  # fmt: skip
CAM = {"shape": "cam", "base_radius": 18e-3, "cam_angle": 0.3, "crown_radius": 1e-2}
PROFILES = {
    "shape": "wheel_rail", "rail": "rail.npy", "wheel": "wheel.npy", "wheel_radius": 0.46,
    "unit": "mm", "shift": 1e-3, "yaw": 1e-2, "roll": 1e-3, "smoothing": 1e-6,
}  # fmt: skip
ROLLER = {
    "shape": "roller",
    "diameter": 2e-3,
    "length": 65.5e-6,
    "pitch_diameter": 1e-2,
    "tilt": 1e-3,
    "skew": 0.05,
}
BEARING = {"shape": "bearing", "radial_load": 2.0, "axial_load": 1.0, "race": "inner"}
SIZED = BEARING | {
    "kind": "angular_contact", "element_diameter": 2e-3, "pitch_diameter": 1e-2, "elements": 8,
    "contact_angle": 0.6, "inner_conformity": 0.52, "outer_conformity": 0.54, "rows": 2,
    "axial_load": 5.0,
}  # fmt: skip
ROLLERS = {
    "shape": "bearing", "kind": "cylindrical_roller", "element_diameter": 2e-3, "elements": 8,
    "pitch_diameter": 1e-2, "length": 65.5e-6, "profile": "logarithmic", "radial_load": 2.0,
    "moment": 1e-6, "clearance": 1e-8,
}  # fmt: skip
PRESSED = {"body1": COLD, "body2": COLD, "heat": None, "path": [{"load": 2.0}]}
PYRAMID = {"tip_radius": 1e-5, "angle": 0.1, "half_angle": 1.4}
BALL = {"law": "elastic", "E": 210e9, "nu": 0.3}
OIL = {"kind": "roelands", "viscosity": 0.04, "pressure_viscosity": 22e-9}
FILM = {
    "title": "t", "body1": BALL, "body2": BALL | {"layers": [LAYER]},
    "lubricant": OIL | {"z": 0.6, "density": "incompressible", "eyring_stress": 5e6,
                        "limiting_shear": 0.05},
    "film": {"load": 20.0, "entrainment": 1.0, "slide_to_roll": 0.1, "angle": 0.3, "spin": 10.0,
             "supply": 1e-6, "roughness1": 1e-8, "roughness2": 2e-8, "order": 1, "tol": 1e-7,
             "max_iterations": 30,
             "boundary": {"thickness": 2e-9, "friction": 0.12, "pressure": 1e9}},
    "grid": {"nx": 24, "ny": 24, "dx": 2e-5, "dy": 2e-5, "contact_x": 4e-5, "contact_y": 2e-5},
    "surface": {"shape": "paraboloid", "Rx": 1e-2, "Ry": 2e-2},
}  # fmt: skip
SMOOTH_FILM = FILM | {"body2": BALL}
SLIDING = {
    "title": "t",
    "sliding": {"mean_pressure": 1e4, "slowest": 0.1, "fastest": 10.0, "per_decade": 2},
    "grid": {k: GRID[k] for k in ("nx", "ny", "dx", "dy")} | {"periodic": "xy"},
    "body1": {"law": "rigid"}, "body2": RELAXING, "surface": FLAT,
    "contact": {"tol": 1e-7, "on_border": "warn", "max_iterations": 100},
}  # fmt: skip
KINDS = {
    "contact": BASE,
    "flat punch": BASE | PRESSED
    | {"surface": {"shape": "flat_punch", "radius": 3e-5, "edge_radius": 1e-5}},
    "cone": BASE | PRESSED
    | {"surface": {"shape": "cone", "half_angle": 1.4, "tip_radius": 1e-5}},
    "Berkovich": BASE | PRESSED | {"surface": PYRAMID | {"shape": "berkovich"}},
    "Vickers": BASE | PRESSED | {"surface": PYRAMID | {"shape": "vickers"}},
    "gear": BASE | PRESSED | {"surface": GEAR, "path": [{"load_factor": 0.5}]},
    "roller": BASE | PRESSED
    | {"surface": ROLLER | {"race": "outer", "profile": "logarithmic"}},
    "crowned roller": BASE | PRESSED
    | {"surface": ROLLER | {"profile": "crowned", "crown_radius": 0.1, "straight_length": 1e-5}},
    "Lundberg's roller": BASE | PRESSED
    | {"surface": ROLLER | {"profile": "lundberg", "design_load": 2.0}},
    "measured roller": BASE | PRESSED
    | {"surface": ROLLER | {"profile": "table", "profile_y": [0.0, 4e-5],
                            "profile_drop": [0.0, 1e-8]}},
    "bearing": BASE | PRESSED
    | {"surface": BEARING | {"designation": "6208", "clearance": 1e-5, "moment": 1e-3},
       "path": [{"load_factor": 0.5}]},
    "bearing by its sizes": BASE | PRESSED | {"surface": SIZED, "path": [{"load_factor": 0.5}]},
    "bearing by its bore": BASE | PRESSED
    | {"surface": {"shape": "bearing", "radial_load": 2.0, "bore": 0.04,
                   "outside_diameter": 0.08},
       "path": [{"load_factor": 0.5}]},
    "roller bearing": BASE | PRESSED | {"surface": ROLLERS, "path": [{"load_factor": 0.5}]},
    "cam": BASE | PRESSED | {"surface": CAM | {"max_lift": 6e-3, "event_angle": 2.4}},
    "eccentric cam": BASE | PRESSED | {"surface": CAM | {"eccentricity": 2e-3}},
    "cam by its lifts": BASE | PRESSED
    | {"surface": CAM | {"lift_angle": [-1.2, -0.6, 0.0, 0.6, 1.2],
                         "lift": [0.0, 2e-3, 4e-3, 2e-3, 0.0]}},
    "wheel and rail": BASE | PRESSED | {"surface": PROFILES},
    "sphere": BASE | {"surface": {"shape": "sphere", "R": 1e-3}, "relief1": DENT,
                      "relief2": FURROW},
    "cylinder": BASE | {"surface": {"shape": "cylinder", "R": 1e-3, "axis": "x"}, "relief1": ROUGH},
    "sinusoidal": BASE
    | {"surface": FLAT | {"roughness": {"kind": "sinusoidal", "amplitude": 1e-8,
                                        "wavelength_x": 2e-5, "wavelength_y": 3e-5}}},
    "file": BASE
    | {"surface": {"shape": "file", "Rx": 1e-3, "Ry": 2e-3} | MEASURED,
       "relief2": {"kind": "file", "periodic": True} | MEASURED},
    "coated": BASE | {"body1": COLD, "body2": COATED, "heat": None, "path": [{"load": 2.0}]},
    "inclusions": BASE | COARSE_CELLS | {
        "body1": COLD, "heat": None,
        "body2": COLD | {"inclusions": [INCLUDED, ELLIPSOID | {"law": "void"}]},
        "path": [{"load": 2.0}]},
    "random inclusions": BASE | COARSE_CELLS | {
        "body1": COLD, "heat": None,
        "body2": COLD | {"random_inclusions": DRAWN}, "path": [{"load": 2.0}]},
    "coated by other laws": BASE | {"body1": COLD, "body2": SWIFT | {"layers": [
        SWIFT | {"thickness": 5e-6}, *(law | {"thickness": 10e-6} for law in (VOCE, TABULATED)),
    ]}, "heat": {"factor": [0.0, 2e-3], "time": 1e-3}, "path": [{"load": 2.0}]},
    "ending": BASE | {"grid": {k: GRID[k] for k in ("nx", "ny", "dx", "dy")}, "body1": FACED,
                      "body2": FACED, "heat": None,
                      "contact": CONTACT | {"friction": 0.0},
                      "path": [{k: v for k, v in RAMP.items() if k != "heat_factor"}]},
    "relaxing": BASE | {"grid": {k: GRID[k] for k in ("nx", "ny", "dx", "dy")}, "body1": RELAXING,
                        "body2": RELAXING, "heat": None,
                        "path": [{"load": 0.02, "increments": 2, "duration": 0.01},
                                 {"load": 0.02, "increments": 4, "duration": 0.1,
                                  "first_duration": 0.01}]},
    "Voce": BASE | {"body1": VOCE},
    "library": BASE | {"body2": {"material": "52100", "law": "swift"}},
    "tabulated": BASE | {"body2": TABULATED},
    "rolling": BASE
    | {"path": [{"load": 2.0, "increments": 2, "heat_factor": 0.0, "roll": ROLL}]},
    "sliding": BASE
    | {"path": [{"load": 2.0, "slide": {"distance": 1e-5, "step": 5e-6, "passes": 2,
                                        "unload_increments": 3, "slider": 1}}]},
    "judged": BASE
    | {"fatigue": {"dang_van": 0.3, "crossland": 0.3, "findley": 0.2, "fatemi_socie": 0.5,
                   "orthogonal_shear": "x", "yield_stress": 1e9,
                   "limit": {"dang_van": 3e8, "crossland": 3e8, "findley": 3e8,
                             "fatemi_socie": 4e-3, "orthogonal_shear": 4e8}}},
    "hardened": BASE
    | {"body1": HARDENED | {"hardness": {"z": [0.0, 3e-5], "HV": [600.0, 450.0]}},
       "body2": HARDENED | {"hardness": {"surface": 600.0, "core": 380.0, "depth": 2e-5,
                                         "limit": 500.0}},
       "fatigue": {"dang_van": 0.3, "exposure": {"slope": 0.2, "defect": 2e-5},
                   "life": {"criterion": "dang_van", "limit": 1e8, "exponent": 9.0,
                            "depth_exponent": 1.0, "weibull": 1.2, "length": 0.1}}},
    "repeated": BASE
    | {"path": [{k: v for k, v in RAMP.items() if k != "advance"}],
       "shakedown": {"cycles": 7, "tol": 2e-3, "accelerate": False}},
    "approach": BASE | {"path": [{"approach": 1e-7, "start": 1e-8}]},
    "dented": BASE | PRESSED
    | {"surface": FLAT, "dents": {"increments": 2, "E": 300e9, "nu": 0.2, "particles": [
        {"radius": 2e-4, "approach": 1e-6, "x": 5e-6, "y": 1e-6},
        {"radius": 1e-4, "load": 1.0, "x": 3e-6, "y": 2e-6}]}},
    "dented at random": BASE | PRESSED
    | {"surface": FLAT, "dents": {"random": {
        "length": 1e-4, "width": 4e-5, "density": 2e9, "radius": 1e-4, "spread": 0.1,
        "depth_ratio": 0.02, "x": 1e-5, "y": 1e-6, "seed": 3}}},
    "marched": BASE
    | {"heat": MARCHED, "path": [{"load": 1.0, "duration": 1e-4},
                                 {"load": 1.0, "duration": 1e-4}]},
    "marched sliding": BASE
    | {"heat": MARCHED | {"velocity": [-2.0, 0.0]}, "surface": FLAT,
       "path": [{"load": 1.0, "slide": {"distance": 1e-5, "step": 5e-6, "speed": 2.0}}]},
    "marched passes": BASE
    | {"heat": {"factor": [0.0, 2e-3], "history": [1e-6, 1e-3], "track": 2e-5}, "surface": FLAT,
       "path": [{"load": 1.0, "slide": {"distance": 1e-5, "step": 5e-6, "speed": 2.0, "passes": 2,
                                        "return_time": 1e-4}}]},
    "tilted": BASE
    | {"path": [{"load": 2.0, "increments": 2, "moment_x": 2e-9, "tilt_y": 1e-5},
                {"load": 3.0, "increments": 2, "moment_x": 1e-9, "tilt_y": 2e-5}]},
    "stick and slip": STICKS
    | {"path": [{"load": 2.0, "increments": 2, "spacing": "power", "exponent": 3.0,
                 "shift_x": 1e-8, "tangential_load_y": 0.1, "torque": 1e-9},
                {"load": 3.0, "increments": 2, "tangential_load_y": 0.05, "twist": 1e-6}]},
    "creeping": STICKS
    | {"path": [{"load": 2.0, "increments": 2,
                 "roll": ROLL | {"lateral_creepage": 1e-3, "spin": 2.0}},
                {"load": 2.0, "increments": 2, "roll": {
                    "distance": 1e-5, "step": 5e-6, "passes": 2, "tangential_load_x": 0.1}}]},
    "capped friction": STICKS
    | {"contact": {"friction": {"capped_coulomb": {"coefficient": 0.3, "limit": 1e8}}},
       "path": [{"load": 2.0, "shift_x": 1e-8}]},
    "friction in an ellipse": STICKS
    | {"contact": {"friction": {"anisotropic": {"mu_x": 0.3, "mu_y": 0.2, "angle": 0.5}}},
       "path": [{"load": 2.0, "shift_x": 1e-8}]},
    "friction of the place": STICKS
    | {"contact": {"friction": {"mapped_coulomb": {
        "coefficient": [0.2, 0.3, 0.3, 0.4], "x": [0.0, 1e-5], "y": [0.0, 1e-5], "body": 1}}},
       "path": [{"load": 2.0, "shift_x": 1e-8}]},
    "layer of particles": STICKS
    | {"contact": {"friction": {"third_body": {
        "coefficient": 0.3, "strength": 1e8, "shear_modulus": 1e8, "thickness": 1e-6,
        "hardening": 1e12}}},
       "path": [{"load": 2.0, "shift_x": 1e-8}]},
    "falling friction": STICKS
    | {"contact": {"friction": {"falling_coulomb": {
        "kinetic": 0.2, "drop": 0.1, "half_speed": 1.0, "memory": 1e-6}}},
       "path": [{"load": 2.0, "shift_x": 1e-8, "duration": 1e-3}]},
    "shear strength": STICKS
    | {"contact": {"friction": {"tresca": 1e8}}, "path": [{"load": 2.0, "shift_x": 1e-8}]},
    "hard": STICKS
    | {"contact": STICKS["contact"] | {"adhesion": {"kind": "hard"}},
       "path": [{"load": 2.0, "increments": 2}]},
    "attracted": STICKS
    | {"contact": STICKS["contact"]
       | {"adhesion": {"kind": "tensile_limit", "limit": 1e6}},
       "path": [{"load": 2.0, "increments": 2}]},
    "machine": STICKS
    | {"contact": {"adhesion": {"kind": "exponential", "work": 1.0, "range": 1e-7},
                   "stiffness": 1e6},
       "path": [{"approach": 1e-6, "increments": 2}, {"approach": -1e-6}]},
    **{
        f"adhesion {law['kind']}": STICKS
        | {"contact": {"adhesion": law},
           "path": [{"approach": 1e-6, "increments": 2}, {"approach": -1e-6}]}
        for law in (
            {"kind": "exponential", "work": 1.0, "range": 1e-7},
            {"kind": "dugdale", "work": 1.0, "stress": 1e7, "drop": 1e-7},
            {"kind": "lennard_jones", "work": 1.0, "z0": 2e-8},
            {"kind": "tabulated", "gap": [0.0, 1e-7, 2e-7], "stress": [1e7, 5e6, 0.0]},
        )
    },
    "pull off": STICKS
    | {"contact": {"adhesion": {"kind": "exponential", "work": 1.0, "range": 1e-7}},
       "path": [{"approach": 1e-6, "increments": 2}, {"pull_off": {"step": 1e-7}}]},
    "fretting": STICKS
    | {"path": [{"load": 2.0, "increments": 2},
                {"load": 2.0, "fret": {"tangential_load_x": 0.1, "tangential_load_y": 0.05,
                                       "cycles": 2}}]},
    "fretting heat": STICKS
    | {"body1": WARM, "body2": WARM, "heat": {"partition": 0.4, "time": 1e-3},
       "path": [{"load": 2.0, "increments": 2, "duration": 1e-3},
                {"load": 2.0, "duration": 1e-2, "fret": {"shift_x": 1e-8}}]},
    "friction of the temperature": STICKS
    | {"body1": WARM, "body2": WARM, "heat": {"partition": 0.4, "time": 1e-3},
       "contact": {"friction": {"thermal_coulomb": {
           "temperature": [1.0, 100.0], "coefficient": [0.3, 0.2], "bulk": 20.0}}},
       "path": [{"load": 2.0, "shift_x": 1e-8, "duration": 1e-3}]},
    "fretting by motion": STICKS
    | {"path": [{"load": 2.0, "increments": 2},
                {"load": 2.0, "fret": {"shift_x": 1e-8, "shift_y": 1e-9}}]},
    "wear": BASE | {"wear": WEAR | {"strain_depth": "smoothed"}},
    "running in": BASE | {"wear": {"threshold": 2e-3, "smoothing_length": 8e-6}},
    "fretting wear": STICKS
    | {"wear": {"energy": [1e-14, 2e-14], "cycles": 3, "repeats": 1000},
       "path": [{"load": 2.0, "increments": 2},
                {"load": 2.0, "fret": {"tangential_load_x": 0.1, "cycles": 2}}]},
    "Archard's wear": STICKS
    | {"wear": {"archard": 1e-14},
       "path": [{"load": 2.0}, {"load": 2.0, "fret": {"shift_x": 1e-8}}]},
    "marched wear": BASE
    | {"wear": WEAR | {"keep_heat": True}, "heat": MARCHED,
       "path": [{"load": 1.0, "duration": 1e-4}]},
    "film": FILM,
    "film by its grade": SMOOTH_FILM
    | {"lubricant": {"kind": "grade", "grade": "ISO VG 68", "temperature": 343.0,
                     "carreau_stress": 1e7, "carreau_exponent": 0.4},
       "film": {"load": 20.0, "speed1": 1.0, "speed2": [0.9, 0.1]}, "grid": {}},
    "film by a data sheet": SMOOTH_FILM
    | {"lubricant": {"kind": "oil", "nu40": 68e-6, "nu100": 8.5e-6, "mass_density": 860.0,
                     "temperature": 343.0},
       "film": {"approach": 1e-6, "entrainment": 1.0, "boundary": {"thickness": 2e-9}},
       "grid": FILM["grid"] | {"nx": 32}},
    "film of Barus": SMOOTH_FILM
    | {"lubricant": OIL | {"kind": "barus"}, "grid": {"cells_per_radius": 8},
       "film": {"load": 20.0, "speeds": [0.01, 1.0], "slide_to_roll": 0.1,
                "boundary": {"thickness": 2e-9}}},
    "film of Doolittle": SMOOTH_FILM
    | {"lubricant": {"kind": "doolittle", "viscosity": 0.04, "B": 4.0, "R0": 0.7,
                     "bulk_modulus": 1.4e9, "modulus_slope": 11.0},
"surface": GEAR | {"torque": 10.0},
       "film": {"pinion_speed": 150.0, "load_factor": 0.9}},
    "transient film": SMOOTH_FILM
    | {"lubricant": OIL, "relief1": DENT,
       "relief2": ROUGH | {"wavelength_min": 6e-5, "wavelength_max": 2e-4, "roll_off": 1.2e-4},
       "film": {"load": 20.0, "entrainment": 1.0, "slide_to_roll": 0.1, "transient": {
           "duration": 1e-4, "steps": 8, "times": [0.0, 1e-4], "load_factors": [1.0, 2.0],
           "speed_factors": [1.0, 0.5]}}},
    "pressed film": SMOOTH_FILM
    | {"lubricant": OIL, "body2": COLD, "relief2": DENT,
       "film": {"load": 20.0, "speed1": 1.0, "speed2": 0.0, "increments": 2},
       "grid": {"cells_per_radius": 8, "nz": 8, "dz": 1e-5}},
    "heated film": SMOOTH_FILM
    | {"lubricant": OIL | {"eyring_stress": 5e6, "thermal": {
           "conductivity": 0.14, "capacity": 1.7e6, "beta": 0.05, "temperature": 320.0}},
       "body1": BALL | {"thermal": SWIFT["thermal"]},
       "body2": BALL | {"thermal": SWIFT["thermal"]},
       "film": {"load": 20.0, "entrainment": 1.0, "slide_to_roll": 0.1, "shear_thinning": True,
                "thermal": True}, "grid": {"cells_per_radius": 8}},
    "film of a table": SMOOTH_FILM
    | {"lubricant": {"kind": "tabulated", "p": [0.0, 5e8, 1e9], "eta": [0.04, 10.0, 1e3],
                     "rho": [870.0, 970.0, 1000.0]},
       "surface": {"shape": "bearing", "designation": "6208", "radial_load": 2e3},
       "film": {"inner_speed": 300.0, "outer_speed": 10.0}, "grid": {}},
    "friction over velocity": SLIDING,
    "friction over velocities": SLIDING
    | {"sliding": {"load": 0.5, "velocities": [0.1, 1.0]}},
    "asperities": ASPERITIES,
    "tugging on a grid": ASPERITIES
    | {"grid": GRID, "asperities": {"R1": 1e-3, "R2": 2e-3, "interference": 2e-6}},
}  # fmt: skip
