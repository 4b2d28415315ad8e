# SPDX-License-Identifier: GPL-3.0-or-later
"""Entry of the library of materials: constants with their sources."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from .._util.display import HtmlTable, Rows, quantity
from .._util.short_text import in_short
from ..bodies.hardening_laws import LAWS
from ..bodies.material import Material

__all__ = ["UNITS", "MaterialData", "SourcedValue"]

UNITS = {
    "E": "Pa",
    "nu": "",
    "density": "kg/m^3",
    "conductivity": "W/(m K)",
    "expansion": "1/K",
    "specific_heat": "J/(kg K)",
    "diffusivity": "m^2/s",
    "yield_stress": "Pa",
    "B": "Pa",
    "C": "microstrain",
    "n": "",
}
"""SI unit of each constant; microstrain is the unit of the constant C of Swift's law."""

_THERMAL = ("conductivity", "expansion", "diffusivity")


@dataclass(frozen=True)
class SourcedValue:
    """Value of a constant with its source.

    Attributes
    ----------
    value : float
        Value in the SI unit `unit`.
    unit : str
        SI unit; "" for a pure number.
    source : str
        Standard, handbook, data sheet or paper.
    condition : str
        State of the material, temperature, or how the value follows from the source; may be "".
    """

    value: float
    unit: str
    source: str
    condition: str = ""

    def __str__(self) -> str:
        if self.unit == "1/K":
            return f"{self.value * 1e6:.4g}e-6 1/K"
        if self.unit == "m^2/s":
            return f"{self.value * 1e6:.4g} mm²/s"
        if self.unit == "Pa":
            return quantity(self.value, "Pa")
        return f"{self.value:.4g} {self.unit.replace('^3', '³')}".strip()


@dataclass(frozen=True, repr=False)
class MaterialData(HtmlTable):
    """Constants of a material with their sources, from `samcontact.materials.get`.

    Attributes
    ----------
    name : str
        Name in the library, e.g. "52100".
    description : str
        Kind of material and other designations.
    values : mapping of str to SourcedValue
        Known constants by name. Constants without a known source are absent.
    aliases : tuple of str
        Other names that `get` accepts.
    """

    name: str
    description: str
    values: Mapping[str, SourcedValue]
    aliases: tuple[str, ...] = ()

    def value(self, constant: str) -> float:
        """Return a constant in its SI unit, e.g. ``value("conductivity")``.

        Raises ValueError if the library has no such constant for this material.
        """
        return self._known(constant).value

    def source(self, constant: str) -> str:
        """Return the source of a constant; raises ValueError if the constant is unknown."""
        return self._known(constant).source

    def _known(self, constant: str) -> SourcedValue:
        if isinstance(constant, str) and constant in self.values:
            return self.values[constant]
        raise ValueError(
            f"constant of {self.name} must be one of {', '.join(self.values)}, got "
            f"{in_short(constant)}: other constants of this material are not in the library, "
            "because no source is known for them"
        )

    @property
    def laws(self) -> tuple[str, ...]:
        """Names of the laws whose constants are all known; valid arguments of `material`."""
        return tuple(
            name
            for name, law in LAWS.items()
            if law.constants and law.constants.keys() <= self.values.keys()
        )

    @property
    def thermal(self) -> tuple[float, float, float] | None:
        """Conductivity, expansion and diffusivity; None unless all of them are known.

        These are the arguments of `Material.with_thermal`.
        """
        if not set(_THERMAL) <= set(self.values):
            return None
        conductivity, expansion, diffusivity = (self.values[name].value for name in _THERMAL)
        return conductivity, expansion, diffusivity

    def constants(self, law: str) -> dict[str, float]:
        """Return the known constants of a law, e.g. "swift": {"E": ..., "nu": ..., "B": ...}.

        Raises ValueError if the law is unknown or is "rigid".
        """
        if not isinstance(law, str) or law not in LAWS or not LAWS[law].constants:
            deformable = ", ".join(name for name, one in LAWS.items() if one.constants)
            raise ValueError(f"law must be one of {deformable}, got {in_short(law)}")
        return {
            name: self.values[name].value for name in LAWS[law].constants if name in self.values
        }

    def material(self, law: str = "elastic") -> Material:
        """Return the material for a contact, with thermal constants if all of them are known.

        Parameters
        ----------
        law : str, optional
            Name of the law, one of `laws`.

        Returns
        -------
        Material

        Raises
        ------
        ValueError
            The law is unknown, or the library does not have all of its constants.
        """
        constants = self.constants(law)
        missing = [name for name in LAWS[law].constants if name not in constants]
        if missing:
            allowed = f"be one of {', '.join(self.laws)}" if self.laws else "have known constants"
            raise ValueError(
                f"law must {allowed} for {self.name}, got {law!r}: the library has no value of "
                f"{', '.join(missing)} for this material; use Material.{law} with your own values, "
                "or Material.from_test with a measured curve"
            )
        made = Material(law, constants)
        return made if self.thermal is None else made.with_thermal(*self.thermal)

    def _rows(self) -> Rows:
        rows = [("name", self.name), ("description", self.description)]
        for name, known in self.values.items():
            note = f"; {known.condition}" if known.condition else ""
            rows.append((name, f"{known} ({known.source}{note})"))
        return rows

    def __repr__(self) -> str:
        return f"MaterialData({self.name!r})"
