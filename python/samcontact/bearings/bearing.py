# SPDX-License-Identifier: GPL-3.0-or-later
"""A bearing row: geometry of its contacts, load distribution, static rating."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import KW_ONLY, dataclass
from typing import Any

import numpy as np

from .. import hertz, surfaces
from .._util.checks import FloatArray, choice, finite, integer, non_negative, positive
from .._util.lazy_scipy import scipy
from .equilibrium import SLICES, ElementLoads, balls_in_equilibrium, rollers_in_equilibrium
from .loads import stribeck_load
from .races import MAX_DIAMETER, RaceContact, angle_of, ball_on_race, roller_on_race
from .rating import STEEL_CONTACT_MODULUS, static_load_rating

KINDS = ("deep_groove", "angular_contact", "cylindrical_roller")
RACES = ("inner", "outer")
_PRESSURE = {"cylindrical_roller": 4.0e9}
"""Hertz pressure at the static load rating of ISO 76 [Pa], for kinds where it is not 4.2e9."""
_AXIAL_FACTORS = ((15, 20, 25, 30, 35, 40, 45), (0.46, 0.42, 0.38, 0.33, 0.29, 0.26, 0.22))
"""Factor Y_0 of ISO 76 for single-row angular contact bearings by contact angle [degrees]."""


@dataclass(frozen=True)
class Bearing:
    """A rolling bearing with one row, or with several equal rows.

    Parameters
    ----------
    kind : {"deep_groove", "angular_contact", "cylindrical_roller"}
        Type of the bearing.
    element_diameter, pitch_diameter : float
        Diameter of a ball or roller, and of the circle through their centres [m].
    elements : int
        Number of balls or rollers, >= 2.
    contact_angle : float, optional
        Contact angle without load [rad]: > 0 for angular contact bearings, 0 for other bearings.
    inner_conformity, outer_conformity : float, optional
        For balls only: groove radius divided by ball diameter, > 0.5 [-]. Default: 0.52 and 0.53,
        the values of ISO 76.
    length : float, optional
        For rollers only, required: effective length, without corner radii [m].
    profile : str, optional
        For rollers only: "straight" or "logarithmic" (default), as in `surfaces.roller`.
    clearance : float, optional
        Diametral clearance of the mounted bearing [m], >= 0. Default: None, unknown.
    rows : int, optional
        Number of rows, which share the load equally.
    source : str, optional
        Origin of the dimensions.

    Raises
    ------
    ValueError
        An argument is outside its range or does not belong to the kind.

    Notes
    -----
    If the clearance is unknown and the load is purely radial, the maximum element load follows from
    Stribeck's rule, 5 F/(Z cos(alpha)), as in ISO 76. Otherwise the equilibrium of the inner ring
    is solved (`element_loads`); for an unknown clearance see `max_element_load`.
    """

    kind: str
    element_diameter: float
    pitch_diameter: float
    elements: int
    _: KW_ONLY
    contact_angle: float = 0.0
    inner_conformity: float | None = None
    outer_conformity: float | None = None
    length: float | None = None
    profile: str | None = None
    clearance: float | None = None
    rows: int = 1
    source: str = ""

    def __post_init__(self) -> None:
        choice("kind", self.kind, KINDS)
        given: dict[str, Any] = {
            "element_diameter": positive("element_diameter", self.element_diameter),
            "pitch_diameter": positive("pitch_diameter", self.pitch_diameter),
            "elements": integer("elements", self.elements, 2),
            "rows": integer("rows", self.rows, 1),
            "contact_angle": angle_of(self.contact_angle),
        }
        if self.clearance is not None:
            given["clearance"] = non_negative("clearance", self.clearance)
        for_balls = {"inner_conformity": 0.52, "outer_conformity": 0.53}
        for_rollers = {"length": None, "profile": "logarithmic"}
        used, unused = (for_rollers, for_balls) if self.has_rollers else (for_balls, for_rollers)
        for name in unused:
            if getattr(self, name) is not None:
                raise ValueError(f'{name} does not apply to kind = "{self.kind}": omit it')
        for name, default in used.items():
            given[name] = default if getattr(self, name) is None else getattr(self, name)
        for name in () if self.has_rollers else for_balls:
            if not positive(name, given[name]) > 0.5:
                raise ValueError(
                    f"{name} must be > 0.5, got {given[name]!r}: the groove must be wider than the "
                    "ball"
                )
        if self.has_rollers:
            if self.length is None:
                raise ValueError("length is required for rollers: give their effective length [m]")
            given["length"] = positive("length", self.length)
            choice("profile", given["profile"], ("straight", "logarithmic"))
        for name, value in given.items():
            object.__setattr__(self, name, value)
        self._require_consistent()

    def _require_consistent(self) -> None:
        if (self.contact_angle > 0.0) != (self.kind == "angular_contact"):
            raise ValueError(
                'contact_angle must be > 0 with kind = "angular_contact" and 0 otherwise, got '
                f'{self.contact_angle!r} rad with kind = "{self.kind}"'
            )
        if self.element_diameter > MAX_DIAMETER:
            raise ValueError(
                f"element_diameter must be at most {MAX_DIAMETER:g} m, got "
                f"{self.element_diameter!r} m: millimetres instead of metres?"
            )
        width = self.element_diameter * math.cos(self.contact_angle)
        room = self.pitch_diameter * math.sin(math.pi / self.elements)
        if room < width * (1.0 - 1e-9) and self.elements > 2:
            raise ValueError(
                f"elements: {self.elements} elements of diameter {self.element_diameter!r} m do "
                f"not fit on a pitch diameter of {self.pitch_diameter!r} m"
            )
        for race in RACES:
            self.race(race)
        if self.clearance and self.kind == "angular_contact":
            raise ValueError(
                'clearance does not apply to kind = "angular_contact", whose contact angle '
                "includes its effect: omit it"
            )
        if self.clearance and self.clearance >= 0.1 * self.element_diameter:
            raise ValueError(
                "clearance must be < 0.1 times the element diameter, got "
                f"{self.clearance!r} m: use m, e.g. 10e-6"
            )

    @property
    def has_rollers(self) -> bool:
        """Whether the rolling elements are rollers."""
        return self.kind == "cylindrical_roller"

    def race(self, race: str) -> RaceContact:
        """Contact of an element with the "inner" or "outer" race."""
        D, pitch, angle = self.element_diameter, self.pitch_diameter, self.contact_angle
        if self.has_rollers:
            return roller_on_race(D, pitch, race=race)
        choice("race", race, RACES)
        f = self.inner_conformity if race == "inner" else self.outer_conformity
        return ball_on_race(D, pitch, conformity=f, contact_angle=angle, race=race)

    def gap(self, race: str, tilt: float = 0.0) -> Callable[[surfaces.SurfaceGrid], FloatArray]:
        """Return a function that gives the gap between an element and a race on a grid.

        tilt: tilt of a roller relative to the race [rad]; 0 for balls.
        """
        contact, angle = self.race(race), finite("tilt", tilt)
        if not self.has_rollers:
            if angle != 0.0:
                raise ValueError(f"tilt must be 0 for balls, got {angle!r}")
            return lambda grid: surfaces.paraboloid(grid, contact.Rx, contact.Ry)
        length, profile, kind = float(self.length or 0.0), self.profile, {}
        if profile == "logarithmic":
            kind = {"diameter": self.element_diameter}
        return lambda grid: surfaces.roller(
            grid, contact.Rx, length, str(profile), tilt=angle, **kind
        )

    def hertz(
        self, race: str, load: float, E_star: float = STEEL_CONTACT_MODULUS
    ) -> hertz.LineContact | hertz.PointContact | hertz.EllipticContact:
        """Hertz contact of an element on a race at a contact load [N] > 0."""
        contact, load = self.race(race), positive("load", load)
        if self.has_rollers:
            return hertz.line(contact.Rx, E_star, load / float(self.length or math.nan))
        return hertz.elliptic(contact.Rx, contact.Ry, E_star, load=load)

    @property
    def governing_race(self) -> str:
        """Race with the higher Hertz pressure at equal load, "inner" or "outer"."""
        return max(RACES, key=lambda race: self.hertz(race, 1.0).p0)

    def element_loads(
        self,
        radial_load: float = 0.0,
        axial_load: float = 0.0,
        moment: float | None = None,
        *,
        E_star: float = STEEL_CONTACT_MODULUS,
    ) -> ElementLoads:
        """Loads of all elements of a row, from the equilibrium of the inner ring.

        Parameters
        ----------
        radial_load, axial_load : float
            Loads on the bearing, >= 0 [N]. One element lies directly under the radial load.
        moment : float, optional
            Moment in the plane of the radial load [N m]. A positive moment moves the inner ring,
            at the element under the radial load, in the direction of the axial load. Default: None,
            the rings remain parallel. With 0, the inner ring is free to tilt.
        E_star : float, optional
            Contact modulus of balls and races [Pa]; not used for rollers, which are of steel.

        Returns
        -------
        ElementLoads

        Raises
        ------
        ValueError
            A load is out of range, all loads are 0, cylindrical rollers have an axial load, or
            there is no equilibrium.

        Notes
        -----
        The rings are rigid. An unknown clearance is taken as 0. Balls have the Hertz stiffness and
        contact angles that change under load (Harris, chapter 7). Rollers are divided into slices
        with the stiffness and the profile of ISO/TS 16281.
        """
        share = 1.0 / self.rows
        forces = share * np.array([
            non_negative("radial_load", radial_load), non_negative("axial_load", axial_load),
            0.0 if moment is None else finite("moment", moment),
        ])  # fmt: skip
        if not forces.any():
            raise ValueError("radial_load, axial_load or moment must differ from 0, got 0 for all")
        clearance, tilts = self.clearance or 0.0, moment is not None
        if self.has_rollers:
            length = float(self.length or 0.0)
            if forces[1] > 0.0:
                raise ValueError(
                    f"axial_load must be 0 for cylindrical rollers, got {axial_load!r} N"
                )
            y = length * ((np.arange(SLICES) + 0.5) / SLICES - 0.5)
            straight = self.profile == "straight"
            drop = 0.0 * y if straight else surfaces.iso_drop(y, length, self.element_diameter)
            return rollers_in_equilibrium(forces, self.elements, length, clearance, y, drop, tilts)
        D, f = self.element_diameter, (self.inner_conformity or 0.0, self.outer_conformity or 0.0)
        stiffness = sum(
            self._stiffness(race, positive("E_star", E_star)) ** (-2.0 / 3.0) for race in RACES
        ) ** -1.5  # fmt: skip
        arm = 0.5 * self.pitch_diameter + (f[0] - 0.5) * D * math.cos(self.contact_angle)
        loads = balls_in_equilibrium(
            forces, self.elements, stiffness, (f[0] + f[1] - 1.0) * D, self.contact_angle, arm,
            clearance, tilts,
        )  # fmt: skip
        held = loads.contact_angles[loads.loads > 0.0].min() > 0.5 * self.contact_angle
        if self.kind == "angular_contact" and not held:
            raise ValueError(
                "axial_load must exceed about radial_load tan(contact_angle), got "
                f"{axial_load!r} N: under a smaller axial load the rings of an angular contact row "
                "separate"
            )
        return loads

    def _stiffness(self, race: str, E_star: float) -> float:
        """Return load/approach^1.5 of a ball on a race [N/m^1.5]."""
        contact = self.race(race)
        ellipse = hertz.elliptic(contact.Rx, contact.Ry, E_star, load=1.0)
        return float(1.0 / ellipse.approach**1.5)

    def max_element_load(
        self,
        radial_load: float = 0.0,
        axial_load: float = 0.0,
        moment: float | None = None,
        *,
        E_star: float = STEEL_CONTACT_MODULUS,
    ) -> float:
        """Load of the most heavily loaded element [N]; arguments as for `element_loads`.

        If the clearance is known, this is the maximum of `element_loads`. If it is unknown, the
        result depends on the loads. For a purely radial load, the result is the load by Stribeck's
        rule, which assumes a usual clearance. For any other loads, it is the larger of two values:
        the load by Stribeck's rule and the maximum of `element_loads`.
        """
        least = 0.0
        if self.clearance is None:
            least = stribeck_load(radial_load, self.elements, self.contact_angle) / self.rows
            if axial_load == 0.0 and moment is None:
                return least
        return max(
            least, self.element_loads(radial_load, axial_load, moment, E_star=E_star).max_load
        )

    def load_factor(
        self,
        element_load: float,
        radial_load: float = 0.0,
        axial_load: float = 0.0,
        moment: float | None = None,
    ) -> float:
        """Factor by which all loads are multiplied to reach the element load `element_load` [-].

        element_load: load [N], > 0. Other arguments as for `max_element_load`.
        """
        target = positive("element_load", element_load)
        loads = (
            non_negative("radial_load", radial_load), non_negative("axial_load", axial_load),
            None if moment is None else finite("moment", moment),
        )  # fmt: skip

        def excess(log_factor: float) -> float:
            factor = math.exp(log_factor)
            turned = None if loads[2] is None else factor * loads[2]
            found = self.max_element_load(factor * loads[0], factor * loads[1], turned)
            if found == 0.0:
                raise ValueError(
                    "radial_load, axial_load or moment must load an element, got no loaded element"
                )
            return math.log(found / target)

        low = high = -excess(0.0)
        while excess(low) > 0.0:  # the contact angle and the load zone change with the load
            low -= 1.0
        while excess(high) < 0.0:
            high += 1.0
        return math.exp(
            low if low == high else scipy.optimize.brentq(excess, low, high, xtol=1e-10)
        )

    @property
    def static_load_rating(self) -> float:
        """Basic static radial load rating C_0r of ISO 76 [N]."""
        races = [self.race(race) for race in RACES]
        return static_load_rating(
            races, self.elements, self.contact_angle, length=self.length, rows=self.rows,
            pressure=_PRESSURE.get(self.kind, 4.2e9),
        )  # fmt: skip

    def static_equivalent_load(self, radial_load: float, axial_load: float = 0.0) -> float:
        """Static equivalent radial load P_0r of ISO 76 [N], max(X_0 F_r + Y_0 F_a, F_r).

        Deep groove bearings have X_0 = 0.6 and Y_0 = 0.5. Single-row angular contact bearings have
        X_0 = 0.5 and a factor Y_0 that depends on the contact angle. Cylindrical rollers carry no
        axial load.
        """
        radial, axial = non_negative("radial_load", radial_load), non_negative(
            "axial_load", axial_load
        )  # fmt: skip
        if self.has_rollers and axial > 0.0:
            raise ValueError(f"axial_load must be 0 for cylindrical rollers, got {axial!r} N")
        x, y = 0.6, 0.5
        if self.kind == "angular_contact":
            x, y = 0.5, float(np.interp(math.degrees(self.contact_angle), *_AXIAL_FACTORS))
        return max(x * radial + y * axial, radial)

    def static_safety(self, radial_load: float, axial_load: float = 0.0) -> float:
        """Static safety factor s_0 = C_0r/P_0r of ISO 76 [-]."""
        return self.static_load_rating / positive(
            "radial_load and axial_load", self.static_equivalent_load(radial_load, axial_load)
        )
