# SPDX-License-Identifier: GPL-3.0-or-later
"""Library of materials: each value has a source and a plausible size; missing values are errors."""

import math
import re

import pytest
from click.testing import CliRunner

import samcontact as sc
from samcontact.cases import Case, CaseError
from samcontact.commands.main import main

USUAL_NAMES = (
    "52100 M50 440C 16MnCr5 18CrNiMo7-6 4140 316L Ti-6Al-4V Al_7075 Inconel_718 bronze PEEK Si3N4 "
    "WC-Co DLC TiN Al2O3"
)
RANGES = {
    "E": (1e9, 1e12), "nu": (0.1, 0.45), "density": (1e3, 2e4), "conductivity": (0.1, 300),
    "expansion": (1e-6, 1e-4), "specific_heat": (100, 3000), "diffusivity": (1e-8, 1e-4),
    "yield_stress": (5e7, 3e9), "B": (5e8, 2e9), "C": (1, 100), "n": (0.05, 0.3),
}  # fmt: skip
CASE = {
    "title": "library",
    "grid": {"nx": 9, "ny": 9, "dx": 1e-5, "dy": 1e-5, "dz": 1e-5},
    "body1": {"material": "Si3N4"},
    "surface": {"shape": "paraboloid", "Rx": 5e-3},
    "path": [{"load": 1.0}],
}


def body2(**fields):
    return Case.model_validate(CASE | {"body2": fields}).body2


def test_the_library_has_the_usual_materials_each_value_with_a_source():
    assert {name.replace("_", " ") for name in USUAL_NAMES.split()} <= set(sc.materials.names())
    for name in sc.materials.names():
        entry = sc.materials.get(name)
        for alias in (*entry.aliases, name.upper(), f"AISI {name}"):
            assert sc.materials.get(alias) is entry
        for constant, known in entry.values.items():
            low, high = RANGES[constant]
            assert low <= known.value <= high
            assert known.source.strip()
            assert re.search(r"[A-Z]{2,}|\(\d{4}\)|[A-Z]\w+ |/|www\.", known.source)
        for law in entry.laws:
            made = entry.material(law)
            assert (made.E, made.thermal) == (entry.value("E"), entry.thermal)


def test_stiffness_of_titanium_nitride_follows_from_its_crystal():
    # Voigt and Reuss means of the cubic constants of the stated source, c11, c12, c44 [GPa]
    c11, c12, c44 = 625e9, 165e9, 163e9
    bulk = (c11 + 2 * c12) / 3
    voigt = (c11 - c12 + 3 * c44) / 5
    reuss = 5 * (c11 - c12) * c44 / (4 * c44 + 3 * (c11 - c12))
    shear = (voigt + reuss) / 2
    entry = sc.materials.get("TiN")
    assert entry.value("E") == pytest.approx(9 * bulk * shear / (3 * bulk + shear), rel=2e-3)
    ratio = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear))
    assert entry.value("nu") == pytest.approx(ratio, rel=5e-3)


def test_gear_steel_has_the_elasticity_factor_of_steel_gears():
    # (E / (2 pi (1 - nu^2)))^(1/2) = 190 (N/mm^2)^(1/2) of a pair of steel gears (Roymech)
    entry = sc.materials.get("18CrNiMo7-6")
    factor = (entry.value("E") * 1e-6 / (2 * math.pi * (1 - entry.value("nu") ** 2))) ** 0.5
    assert factor == pytest.approx(190.0, abs=0.5)


def test_constants_of_different_sources_agree():
    # K = E/(3 (1 - 2 nu)) of alumina in the NIST data summary
    alumina = sc.materials.get("alumina")
    bulk = alumina.value("E") / (3 * (1 - 2 * alumina.value("nu")))
    assert bulk == pytest.approx(257e9, rel=5e-3)
    # diffusivity of tungsten carbide [mm^2/s] as MakeItFrom computes it
    assert sc.materials.get("WC-Co").value("diffusivity") == pytest.approx(21e-6, rel=0.05)
    # US units of the data sheets: psi, BTU/(ft h °F), 1/°F, BTU/(lb °F), lb/in^3
    bronze = sc.materials.get("bronze")
    read = {"E": 14.5e6 * 6894.757, "conductivity": 33.6 * 1.730735, "expansion": 10.0e-6 * 1.8,
            "specific_heat": 0.09 * 4186.8, "density": 0.322 * 27679.9,
            "yield_stress": 20e3 * 6894.757}  # fmt: skip
    assert {name: bronze.value(name) for name in read} == pytest.approx(read, rel=2e-3)
    steel = sc.materials.get("4140")
    assert steel.value("expansion") == pytest.approx(6.83e-6 * 1.8, rel=2e-3)
    assert steel.value("specific_heat") == pytest.approx(0.114 * 4186.8, rel=2e-3)
    assert sc.materials.get("Al 7075").value("E") == pytest.approx(10.4e6 * 6894.757, rel=1e-3)


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda: sc.materials.get("unobtainium"), "name must be one of 52100, M50"),
        (lambda: sc.materials.get("Bronz"), r"got 'Bronz' \(did you mean bronze\?\)"),
        (lambda: sc.materials.get("DLC").value("conductivity"), "no source is known"),
        (
            lambda: sc.materials.get("DLC").source("B"),
            "constant of DLC must be one of E, density, got 'B'",
        ),
        (
            lambda: sc.materials.get("DLC").material(),
            "known constants for DLC.* library has no value of nu",
        ),
        (
            lambda: sc.materials.get("PEEK").value("yield_stress"),
            "constant of PEEK .* got 'yield_stress'",
        ),
        (lambda: sc.materials.get("Si3N4").material("swift"), "library has no value of B, C, n"),
        (lambda: sc.materials.get("52100").material("rigid"), "law must be one of elastic"),
    ],
)
def test_missing_values_are_clear_errors(call, says):
    with pytest.raises(ValueError, match=says):
        call()


def test_a_case_file_takes_constants_from_the_library():
    entry = sc.materials.get("52100")
    assert body2(material="100Cr6").build() == entry.material()
    assert body2(material=52100).build() == entry.material()  # as without quotes
    assert body2(material="52100", law="swift").build() == entry.material("swift")
    own = body2(
        material="440C", law="linear_hardening", yield_stress="1.5 GPa", tangent_modulus=9e9
    )
    assert own.build().parameters["yield_stress"] == 1.5e9
    coated = body2(material="52100", layers=[{"material": "TiN", "thickness": "2 um"}]).build()
    assert coated.layers[0][0] == sc.materials.get("TiN").material()
    thermal = {"conductivity": 46.0, "expansion": 1.2e-5, "diffusivity": 1.3e-5}
    heated = Case.model_validate(
        CASE | {"body2": {"material": "52100", "thermal": thermal}, "heat": {"factor": [0.0, 0.01]}}
    )
    assert heated.body2.build().thermal == tuple(thermal.values())
    # a constant that the library lacks is given with the material
    carbon = [{"material": "DLC", "nu": 0.2, "thickness": "2 um"}]
    known = body2(material="52100", layers=carbon).build().layers[0][0]
    assert (known.E, known.nu) == (sc.materials.get("DLC").value("E"), 0.2)
    # a study that replaces the material reads the fields of the file only
    changed = body2(material="52100", law="swift").model_dump(exclude_unset=True)
    assert body2(**changed | {"material": "M50"}).build().parameters["B"] == 1280e6


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"material": "nope"}, "material must be one of 52100"),
        ({"material": "M50", "E": 2e11}, "E cannot be combined with material"),
        ({"material": "440C", "law": "swift"}, "B, C, n must be given: for material"),
        ({"material": "DLC"}, "nu must be given: for material = 'DLC'"),
        ({"material": "M50", "law": "rigid"}, "unknown field"),
        ({"material": True}, "must be text"),
    ],
)
def test_materials_that_cannot_be_used_are_refused(fields, says):
    with pytest.raises(CaseError, match=says):
        body2(**fields)


def test_the_command_lists_materials_and_sources():
    listed = CliRunner().invoke(main, ["materials"])
    assert all(name in listed.output for name in sc.materials.names())
    one = CliRunner().invoke(main, ["materials", "in718"])
    assert "0.294" in one.output
    assert "SMC-045" in one.output
    assert CliRunner().invoke(main, ["materials", "nope"]).exit_code == 2
