# SPDX-License-Identifier: GPL-3.0-or-later
"""Each field of a case file changes the computation or is refused; none is ignored."""

import copy
import inspect
import re
from types import SimpleNamespace
from typing import Literal, get_args, get_origin

import numpy as np
import pytest
from pydantic import BaseModel

import samcontact as sc
from case_kinds import (
    ASPERITIES,
    BASE,
    COATED,
    COLD,
    CONTACT,
    DENT,
    DRAWN,
    GRID,
    HEAT,
    INCLUDED,
    KINDS,
    LAYER,
    ROLL,
    ROUGH,
    SWIFT,
    WEAR,
)
from samcontact import Simulation, wear
from samcontact.cases import (
    ALL_KINDS,
    AsperityCase,
    Case,
    CaseError,
    FilmCase,
    asperities,
    dents,
    fatigue,
    film_studies,
    kind_of,
    sliding,
)

# Fields that do not affect the computation: title, results folder, and output of the command.
OF_RESULTS = {"title", "description", "estimate_error", "output"}
# Fields without a grid to build, which are covered by tests of to_accuracy.
OF_ACCURACY = {"accuracy", "quantities", "max_memory", "max_time"}
# Alternative values if the field implies none; the first valid different value is used.
OTHER = {
    "lift": [[0.0, 1e-3, 3e-3, 1e-3, 0.0]], "lift_angle": [[-1.1, -0.5, 0.0, 0.5, 1.1]],
    "friction": [0.2], "low": [-18e-6], "high": [24e-6], "lateral_creepage": [2e-3], "spin": [1.0],
    "material": ["M50"], "HV": [[610.0, 450.0]], "surface": [620.0], "axis": ["y"],
    "law": [], "kind": [], "shape": [], "path": [], "worn": [[1, 2]], "unit": ["nm"],
    "channel": ["other"], "window": [[5, 5]], "start": [0.6, 2e-8], "velocity": [
        [[2.0, 0.0], [0.5, 0.0]], [-3.0, 0.0], [0.0, 1.0]],
    "heat_factor": [[1e-3, 4e-3], 0.5, [0.0, 4e-3]], "factor": [[1e-3, 4e-3], [0.0, 4e-3],
                                                                  [2.1, 1.4]],
    "z": [[0.0, 2e-5]], "sxx": [[-3e8, 0.0]], "syy": [[-1e8, 0.0]], "sxy": [[2e7, 0.0]],
    "history": [[1e-6, 2e-3]],
    "energy": [[2e-14, 1e-14], 3e-14], "archard": [2e-14],
    "advance": [[2e-5, 0.0]], "recovery": [[6.0]], "modulus": [[2e9]], "order": [2],
    "wavelength_min": [20e-6], "wavelength_max": [90e-6], "slide_to_roll": [-0.2],
    "step": [1e-5], "increments": [3, 13], "distance": [2e-5], "nz": [5], "ambient": [290.0],
    "density": [4e9],
    "teeth": [[16, 25]], "profile_shift": [[0.1, 0.1]], "tip_diameter": [[82.4e-3, 118.3e-3]],
    "tip_relief": [[3e-5, 2e-5]], "relief_length": [[6e-3, 5e-3]], "rail": ["other.npy"],
    "wheel": ["other.npy"], "smoothing": [0.0],
    "designation": ["6209"], "profile_y": [[0.0, 5e-5]], "profile_drop": [[0.0, 2e-8]],
    "times": [[1e-3, 0.2]], "shares": [[0.3, 0.1]],
    "axes": [[[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]],
    "radius_limits": [[24.9e-6, 3e-5]], "misfit": [2e-3], "fraction": [0.1, 0.3], "gap": [0.8],
    "cover": [2e-5], "members": [1.0, 9.0],
    "box": [[[-4e-5, 4e-5], [-4e-5, 4e-5], [0.0, 1.6e-4]]],
    "contact_x": [8e-5], "contact_y": [6e-5], "speed2": [[0.8, 0.2]], "speeds": [[0.02, 2.0]],
    "angle": [0.2], "roughness1": [3e-8], "roughness2": [4e-8], "grade": ["ISO VG 100"],
    "p": [[0.0, 6e8, 1e9]], "eta": [[0.03, 10.0, 1e3]],
    "rho": [[860.0, 970.0, 1000.0]],
    "velocities": [[0.1, 2.0]],
    "width": [1.4], "depth": [1.1], "plastic_strain": [[0.0, 2e-3]], "stress": [[1e9, 3e9]],
}  # fmt: skip
UNSET = {
    "material": "52100", "defect": 1e-5,
    "steady_axis": "x",
    "window": 3, "order": 1, "smoothing_length": 8e-6,
    "time": 1e-3, "reference": 0.5, "history": [1e-6, 1e-3], "speed": 2.0, "heat": HEAT,
    "track": 3e-5, "return_time": 2e-4,
    "duration": 1e-4, "back_and_forth": True, "unload_increments": 4, "increment_tol": 1e-2,
    "Ry": 3e-3, "advance": [1e-5, 0.0], "exponent": 3.0, "start": 1e-9, "reach": 1e-4,
    "heat_factor": 1e-3, "velocity": [1.0, 0.0], "wavelength_min": 15e-6, "wavelength_max": 60e-6,
    "roll_off": 40e-6, "roll": ROLL, "slide": {"distance": 1e-5, "step": 5e-6}, "increments": 12,
    "shift_x": 1e-8, "shift_y": 1e-8, "pull_off": {}, "twist": 1e-6, "tangential_load_x": 0.2,
    "tangential_load_y": 0.2, "torque": 1e-9, "moment_x": 1e-8, "moment_y": 1e-8, "tilt_x": 1e-6,
    "tilt_y": 1e-6, "fret": {"shift_x": 1e-8},
    "width": 1.7, "depth": 1.5, "approach": 1e-7, "load": 1.0, "image_tol": 1e-2, "floor": 0.2,
    "thermal": SWIFT["thermal"], "softening": SWIFT["softening"], "kinematic": SWIFT["kinematic"],
    "free_faces": {"low": -18e-6}, "relaxation": {"times": [1.0], "shares": [0.5]},
    "first_duration": 1e-5,
    "yield_profile": SWIFT["yield_profile"], "residual_stress": SWIFT["residual_stress"],
    "inclusions": [INCLUDED], "random_inclusions": DRAWN,
    "layers": [LAYER], "wear": WEAR, "relief1": DENT, "relief2": DENT, "roughness": ROUGH,
    "grid": GRID, "load_factor": 0.7, "centre_distance": 91.5e-3,
    "eccentricity": 3e-3, "max_lift": 5e-3, "event_angle": 2.2,
    "lift": [0.0, 1e-3, 2e-3, 1e-3, 0.0], "lift_angle": [-1.0, -0.5, 0.0, 0.5, 1.0],
    "eyring_stress": 5e6, "limiting_shear": 0.05, "supply": 1e-6, "boundary": {"thickness": 1e-9},
    "rho": [870.0, 950.0, 1000.0], "pressure": 1e9, "dz": 2e-5, "nz": 6,
}  # fmt: skip


def stated(value):
    if isinstance(value, np.ndarray):
        return value.tobytes()
    if hasattr(value, "heights"):
        return value.heights.tobytes(), value.first, value.periodic
    if isinstance(value, Simulation):
        return stated([repr(value), value.grid, value.initial_gap])
    if str(getattr(value, "__module__", "")).startswith("samcontact.cases.film_"):
        count = len(inspect.signature(value).parameters)
        given = np.meshgrid(np.linspace(-2e-4, 1e-4, 24), np.arange(24), indexing="ij")
        return stated(value(*given) if count == 2 else [value(t) for t in (0.0, 4e-5, 1e-4)])
    if isinstance(value, (list, tuple)):
        return [stated(item) for item in value]
    if isinstance(value, dict):
        return {name: stated(item) for name, item in value.items()}
    return repr(value)


@pytest.fixture
def computed(tmp_path, monkeypatch):
    """Return the arguments of the computation as text; arrays as bytes."""
    y = np.linspace(-30.0, 30.0, 61)
    for name, radius in (("rail", 300.0), ("wheel", 500.0), ("other", 600.0)):
        np.save(tmp_path / f"{name}.npy", np.column_stack([y, radius - np.sqrt(radius**2 - y**2)]))
    np.save(tmp_path / "h.npy", np.random.default_rng(5).standard_normal((24, 20)))
    seen = {}

    def record(*arguments, **named):
        seen["arguments"] = [*seen["arguments"], stated([list(arguments), named])]

    for name in ("cycle", "steady_cycle"):
        monkeypatch.setattr(fatigue, name, lambda states, *given, name=name: (name, *given))
    for name in fatigue.CRITERIA:
        monkeypatch.setattr(fatigue._criteria, name, lambda *seen, **given: repr((seen, given)))
    monkeypatch.setattr(wear, "run", record)
    monkeypatch.setattr(sc.shakedown, "run", lambda *given, **named: named)
    monkeypatch.setattr(wear, "fretting", record)
    monkeypatch.setattr(asperities, "collide", record)
    curve = SimpleNamespace(solutions=())
    monkeypatch.setattr(film_studies, "standing_on", lambda film, gap: gap)
    monkeypatch.setattr(film_studies, "press_loads", lambda *a, **n: record(*a, **n) or ())
    for name in ("stribeck", "transient"):
        monkeypatch.setattr(film_studies, name, lambda *a, **n: record(*a, **n) or curve)
    monkeypatch.setattr(film_studies, "steady", record)
    monkeypatch.setattr(sliding, "over_speed", record)
    monkeypatch.setattr(dents.Indentation, "__call__", lambda pressed, simulation: None)

    def compute(content):
        seen["arguments"] = []
        case = kind_of(content).model_validate(content)
        case._source = tmp_path / "case.toml"
        if isinstance(case, FilmCase):
            case.solve()
            return seen["arguments"], case.film.roughness
        if not isinstance(case, Case):
            case.solve(progress=False)
            return seen["arguments"]
        simulation, path = case.build()
        if case.wear is not None:
            case.wear.solve(simulation, path, None, False)
            return seen["arguments"]
        surfaces = (simulation.initial_gap, simulation.relief1, simulation.relief2)
        judged = []
        if case.fatigue is not None:
            judged = [case.fatigue.fields([simulation.state], 2), repr(case.fatigue)]
        if case.shakedown is not None:
            judged.append(case.shakedown.solve(simulation, path, False))
        pressed = repr(simulation.engine.preparation)
        return stated([list(surfaces), path, judged]), repr(simulation), pressed

    return compute


SURFACES = {"surface", "relief1", "relief2"}


def decisive(content, name):
    """Return what decides whether a section of a case has an effect, besides the surfaces.

    The bodies of a contact are built from their sections, the grid and the heat.
    """
    if name in SURFACES:
        return content
    if name in ("body1", "body2") and kind_of(content) is Case:
        used = {part: content.get(part) for part in ("body1", "body2", "grid", "heat")}
        return used, content.keys() - SURFACES
    return {part: value for part, value in content.items() if part not in SURFACES}


def untried():
    """Return the sections of each kind that are not tried in an earlier kind of the same code."""
    tried, sections = {}, {}
    for kind, content in KINDS.items():
        sections[kind] = set()
        for name in kind_of(content).model_fields.keys() - OF_RESULTS - OF_ACCURACY:
            equal = tried.setdefault(name, [])
            if (what := decisive(content, name)) not in equal:
                equal.append(what)
                sections[kind].add(name)
    return sections


TRIED = untried()


def leaves(model, place=(), sections=None):
    """Yield every field below a validated section that is no section, with its model."""
    for name, field in type(model).model_fields.items():
        if sections is not None and name not in sections:
            continue
        value = getattr(model, name)
        if isinstance(value, BaseModel):
            yield from leaves(value, (*place, name))
        elif isinstance(value, list) and value and isinstance(value[0], BaseModel):
            for index, part in enumerate(value):
                yield from leaves(part, (*place, name, index))
        else:
            yield (*place, name), field, value


def others(name, field, value):
    """Return values of a field that differ from its present one."""
    if value is None:
        return [UNSET[name]] if name in UNSET else []
    if name in OTHER:
        return OTHER[name]
    if isinstance(value, bool):
        return [not value]
    parts = (field.annotation, *get_args(field.annotation))
    literals = [one for part in parts if get_origin(part) is Literal for one in get_args(part)]
    if literals or isinstance(value, str):
        return [one for one in literals if one != value]
    if isinstance(value, int):
        return [value + 1, value + 2]
    if isinstance(value, list):
        return [[1.01 * item for item in value]]
    return [value * 1.01, value * 0.9]


def outcome(computed, content):
    try:
        return computed(content)
    except ValueError as error:  # a CaseError too
        return error


def changed(content, place, value):
    content = copy.deepcopy(content)
    inner = content
    for key in place[:-1]:
        inner = inner.setdefault(key, {}) if isinstance(inner, dict) else inner[key]
    inner[place[-1]] = value
    return content


@pytest.mark.parametrize("kind", KINDS)
def test_every_field_is_used_or_refused(computed, kind):
    content = KINDS[kind]
    before = computed(content)
    assert computed(copy.deepcopy(content)) == before
    model = kind_of(content).model_validate(content)
    dropped, attempted = [], 0
    for place, field, value in leaves(model, sections=TRIED[kind]):
        for other in others(place[-1], field, value):
            attempted += 1
            after = outcome(computed, changed(content, place, other))
            if isinstance(after, ValueError):
                # by the name of the field, or of the incompatible field
                assert {place[-1], place[0]} & set(re.findall(r"\w+", str(after))), after
                continue
            if after == before:
                dropped.append((".".join(map(str, place)), other))
            break
    assert attempted > 0
    assert dropped == []


def test_every_field_of_every_section_is_tried():
    """Every section and field occurs in one of the cases above or in the lists."""
    from samcontact.cases.field_units import all_models

    attempted, sections = [], set()
    for kind, content in KINDS.items():
        model = kind_of(content).model_validate(content)
        waiting = [model]
        while waiting:
            part = waiting.pop()
            sections.add(type(part))
            for value in part.__dict__.values():
                parts = value if isinstance(value, list) else [value]
                waiting += [item for item in parts if isinstance(item, BaseModel)]
        attempted += [
            place[-1]
            for place, field, value in leaves(model, sections=TRIED[kind])
            if others(place[-1], field, value)
        ]
    assert len(attempted) > 20 * len(KINDS)
    bodies = {"RigidBody", "ElasticBody", "PerfectPlasticBody", "LinearHardeningBody"}  # a law each
    bodies |= {"PerfectPlasticLayer", "LinearHardeningLayer", "VoidRandomInclusions"}
    laws = ("PerfectPlastic", "LinearHardening", "Swift", "Voce", "Tabulated")
    bodies |= {f"{law}{part}" for law in laws for part in ("Inclusion", "RandomInclusions")}
    missing = {model.__name__ for model in all_models(*ALL_KINDS)} - bodies
    assert missing - {model.__name__ for model in sections} == set()
    fields = {name for model in sections for name in model.model_fields}
    sections_in = (
        "kinematic yield_profile free_faces relaxation layers surface path body1 body2 contact "
        "adhesion capped_coulomb anisotropic mapped_coulomb falling_coulomb third_body "
        "thermal_coulomb heat asperities sliding output fatigue limit shakedown hardness exposure "
        "life dents particles random inclusions random_inclusions cluster lubricant film boundary "
        "transient"
    )
    given = (
        "law kind shape title description estimate_error directory column "
        "figures format body volume"
    )
    assert fields - set(attempted) - set(f"{sections_in} {given}".split()) - OF_ACCURACY == set()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"wear": {"energy": 1e-14}}, r"wear\.energy requires Coulomb friction"),
        ({"wear": WEAR | {"repeats": 5}}, r"repeats applies to energy and archard only"),
        ({"wear": WEAR | {"energy": 1e-14}}, "energy, archard must be given, got thr"),
        ({"wear": {"energy": 1e-14, "window": 3}}, "window applies to threshold only"),
        ({"wear": {"cycles": 3}}, "one of threshold, energy, archard must be given, got none"),
        ({"wear": WEAR, "output": {"volume": "all"}}, r"output\.volume cannot be"),
        ({"wear": WEAR, "output": {"body": 1}}, r"output\.body cannot be combined with \[wear\]"),
        ({"grid": {k: GRID[k] for k in ("nx", "ny", "dx", "dy")}, "output": {"volume": "all"},
             "body1": {"law": "rigid"}, "body2": {"law": "elastic", "E": 1e9, "nu": 0.3}},
         r"output\.volume = 'all' requires grid\.dz"),
        ({"heat": None, "path": [{"load": 1.0}]}, r"body1\.thermal has no effect without"),
        ({"heat": None, "path": [{"load": 1.0}], "body1": COLD,
             "body2": COLD | {"layers": [LAYER | {"thermal": SWIFT["thermal"]}]}},
         r"body2\.layers\[0\]\.thermal has no effect without"),
        ({"body1": COLD, "body2": COATED | {"layers": [COLD | {"thickness": 1e-6}]},
             "grid": {k: GRID[k] for k in ("nx", "ny", "dx", "dy")}},
         r"body1 is elastic-plastic \(law swift\) and requires a grid"),
        ({"contact": CONTACT | {"residual_stress": "exact"}},
         r"contact\.image_tol has effect with residual_stress"),
        ({"path": [{"load": 1.0, "exponent": 3.0}]}, r"exponent requires spacing = \"power\""),
    ],
)  # fmt: skip
def test_fields_without_effect_are_refused_by_name(change, message):
    with pytest.raises(CaseError, match=message):
        Case.model_validate(BASE | change)


def test_a_zero_heat_factor_accepts_all_heat_fields():
    """A sweep of the heat factor may start from 0."""
    Case.model_validate(BASE | {"heat": HEAT | {"factor": 0.0}, "path": [{"load": 1.0}]})


def test_asperities_do_not_support_heat():
    for name in ("thermal", "softening"):
        body = COLD | {name: SWIFT[name]}
        with pytest.raises(
            CaseError, match=rf"body2\.{name} .*\[asperities\] does not support heat"
        ):
            AsperityCase.model_validate(ASPERITIES | {"body2": body})
    warm = COLD | {"softening": SWIFT["softening"] | {"ambient": 400.0}}
    AsperityCase.model_validate(ASPERITIES | {"body2": warm})
