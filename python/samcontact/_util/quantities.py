# SPDX-License-Identifier: GPL-3.0-or-later
"""What results, tables, figures and reports call each quantity, and in which units they give it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import xarray as xr

_FACTORS = {
    "µm": 1e6,
    "µm²": 1e12,
    "mm²": 1e6,
    "µm³": 1e18,
    "MPa": 1e-6,
    "GPa": 1e-9,
    "%": 1e2,
    "µJ": 1e6,
}
"""From SI to the unit shown, where that is another one."""
_SMALL_AREA = 1e-8  # [m^2]
_COLOURS = {
    "magnitude": "viridis",
    "criterion": "viridis",
    "signed": "RdBu_r",
    "strain": "magma_r",
    "heat": "inferno",
    "length": "cividis",
    "height": "cividis",
    "any": "viridis",
}
"""Colour map of each kind of field."""


class Quantity(NamedTuple):
    """One quantity; what the last fields do not tell is not shown there."""

    unit: str
    """Of values in files and in Python: SI, "1" for a pure number."""
    long_name: str
    """Of files. The body is named where it has "{body}", else at its end."""
    shown: str = ""
    """Unit in tables, reports and figures."""
    heading: str = ""
    """Of its column in a report, and its name in figures."""
    short: str = ""
    """Of its column on a terminal."""
    digits: int = 5
    """Of the largest value on a terminal."""
    kind: str = ""
    """Of a field: decides its colours. Only "signed", "height", "criterion" and "any" go
    below zero."""

    @property
    def factor(self) -> float:
        """From SI to the unit shown."""
        return _FACTORS.get(self.shown, 1.0)

    @property
    def colours(self) -> str:
        """Colour map of its kind."""
        return _COLOURS[self.kind]

    @property
    def signed(self) -> bool:
        """Whether its colours are those of both signs, with white for zero."""
        return self.kind == "signed"

    @property
    def from_zero(self) -> bool:
        """Whether it is never below zero, where its colours begin."""
        return self.kind not in ("signed", "height", "criterion", "any")

    @property
    def label(self) -> str:
        """Of an axis, or of a column of a report."""
        return self.of()

    def of(self, body: int | None = None) -> str:
        """The same with a body."""
        name = self.heading if body is None else f"{self.heading}, body {body}"
        return f"{name} [{self.shown}]" if self.shown else name

    def column(self, body: int | None = None) -> str:
        """Heading on a terminal, in two lines."""
        name = self.short if body is None else f"{self.short} {body}"
        if not self.shown:
            return name
        return f"{name} [{self.shown}]" if "\n" in name else f"{name}\n[{self.shown}]"

    def fitting(self, largest: float) -> Quantity:
        """With the unit in which an area of this size [m^2] reads well."""
        small = self.unit == "m2" and largest < _SMALL_AREA
        return self._replace(shown="µm²") if small else self

    def variable(self, dims: Any, data: Any, body: int | None = None) -> xr.Variable:
        """A variable of a dataset with its unit and name."""
        import xarray as xr  # here, since importing the package should not load it

        text = self.long_name
        if body is not None:
            text = text.format(body=body) if "{body}" in text else f"{text}, body {body}"
        return xr.Variable(dims, data, {"units": self.unit, "long_name": text})


Q = Quantity
_TRACK = "along the track, body {body}, unloaded"

CONTACT = {
    "x": Q("m", "cell centres along x"),
    "y": Q("m", "cell centres along y"),
    "z": Q("m", "depths of the layer centres, into the body"),
    "increment": Q("1", "number of the load increment"),
    "cell": Q("1", "numbers of cells with plastic strain, counted along z, y, x"),
    "volume_increment": Q("1", "increments with volume fields"),
    "body": Q("1", "number of the body"),
    # of each increment
    "load": Q("N", "normal load", "N", "load", "load", 6),
    "approach": Q("m", "rigid-body approach", "µm", "approach", "approach", 6),
    "tangential_load_x": Q(
        "N", "force of the shear on body 2 along +x", "N",
        "force along x", "force\nalong x",
    ),
    "tangential_load_y": Q(
        "N", "force of the shear on body 2 along +y", "N",
        "force along y", "force\nalong y",
    ),
    "torque": Q("N m", "moment of the shear on body 2 about z", "N m", "torque", "torque"),
    "shift_x": Q(
        "m", "rigid motion of body 1 over body 2 along +x", "µm",
        "shift along x", "shift\nalong x",
    ),
    "shift_y": Q(
        "m", "rigid motion of body 1 over body 2 along +y", "µm",
        "shift along y", "shift\nalong y",
    ),
    "twist": Q("rad", "turn of body 1 over body 2 about z", "rad", "twist", "twist"),
    "attraction_energy": Q("J", "work against the attraction to open the gap", "J"),
    "friction_work": Q(
        "J", "work of friction since the start", "µJ", "friction work", "friction\nwork"
    ),
    "work_put_in": Q("J", "work of the increments that did some, since the start"),
    "net_work": Q("J", "the same less what the others gave back", "", "net work"),
    "elastic_energy": Q("J", "of tractions after the last increment", "", "elastic, of tractions"),
    "residual_energy": Q(
        "J", "of the residual stress of both bodies after the last increment", "",
        "elastic, of residual stress",
    ),
    "plastic_work": Q(
        "J", "turned into heat by plastic flow of both bodies since the start", "", "plastic flow"
    ),
    "sticking_share": Q(
        "1", "share of the cells in contact that stick in the increment", "%",
        "share of the contact that sticks", "sticks", 4,
    ),
    "max_pressure": Q("Pa", "maximum pressure", "MPa", "maximum pressure", "p_max"),
    "contact_area": Q("m2", "contact area", "mm²", "contact area", "contact area"),
    "max_von_mises": Q(
        "Pa", "maximum von Mises stress", "MPa", "maximum von Mises stress", "von Mises"
    ),
    "max_equivalent_plastic_strain": Q(
        "1", "maximum equivalent plastic strain", "%", "maximum equivalent plastic strain",
        "plastic\nstrain", 4,
    ),
    "max_residual_von_mises": Q(
        "Pa", "maximum von Mises stress of the residual stress", "MPa",
        "maximum residual von Mises stress", "residual\nvon Mises",
    ),
    "print_depth": Q(
        "m", "deepest point of the print within the grid", "µm", "print depth in the grid", "print"
    ),
    "max_temperature": Q(
        "K", "maximum rise of temperature", "K", "maximum rise of temperature", "heating"
    ),
    "travel": Q(
        "m", "way of the surface of body {body} through the contact, towards +x", "µm", "travel",
        "travel", 6,
    ),
    "contact_origin": Q("m", "place of the contact's x = 0 in the grid"),
    "offset": Q("m", "place of volume fields of body {body} past the cells of the grid, along x"),
    "time": Q("s", "time since the start", "s", "time"),
    "heat_factor": Q("m/s", "heat flux into body 1 and 2 over pressure"),
    # how it was solved
    "iterations": Q("1", "plastic iterations", "", "plastic iterations", "iter.", 6),
    "contact_iterations": Q("1", "contact iterations", "", "contact iterations"),
    "substeps": Q("1", "steps the increment was split into", "", "substeps"),
    "contact_margin": Q(
        "1", "cells between contact and border, least", "cells", "contact to border"
    ),
    "contact_cells": Q(
        "1", "cells across the spot under the largest pressure", "cells", "across the contact"
    ),
    "sharp_cells": Q(
        "1", "cells in contact at sharp edges, where the pressure is singular", "", "at sharp edges"
    ),
    "area_uncertainty": Q("1", "contact area, relative uncertainty", "%", "area uncertain"),
    "plastic_residual": Q(
        "1", "relative change of the plastic strain when accepted", "", "plastic residual"
    ),
    "yield_excess": Q(
        "1", "(von Mises stress - yield stress)/yield stress when accepted, largest", "",
        "yield excess",
    ),
    "max_plastic_strain_magnitude": Q(
        "1", "maximum plastic strain magnitude sqrt(2/3 e:e), non-cumulative"
    ),
    "plastic_margin": Q(
        "1", "cells between plastic strain and border of the volume, least", "cells",
        "plastic zone to border",
    ),
    "plastic_layers": Q(
        "1", "layers from top to bottom of the plastic zone", "layers", "plastic zone"
    ),
    # of the surface
    "pressure": Q("Pa", "contact pressure", "GPa", "pressure", kind="magnitude"),
    "repulsion": Q("Pa", "contact pressure beside the attraction", "GPa", "repulsion"),
    "gap": Q("m", "gap under load", "µm", "gap", kind="length"),
    "shear_x": Q("Pa", "shear along +x on body 2", "MPa", "shear along x", kind="signed"),
    "shear_y": Q("Pa", "shear along +y on body 2", "MPa", "shear along y", kind="signed"),
    "slip_x": Q("m", "slip of body 1 over body 2 in the increment, along +x"),
    "slip_y": Q("m", "slip of body 1 over body 2 in the increment, along +y"),
    "sticking": Q("1", "whether a cell in contact sticks in the increment"),
    "residual_displacement": Q(
        "m", "normal surface displacement by plastic strain, body {body}, into the body", "µm",
        "residual displacement", kind="signed",
    ),
    "initial_gap": Q("m", "gap of the unloaded bodies"),
    "surface_temperature": Q(
        "K", "rise of temperature of the surface", "K", "rise of temperature", kind="heat"
    ),
    # of the volume
    "stress": Q("Pa", "stress, positive in tension", "MPa", "stress", kind="signed"),
    "von_mises": Q("Pa", "von Mises stress", "MPa", "von Mises stress", kind="magnitude"),
    "hydrostatic": Q("Pa", "mean normal stress", "MPa", "hydrostatic stress", kind="signed"),
    "equivalent_plastic_strain": Q(
        "1", "equivalent plastic strain", "%", "equivalent plastic strain", kind="strain"
    ),
    "plastic_strain": Q("1", "plastic strain tensor", "%", "plastic strain", kind="signed"),
    "residual_stress": Q(
        "Pa", "stress without tractions and heat", "MPa", "residual stress", kind="signed"
    ),
    "residual_von_mises": Q(
        "Pa", "von Mises stress without tractions and heat", "MPa", "residual von Mises stress",
        kind="magnitude",
    ),
    "residual_hydrostatic": Q(
        "Pa", "mean normal stress without tractions and heat", "MPa",
        "residual hydrostatic stress", kind="signed",
    ),
    "temperature": Q(
        "K", "rise of temperature", "K", "rise of temperature", kind="heat"
    ),
    # of interfaces between layers
    "interface": Q("m", "depths of the interfaces between layers"),
    "interface_stress": Q("Pa", "stress above and below the interfaces, positive in tension"),
}  # fmt: skip

TRACK = {
    "x": Q("m", "cell centres along x on body {body}, 0 where the contact stood at the start"),
    "residual_displacement": Q(
        "m", f"normal surface displacement by plastic strain, into the body, {_TRACK}"
    ),
    "residual_stress": Q("Pa", f"residual stress {_TRACK}"),
    "residual_von_mises": Q("Pa", f"von Mises stress {_TRACK}"),
    "residual_hydrostatic": Q("Pa", f"mean normal stress {_TRACK}"),
    "plastic_strain": Q("1", f"plastic strain tensor {_TRACK}"),
    "equivalent_plastic_strain": Q("1", f"equivalent plastic strain {_TRACK}"),
}

TUGGING = {
    # of each increment
    "offset": Q("m", "horizontal distance of the centres"),
    "angle": Q("rad", "of the line of centres from the vertical"),
    "approach": Q("m", "along the line of centres"),
    "normal_force": Q("N", "along the line of centres"),
    "force_x": Q(
        "N", "of sphere 1 on sphere 2 along X; what it takes to move sphere 1 along +X", "N",
        "tangential force", "F_x",
    ),
    "force_y": Q("N", "of sphere 1 on sphere 2 along Y"),
    "force_z": Q("N", "of sphere 1 on sphere 2 downwards", "N", "normal force", "F_z"),
    "load_ratio": Q("1", "force_x over force_z"),
    "work": Q("J", "of force_x since the start of the pass"),
    "plastic_work": Q("J", "of both bodies since the start of the first pass"),
    "max_pressure": CONTACT["max_pressure"]._replace(long_name="largest pressure"),
    "contact_area": CONTACT["contact_area"],
    "max_equivalent_plastic_strain": Q("1", "largest equivalent plastic strain of a body"),
    "contact_cells": CONTACT["contact_cells"],
    "plastic_layers": CONTACT["plastic_layers"]._replace(
        long_name="layers from top to bottom of the plastic zone of a body"
    ),
    # of each pass
    "pass": Q("1", "number of the pass"),
    "net_energy": Q("J", "work of force_x over the pass", "J", "net energy", "net energy"),
    "dissipation": Q(
        "J", "plastic work of the pass in both bodies", "J", "plastic work", "dissipated"
    ),
    "residual_energy": Q(
        "J", "elastic energy of the residual stress of both bodies after the pass", "J",
        "energy of the residual stress", "stored",
    ),
    "energy_imbalance": Q(
        "J", "net energy not found as dissipation or more residual energy", "J",
        "not found of the net energy",
    ),
    "residual_displacement": Q(
        "m", "largest depth of the print of a body after the pass", "µm", "largest print", "print"
    ),
    "max_force_x": Q(
        "N", "largest force_x of the pass", "N", "largest tangential force", "F_x max"
    ),
    "min_force_x": Q("N", "least force_x of the pass", "N", "least tangential force", "F_x min"),
    "max_force_z": Q("N", "largest force_z of the pass", "N", "largest normal force", "F_z max"),
}  # fmt: skip

WEAR = {
    "cycle": Q("1", "number of the cycle"),
    "body": Q("1", "worn body"),
    "state": Q("1", "cycles that were worn"),
    "y": CONTACT["y"],
    # of each cycle and body
    "volume": Q("m3", "volume of the removed material", "µm³", "removed volume", "worn"),
    "lost": Q("m3", "volume lost by the surface"),
    "depth": Q("m", "largest wear depth of the cycle", "µm", "wear depth", "depth"),
    "surface_strain": Q(
        "1", "largest plastic strain of the first layer before removal", "%",
        "plastic strain of the first layer",
    ),
    "max_equivalent_plastic_strain": Q(
        "1", "largest equivalent plastic strain before removal", "%", "largest plastic strain",
        "plastic\nstrain",
    ),
    "plastic_layers": CONTACT["plastic_layers"]._replace(
        long_name="layers from top to bottom of the plastic zone before removal"
    ),
    # of each cycle
    "parts": Q("1", "parts into which the repeats of the cycle were divided"),
    "friction_work": Q("J", "work of friction in the cycle", "J", "friction work"),
    "slip_path": Q(
        "m", "longest way of slip in one repeat", "µm", "longest way of slip", "way of slip"
    ),
    "sticking_area": Q(
        "m2", "area that touches and sticks in a whole repeat", "µm²", "sticking area",
        "sticking\narea",
    ),
    "max_pressure": CONTACT["max_pressure"]._replace(long_name="largest pressure"),
    "max_von_mises": CONTACT["max_von_mises"]._replace(
        long_name="largest von Mises stress under load"
    ),
    "contact_area": CONTACT["contact_area"]._replace(
        long_name="area under pressure at the largest load", shown="µm²"
    ),
    "contact_cells": CONTACT["contact_cells"],
    "wear_rate": Q("m3", "worn volume per cycle", "µm³", "worn volume per cycle"),
    "worn_volume": Q("m3", "worn volume so far"),
    "x": Q("m", "positions on body {body}"),
    "heights": Q("m", "heights of body {body}, outwards", "µm", "height", kind="height"),
}  # fmt: skip


def described(name: str) -> tuple[Quantity, int | None]:
    """The quantity of a name in files, and its body; None where it is of both."""
    kind, _, body = name.partition("_body")
    return CONTACT[kind], int(body) if body else None
