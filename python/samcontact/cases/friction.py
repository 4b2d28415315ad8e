# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction in a case file: a constant coefficient with full sliding, or a friction law."""

from __future__ import annotations

from dataclasses import MISSING, fields
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Discriminator, Tag, create_model, model_validator

from ..problem.friction import LAWS, FrictionLaw, law_of
from .base import NonNegative, Section
from .solids import field_of


class _FrictionLaw(Section):
    """Section with a field for each law of partial slip; exactly one field must be given."""

    @model_validator(mode="after")
    def _one_law(self) -> _FrictionLaw:
        names = type(self).model_fields
        given = [name for name in names if getattr(self, name) is not None]
        if len(given) != 1:
            raise ValueError(
                f"exactly one of {', '.join(names)} must be given, got {', '.join(given) or 'none'}"
            )
        return self

    def build(self) -> FrictionLaw:
        """Create the friction law from the coefficient or the table of constants."""
        ((name, given),) = self.model_dump(exclude_none=True).items()
        parameters = given if isinstance(given, dict) else {next(iter(LAWS[name].constants)): given}
        return law_of({"law": name, **parameters})


def default_of(law: type[FrictionLaw], name: str) -> Any:
    """Return the default of a parameter of a law; `...` if it has none."""
    (given,) = (item.default for item in fields(law) if item.name == name)
    return ... if given is MISSING else list(given) if isinstance(given, tuple) else given


def _friction_section() -> Any:
    """Create a section with a field per law: a number for laws of one constant, else a table."""
    laws: dict[str, Any] = {}
    for name, law in LAWS.items():
        if not law.sticks:
            continue
        values = {n: field_of(constant) for n, constant in law.constants.items()}
        annotation = next(iter(values.values()))
        if len(values) > 1:
            parameters: dict[str, Any] = {
                n: (field, default_of(law, n)) for n, field in values.items()
            }
            annotation = create_model(
                f"{law.__name__}Parameters",
                __base__=Section,
                __doc__=f"Parameters of `{law.__name__}`.",
                __module__=__name__,
                **parameters,
            )
            globals()[annotation.__name__] = annotation  # for pickling
        laws[name] = (annotation | None, None)
    docstring = _FrictionLaw.__doc__
    return create_model(
        "FrictionSection", __base__=_FrictionLaw, __doc__=docstring, __module__=__name__, **laws
    )


if TYPE_CHECKING:
    FrictionSection = _FrictionLaw
else:
    FrictionSection = _friction_section()


def _kind_of_friction(given: Any) -> str:
    return "law" if isinstance(given, (dict, FrictionSection)) else "number"


FrictionField = Annotated[
    Annotated[NonNegative, Tag("number")] | Annotated[FrictionSection, Tag("law")],
    Discriminator(_kind_of_friction),
]


def friction_of(given: float | FrictionSection) -> float | FrictionLaw:
    """Return the argument `friction` of `Simulation`: a number or a friction law."""
    return given.build() if isinstance(given, FrictionSection) else given
