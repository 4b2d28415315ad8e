# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction laws that depend on direction, place, temperature or slip rate; third-body layer."""

from __future__ import annotations

from dataclasses import dataclass

from .friction import FrictionLaw

__all__ = ["Anisotropic", "FallingCoulomb", "MappedCoulomb", "ThermalCoulomb", "ThirdBody"]


@dataclass(frozen=True)
class Anisotropic(FrictionLaw):
    """Friction with different coefficients in two perpendicular directions of the surface.

    The shear traction s lies within an ellipse with the half-axes mu_x p and mu_y p. A cell whose
    shear is on the ellipse slips along the normal of the ellipse (associated flow), which gives the
    maximum frictional dissipation. Equal coefficients give Coulomb friction.

    Attributes
    ----------
    mu_x, mu_y : float
        Coefficients of friction along the two axes of the ellipse [-], > 0.
    angle : float
        Angle from the x axis of the grid to the axis with mu_x, about z [rad], in [-pi, pi]. The
        axes do not turn with the bodies.

    Raises
    ------
    ValueError, TypeError
        A coefficient is not positive and finite, or the angle is out of range.

    Notes
    -----
    A. Michalowski and Z. Mroz (1978), Arch. Mech. 30, 259; the page on friction describes the
    change of coordinates that turns the ellipse into a circle.
    """

    mu_x: float
    mu_y: float
    angle: float = 0.0


@dataclass(frozen=True, repr=False)
class MappedCoulomb(FrictionLaw):
    """Coulomb friction with a coefficient that varies over the surface of a body.

    The coefficient is bilinear between the points (x, y) and constant beyond them. In a simulation,
    the points move with the body. In steady rolling, the coefficient may vary along y only.

    Attributes
    ----------
    coefficient : sequence of float
        Coefficients of friction at the points [-], >= 0: one for each x or y, or a table with one
        row for each x (stored row after row).
    x, y : sequence of float, optional
        Increasing positions of the points from the centre of the grid [m]; empty: no variation
        along this axis.
    body : {1, 2}, optional
        Body with which the points move.

    Raises
    ------
    ValueError, TypeError
        A coefficient is negative or infinite, positions do not increase, or the numbers of
        coefficients and points differ.
    """

    coefficient: tuple[float, ...]
    x: tuple[float, ...] = ()
    y: tuple[float, ...] = ()
    body: int = 2

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "body", int(self.body))

    @property
    def varies_along_x(self) -> bool:
        """Whether the friction varies along x over a body, and thus moves with the body."""
        return len(self.x) > 1


@dataclass(frozen=True, repr=False)
class ThermalCoulomb(FrictionLaw):
    """Coulomb friction with a coefficient that depends on the temperature of the surfaces.

    The law requires a `Simulation` with `Heat(partition=...)`. The coefficient is interpolated
    linearly between the given temperatures and is constant beyond them. It is evaluated at the
    temperature of the hotter surface at the end of the increment.

    Attributes
    ----------
    temperature : sequence of float
        Increasing temperatures of the surfaces [K]; with the default of `bulk`, these are rises
        above the temperature of the unheated bodies.
    coefficient : sequence of float
        Coefficients of friction at these temperatures [-], >= 0.
    bulk : float, optional
        Temperature of the contact without frictional heat [K], on the scale of `temperature`; the
        rise due to frictional heat is added to it. If bodies with the bulk temperatures T1 and T2
        and the thermal effusivities e1 and e2 touch, it is (e1 T1 + e2 T2)/(e1 + e2). Default: 0.

    Raises
    ------
    ValueError, TypeError
        The temperatures do not increase, a coefficient is negative or infinite, or their numbers
        differ.
    """

    temperature: tuple[float, ...]
    coefficient: tuple[float, ...]
    bulk: float = 0.0

    @property
    def needs_temperature(self) -> bool:
        """Whether the shear depends on the temperature of the surfaces."""
        return True


@dataclass(frozen=True)
class FallingCoulomb(FrictionLaw):
    """Coulomb friction with a coefficient that falls as the slip rate v increases.

    mu = kinetic + drop 2^(-v/half_speed). Increments need a duration, and steady rolling a speed.
    In a short increment, a cell may be in equilibrium both with and without slip; such an increment
    is rejected unless the law has a memory. With a memory d, v is a weighted mean of the past slip
    rates of a material point; the weights decrease by a factor of e over a slip distance d.

    Attributes
    ----------
    kinetic : float
        Coefficient of friction at high slip rates [-], >= 0.
    drop : float
        Difference between the coefficients without slip and at high slip rates [-], >= 0.
    half_speed : float
        Slip rate at which half of the drop remains [m/s], > 0.
    memory : float, optional
        Slip distance d over which slip rates are averaged [m]; 0: no averaging.

    Raises
    ------
    ValueError, TypeError
        A parameter is negative, infinite or not a number, or half_speed is 0.

    Notes
    -----
    E. A. H. Vollebregt and H. M. Schuttelaars (2012), J. Sound Vib. 331, 2141.
    """

    kinetic: float
    drop: float
    half_speed: float
    memory: float = 0.0

    @property
    def needs_duration(self) -> bool:
        """Whether the shear depends on the slip rate, so that increments need a duration."""
        return self.drop > 0


@dataclass(frozen=True)
class ThirdBody(FrictionLaw):
    """Elastic layer between the bodies, such as wear particles or sand, that yields in shear.

    Below its strength, the layer adds thickness/shear_modulus times the shear traction to the
    relative tangential displacement of each cell. The shear traction is at most min(mu p,
    strength); at this limit the layer flows or slips, which counts as slip. The layer has no normal
    compliance. With hardening k, the strength in a cell is strength + k s, but at least 0, where s
    is the plastic slip that the layer has accumulated in this cell; slip at the limit mu p is not
    plastic. If the layer hardens, a prescribed tangential force may exceed the strength that it had
    before the increment. If it does not harden, prescribe a shift to make the whole layer flow.

    Attributes
    ----------
    coefficient : float
        Coefficient of friction mu [-], >= 0 and finite.
    strength : float
        Shear strength of the layer [Pa], >= 0. `math.inf` gives a layer that does not yield.
    shear_modulus : float
        Shear modulus of the layer [Pa], > 0.
    thickness : float
        Thickness of the layer [m], >= 0, much smaller than the contact.
    hardening : float, optional
        Change of the strength per plastic slip [Pa/m]; negative: softening. The solver raises
        an error if the layer softens faster than 1/C, where C is the displacement of a cell under
        its own unit shear.

    Raises
    ------
    ValueError, TypeError
        A parameter is out of its range or not a number, or a layer with infinite strength has a
        hardening.

    Notes
    -----
    K. Hou, J. Kalousek and E. Magel (1997), Wear 211, 134; the third-body layer of CONTACT.
    """

    coefficient: float
    strength: float
    shear_modulus: float
    thickness: float
    hardening: float = 0.0

    @property
    def hardens(self) -> bool:
        """Whether the strength depends on the plastic slip of the layer."""
        return self.hardening != 0

    @property
    def compliance(self) -> float:
        """Tangential displacement of the layer per unit shear [m/Pa]."""
        return self.thickness / self.shear_modulus
