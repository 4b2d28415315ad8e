# SPDX-License-Identifier: GPL-3.0-or-later
"""Names and units of the quantities in results, tables, figures and reports."""

from __future__ import annotations

from collections.abc import Mapping

from .inclusion_quantities import INCLUSIONS
from .quantity import Quantity as Quantity

Q = Quantity
_TRACK = "along the track of body {body}, unloaded"

CONTACT = {
    "x": Q("m", "x coordinate of cell centres"),
    "y": Q("m", "y coordinate of cell centres"),
    "z": Q("m", "depth of layer centres, positive into the body"),
    "increment": Q("1", "increment number"),
    "cell": Q("1", "indices of cells with plastic strain, counted along z, y, x"),
    "output_increment": Q("1", "number of an increment with stored volume fields"),
    "body": Q("1", "number of the body"),
    "component": Q("", "tensor component"),
    "side": Q("", "side of the interface"),
    # scalars of each increment
    "load": Q("N", "normal load", "N", "load", "load", 6),
    "approach": Q("m", "rigid-body approach", "µm", "approach", "approach", 6),
    "tilt_x": Q("rad", "rotation of body 1 relative to body 2 about x", "mrad", "tilt about x"),
    "tilt_y": Q("rad", "rotation of body 1 relative to body 2 about y", "mrad", "tilt about y"),
    "moment_x": Q("N m", "moment of the pressure on body 2 about x", "N m", "moment about x"),
    "moment_y": Q("N m", "moment of the pressure on body 2 about y", "N m", "moment about y"),
    "tangential_load_x": Q(
        "N", "tangential force on body 2 along +x", "N",
        "tangential force, x", "tangential\nforce, x",
    ),
    "tangential_load_y": Q(
        "N", "tangential force on body 2 along +y", "N",
        "tangential force, y", "tangential\nforce, y",
    ),
    "torque": Q("N m", "moment of the shear traction on body 2 about z", "N m", "torque", "torque"),
    "shift_x": Q(
        "m", "accumulated rigid-body displacement of body 1 relative to body 2, along +x", "µm",
        "tangential displacement, x", "tangential\ndisplacement, x",
    ),
    "shift_y": Q(
        "m", "accumulated rigid-body displacement of body 1 relative to body 2, along +y", "µm",
        "tangential displacement, y", "tangential\ndisplacement, y",
    ),
    "twist": Q(
        "rad", "accumulated rotation of body 1 relative to body 2 about z", "rad", "twist", "twist"
    ),
    "attraction_energy": Q(
        "J", "work against adhesion to open the gap", "J", "attraction energy"
    ),
    "load_work": Q("J", "work of the normal load since the first increment", "J", "work of load"),
    "friction_work": Q(
        "J", "frictional work since the start", "µJ", "frictional work", "frictional\nwork"
    ),
    "work_input": Q("J", "sum of the positive work increments since the start"),
    "net_external_work": Q("J", "net external work since the start", "", "net external work"),
    "expansion_work": Q(
        "J", "work of thermal expansion on the contact pressure and on the plastic strain", "",
        "work of thermal expansion",
    ),
    "elastic_energy": Q(
        "J", "elastic energy of the surface tractions after the last increment", "",
        "elastic energy of tractions",
    ),
    "residual_energy": Q(
        "J", "elastic energy of the residual stress of both bodies after the last increment", "",
        "elastic energy of residual stress",
    ),
    "plastic_work": Q(
        "J", "energy dissipated by plastic flow of both bodies since the start", "",
        "plastic dissipation",
    ),
    "stick_fraction": Q(
        "1", "fraction of the contact cells that stick in the increment", "%",
        "stick fraction", "stick\nfraction", 4,
    ),
    "max_shear": Q("Pa", "maximum shear traction", "MPa", "maximum shear"),
    "max_pressure": Q("Pa", "maximum contact pressure", "MPa", "maximum pressure", "p_max"),
    "contact_area": Q("m2", "contact area", "mm²", "contact area", "contact\narea"),
    "max_von_mises": Q(
        "Pa", "maximum von Mises stress", "MPa", "maximum von Mises stress", "von Mises"
    ),
    "max_equivalent_plastic_strain": Q(
        "1", "maximum accumulated equivalent plastic strain", "%",
        "maximum equivalent plastic strain",
        "plastic\nstrain", 4,
    ),
    "plastic_strain_per_cycle": Q(
        "1", "plastic strain change over the last cycle", "%", "plastic strain per cycle"),
    "plastic_flow_per_cycle": Q(
        "1", "plastic strain added by the last cycle", "%", "plastic flow per cycle"),
    "max_residual_von_mises": Q(
        "Pa", "maximum von Mises residual stress", "MPa",
        "maximum residual von Mises stress", "residual\nvon Mises",
    ),
    "imprint_depth": Q(
        "m", "residual imprint depth (within the grid)", "µm",
        "residual imprint depth (within the grid)", "imprint\ndepth",
    ),
    "max_temperature": Q(
        "K", "maximum temperature rise", "K", "maximum temperature rise", "temperature\nrise"
    ),
    "travel": Q(
        "m", "travel of the surface of body {body} through the contact, positive along +x", "µm",
        "travel", "travel", 6,
    ),
    "lateral_travel": Q(
        "m", "travel of the surface of body {body} through the contact, positive along +y", "µm",
        "travel along y", "travel along y", 6,
    ),
    "contact_origin": Q("m", "x position of the contact origin relative to the grid centre"),
    "offset": Q(
        "m", "offset of the volume fields of body {body} from the cells of the grid, along x"
    ),
    "time": Q("s", "time since the start", "s", "time"),
    "viscous_work": Q(
        "J", "energy dissipated by the viscosity since the start", "µJ", "viscous work",
        "viscous work",
    ),
    "heat_factor": Q("m/s", "heat flux per unit pressure into bodies 1 and 2"),
    # convergence and resolution
    "iterations": Q(
        "1", "fixed-point iterations for plastic strain", "", "plastic iterations", "iterations", 6
    ),
    "contact_iterations": Q(
        "1", "conjugate-gradient iterations of the contact solver", "", "contact iterations"
    ),
    "substeps": Q("1", "number of sub-increments", "", "sub-increments"),
    "falling_number": Q(
        "1", "maximum of -dmu/dv p C/t in the increment; above 1 a cell may have two solutions", "",
        "falling number",
    ),
    "joint_steps": Q("1", "Newton steps on pressure and shear together", "", "Newton steps"),
    "converged": Q("1", "whether the increment converged (1) or not (0)", "", "converged"),
    "contact_edge_distance": Q(
        "1", "minimum distance between contact and grid edge, in cells", "cells",
        "distance of contact from grid edge",
    ),
    "cells_across_contact": Q(
        "1", "width of the contact spot with maximum pressure, in cells", "cells", "contact width"
    ),
    "sharp_edge_cells": Q(
        "1", "number of contact cells at sharp edges, where the pressure is singular", "",
        "contact cells at sharp edges",
    ),
    "area_uncertainty": Q(
        "1", "relative uncertainty of the contact area", "%", "contact area uncertainty"
    ),
    "plastic_strain_residual": Q(
        "1", "relative change of the plastic strain increment at convergence", "",
        "plastic-strain residual",
    ),
    "yield_violation": Q(
        "1", "maximum of (von Mises stress - yield stress)/yield stress at convergence", "",
        "yield violation",
    ),
    "max_plastic_strain_magnitude": Q(
        "1", "maximum plastic strain magnitude sqrt(2/3 e:e) (non-cumulative)"
    ),
    "plastic_edge_distance": Q(
        "1", "minimum distance between plastic zone and volume edge, in cells", "cells",
        "distance of plastic zone from volume edge",
    ),
    "layers_across_plastic_zone": Q(
        "1", "thickness of the plastic zone, in layers", "layers", "thickness of the plastic zone"
    ),
    # surface fields
    "pressure": Q("Pa", "contact pressure", "GPa", "pressure", kind="magnitude"),
    "repulsion": Q("Pa", "contact pressure without the adhesive part", "GPa", "repulsion"),
    "adhesion_stress": Q("Pa", "attraction between the surfaces", "MPa", "attraction"),
    "gap": Q("m", "gap under load", "µm", "gap", kind="length"),
    "shear_x": Q(
        "Pa", "shear traction on body 2 along +x", "MPa", "shear traction, x", kind="signed"
    ),
    "shear_y": Q(
        "Pa", "shear traction on body 2 along +y", "MPa", "shear traction, y", kind="signed"
    ),
    "slip_x": Q("m", "slip of body 1 relative to body 2 in the increment, along +x"),
    "slip_y": Q("m", "slip of body 1 relative to body 2 in the increment, along +y"),
    "sticking": Q("1", "1 in contact cells that stick in the increment, else 0"),
    "plastic_slip": Q("m", "plastic slip of the layer between the bodies so far"),
    "slip_rate": Q("m/s", "slip rate that determines the friction of the cell"),
    "residual_displacement": Q(
        "m", "residual normal surface displacement of body {body}, positive into the body", "µm",
        "residual displacement", kind="signed",
    ),
    "initial_gap": Q("m", "initial gap of the undeformed surfaces"),
    "equivalent_pressure": Q(
        "Pa", "pressure that displaces an elastic body as this viscoelastic body is displaced",
        "GPa", "equivalent pressure", kind="signed",
    ),
    "surface_temperature": Q(
        "K", "temperature rise of the surface", "K", "temperature rise", kind="heat"
    ),
    # volume fields
    "stress": Q("Pa", "stress, positive in tension", "MPa", "stress", kind="signed"),
    "von_mises": Q("Pa", "von Mises stress", "MPa", "von Mises stress", kind="magnitude"),
    "hydrostatic": Q(
        "Pa", "mean normal stress, positive in tension", "MPa", "hydrostatic stress", kind="signed"
    ),
    "equivalent_plastic_strain": Q(
        "1", "accumulated equivalent plastic strain", "%", "equivalent plastic strain",
        kind="strain",
    ),
    "plastic_strain": Q(
        "1", "plastic strain (tensor components)", "%", "plastic strain", kind="signed"
    ),
    "residual_stress": Q(
        "Pa", "residual stress (without surface tractions and heat)", "MPa", "residual stress",
        kind="signed",
    ),
    "residual_von_mises": Q(
        "Pa", "von Mises stress of the residual stress", "MPa", "residual von Mises stress",
        kind="magnitude",
    ),
    "residual_hydrostatic": Q(
        "Pa", "mean normal stress of the residual stress, positive in tension", "MPa",
        "residual hydrostatic stress", kind="signed",
    ),
    "temperature": Q("K", "temperature rise", "K", "temperature rise", kind="heat"),
    "share": Q("1", "share of the cell that inclusions fill", "%", "share of inclusions"),
    "phase": Q("1", "number of the inclusion in most of the cell, from 0; -1 in the matrix"),
    "eigenstrain": Q("1", "eigenstrain with the effect of inclusions and plastic strain"),
    **INCLUSIONS,
    # interfaces between layers
    "interface": Q("m", "depth of the interfaces between layers"),
    "interface_stress": Q("Pa", "stress above and below the interfaces, positive in tension"),
}  # fmt: skip

TRACK = {
    "x": Q("m", "position along the track on body {body}; 0 at the initial contact position"),
    "residual_displacement": Q(
        "m", f"residual normal surface displacement, positive into the body, {_TRACK}"
    ),
    "residual_stress": Q("Pa", f"residual stress {_TRACK}"),
    "residual_von_mises": Q("Pa", f"von Mises stress of the residual stress {_TRACK}"),
    "residual_hydrostatic": Q("Pa", f"mean normal stress of the residual stress {_TRACK}"),
    "plastic_strain": Q("1", f"plastic strain (tensor components) {_TRACK}"),
    "equivalent_plastic_strain": Q("1", f"accumulated equivalent plastic strain {_TRACK}"),
}

ASPERITIES = {
    # scalars of each increment
    "offset": Q("m", "horizontal distance of the centres"),
    "angle": Q("rad", "angle of the line of centres from the vertical"),
    "approach": Q("m", "approach along the line of centres"),
    "normal_force": Q("N", "contact force along the line of centres"),
    "force_x": Q(
        "N", "force of sphere 1 on sphere 2 along X, required to move sphere 1 along +X", "N",
        "tangential force", "F_x",
    ),
    "force_y": Q("N", "force of sphere 1 on sphere 2 along Y"),
    "force_z": Q("N", "downward force of sphere 1 on sphere 2", "N", "normal force", "F_z"),
    "load_ratio": Q("1", "ratio force_x/force_z"),
    "work": Q("J", "work of force_x since the start of the pass"),
    "plastic_work": Q("J", "plastic work of both bodies since the start of the first pass"),
    "max_pressure": CONTACT["max_pressure"],
    "contact_area": CONTACT["contact_area"],
    "max_equivalent_plastic_strain": Q("1", "maximum equivalent plastic strain of a body"),
    "cells_across_contact": CONTACT["cells_across_contact"],
    "layers_across_plastic_zone": CONTACT["layers_across_plastic_zone"]._replace(
        long_name="thickness of the plastic zone of a body, in layers"
    ),
    # scalars of each pass
    "pass": Q("1", "pass number"),
    "net_energy": Q("J", "work of force_x over the pass", "J", "net energy", "net energy"),
    "dissipation": Q(
        "J", "plastic work of both bodies in the pass", "J", "plastic work", "plastic\nwork"
    ),
    "residual_energy": Q(
        "J", "elastic energy of the residual stress of both bodies after the pass", "J",
        "energy of the residual stress", "stored\nenergy",
    ),
    "energy_imbalance": Q(
        "J", "net energy minus dissipation and minus increase of residual energy", "J",
        "unaccounted net energy",
    ),
    "residual_displacement": Q(
        "m", "residual imprint depth of a body after the pass", "µm", "residual imprint depth",
        "imprint\ndepth",
    ),
    "max_force_x": Q(
        "N", "maximum force_x of the pass", "N", "maximum tangential force", "F_x max"
    ),
    "min_force_x": Q(
        "N", "minimum force_x of the pass", "N", "minimum tangential force", "F_x min"
    ),
    "max_force_z": Q("N", "maximum force_z of the pass", "N", "maximum normal force", "F_z max"),
}  # fmt: skip


def described(name: str, among: Mapping[str, Quantity] = CONTACT) -> tuple[Quantity, int | None]:
    """Return the quantity and the body number of a variable; the number is None without a body."""
    kind, _, body = name.partition("_body")
    return among[kind], int(body) if body else None
