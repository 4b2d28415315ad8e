# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of lubricated contacts by name, with unit, description and display."""

from __future__ import annotations

from .quantities import CONTACT, Q

FILMS = {
    "increment": Q("1", "number of the speed, load or instant, in the order of solution"),
    "x": CONTACT["x"],
    "y": CONTACT["y"],
    "body": CONTACT["body"],
    "z": CONTACT["z"],
    # scalars of each speed, load or instant
    "time": Q("s", "time since the start", "ms", "time", "time"),
    "speed": Q("m/s", "mean speed of the surfaces", "m/s", "mean speed", "mean\nspeed"),
    "load": CONTACT["load"],
    "approach": CONTACT["approach"],
    "max_pressure": Q("Pa", "maximum pressure", "MPa", "maximum pressure", "p_max"),
    "central_film": Q(
        "m", "film thickness where the undeformed gap is smallest", "µm", "central film",
        "central\nfilm",
    ),
    "minimum_film": Q("m", "minimum film thickness", "µm", "minimum film", "minimum\nfilm"),
    "lambda_ratio": Q(
        "1", "minimum film divided by the rms roughness of both surfaces", "", "lambda ratio",
        "lambda",
    ),
    "boundary_share": Q(
        "1", "share of the load that the boundary layer bears", "%", "share of boundary layer",
        "boundary\nlayer",
    ),
    "share_uncertainty": Q(
        "1", "estimated error of the share of the boundary layer due to the grid; NaN for shares "
        "above 0.1 or below 0.001", "%", "error of the share of boundary layer",
    ),
    "friction_coefficient": Q(
        "1", "friction coefficient; NaN if a Newtonian lubricant exceeds 0.15", "",
        "friction coefficient", "friction",
    ),
    "rolling_resistance": Q(
        "N", "force of the flow on each body against the mean velocity", "N", "rolling resistance"
    ),
    "power": Q("W", "dissipated power", "W", "dissipated power"),
    "heat": Q("W", "heat that enters both bodies", "W", "heat into the bodies"),
    "max_film_rise": Q(
        "K", "largest temperature rise in the middle of the film", "K", "temperature rise of film",
        "film\nrise",
    ),
    "max_surface_rise": Q(
        "K", "largest temperature rise of both surfaces", "K", "temperature rise of surfaces",
        "surface\nrise",
    ),
    "formula_central_film": Q("m", "central film by the formula", "µm", "central film, formula"),
    "formula_minimum_film": Q("m", "minimum film by the formula", "µm", "minimum film, formula"),
    "load_number": Q("1", "Moes' number M of the load", "", "load number M"),
    "lubricant_number": Q("1", "Moes' number L of the lubricant", "", "lubricant number L"),
    "max_von_mises": Q(
        "Pa", "largest von Mises stress of both bodies", "MPa", "maximum von Mises stress"
    ),
    "max_plastic_strain": Q(
        "1", "largest equivalent plastic strain of both bodies", "%", "maximum plastic strain",
        "plastic\nstrain",
    ),
    "max_residual_stress": Q(
        "Pa", "largest von Mises stress of the residual stress of both bodies", "MPa",
        "maximum residual stress",
    ),
    "imprint": Q(
        "m", "largest difference of the residual displacement of both bodies over the grid", "µm",
        "depth of the imprint",
    ),
    # convergence and resolution
    "gap_mismatch": Q(
        "1", "difference of the gap of the film and that of the yielded bodies, relative to the "
        "central film", "", "mismatch of film and plastic flow",
    ),
    "iterations": Q("1", "Newton iterations on the grid", "", "Newton iterations"),
    "residual": Q(
        "1", "largest imbalance of the flow of a cell, relative to the flow through the central "
        "film, or of the load", "", "residual",
    ),
    "flow_imbalance": Q(
        "1", "net outflow of the grid, relative to the flow of the central film", "",
        "flow imbalance of the grid",
    ),
    "inlet_pressure": Q(
        "1", "pressure next to an edge through which lubricant enters, relative to the maximum",
        "", "pressure at the inlet edge",
    ),
    "outlet_pressure": Q(
        "1", "pressure next to an edge through which lubricant leaves, relative to the maximum",
        "", "pressure at the outlet edge",
    ),
    "cells_per_radius": Q(
        "1", "radius of the contact, in cells", "cells", "cells per contact radius"
    ),
    "film_change": Q(
        "1", "relative change of the central film between the last two grids; NaN with one grid",
        "%", "change of the central film between grids",
    ),
    # fields
    "pressure": Q("Pa", "pressure", "GPa", "pressure", kind="magnitude"),
    "boundary_pressure": Q(
        "Pa", "pressure of the boundary layer", "GPa", "pressure of the boundary layer",
        kind="magnitude",
    ),
    "film": Q("m", "film thickness", "µm", "film thickness", kind="length"),
    "filling": Q(
        "1", "share of the film that is filled with lubricant", "%", "filling", kind="magnitude"
    ),
    "undeformed_gap": Q("m", "gap of the undeformed surfaces"),
    "smooth_gap": Q("m", "gap of the undeformed surfaces without moving reliefs"),
    "initial_gap": Q("m", "gap of the surfaces before any plastic strain"),
    "residual_displacement": Q(
        "m", "residual normal displacement of the surface of a body, positive into the body",
    ),
    "von_mises": CONTACT["von_mises"],
    "residual_von_mises": CONTACT["residual_von_mises"],
    "equivalent_plastic_strain": CONTACT["equivalent_plastic_strain"],
    "film_rise": Q("K", "temperature rise in the middle of the film"),
    "surface_rise": Q("K", "temperature rise of the surface of a body"),
    "heat_flux": Q("W/m^2", "heat flux into a body"),
    "heating_depth": Q("1", "root D of D tanh D = beta q h/(8 k), with the heat q per area"),
}  # fmt: skip
