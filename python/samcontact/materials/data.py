# SPDX-License-Identifier: GPL-3.0-or-later
"""Constants of the library of materials in SI units, each with its source and condition."""

from __future__ import annotations

Row = tuple[str, float, str, str]
"""Name of a constant, value in SI units, source, condition."""

BOUCLY = "Boucly (2008), doctoral thesis, INSA Lyon"
SKF = "SKF, Rolling bearings catalogue, properties of bearing steel and silicon nitride"
ISO_6336_2 = "ISO 6336-2, elasticity factor"
ATLAS = "Atlas Steels, grade data sheet 440A, 440B, 440C"
EN_10088_1 = "EN 10088-1, 1.4404"
EN_1993_1_4 = "EN 1993-1-4"
SMC_045 = "Special Metals, data sheet SMC-045"
ROUND_STEEL = "Round-Steel, 16MnCr5/20MnCr5, www.round-steel.com"
MATWEB_4140 = "MatWeb, AISI 4140, www.matweb.com"
DOUBLE_EAGLE = "Double Eagle Alloys, AISI 4140, doubleeaglealloys.com"
TI_SHEET = "ASM Aerospace Specification Metals, data sheet MTP644, asm.matweb.com"
TI_BTI = "BTI Metals, data sheet Ti 6Al-4V ELI, btimetals.com"
AL_SHEET = "APAC Infrastructure, specification of 7075 T6, apacinfrastructure.com.au"
BRONZE = "Spectrum Machine, data sheet C93200, www.spectrummachine.com"
MAKE_IT_FROM = "MakeItFrom, {}, www.makeitfrom.com"
CARBIDE = MAKE_IT_FROM.format("Tungsten Carbide (WC)")
ALUMINA = MAKE_IT_FROM.format("97-99% Purity Alumina")
MUNRO = "Munro (1997), J. Am. Ceram. Soc. 80, 1919-1928; NIST Standard Reference Database 150"
PEEK = "Sci. Rep. (2024), doi.org/10.1038/s41598-024-79536-3, table 1"
DLC = "Nat. Commun. (2021), doi.org/10.1038/s41467-021-24766-6, table 1"
KIM = "Kim et al. (1992), J. Appl. Phys. 72, 1805-1811"
MITSUBISHI = "Mitsubishi Materials, Cutting tool materials, www.mitsubishicarbide.net"

DATA: dict[str, tuple[str, tuple[str, ...], tuple[Row, ...]]] = {
    "52100": (
        "bearing steel, through-hardened",
        ("100Cr6", "SUJ2", "1.3505"),
        (
            ("E", 210e9, BOUCLY, ""),
            ("nu", 0.3, BOUCLY, ""),
            ("density", 7900.0, SKF, "bearing steel"),
            ("conductivity", 50.2, BOUCLY, "steel of the heated contact"),
            ("expansion", 11.7e-6, BOUCLY, "steel of the heated contact"),
            ("specific_heat", 440.0, "EN 1993-1-2", "carbon steels in general, 20 °C"),
            ("B", 945e6, BOUCLY, "Swift's law with plastic strain in microstrain"),
            ("C", 20.0, BOUCLY, "Swift's law"),
            ("n", 0.121, BOUCLY, "Swift's law"),
        ),
    ),
    "M50": (
        "bearing steel for high temperatures",
        ("80MoCrV42-16", "1.3551"),
        (
            ("E", 210e9, BOUCLY, "with B, C and n; 214 GPa in the data sheet of BTI Metals"),
            ("nu", 0.3, BOUCLY, ""),
            ("density", 7870.0, "BTI Metals, data sheet AISI M50", "20 °C"),
            ("expansion", 11.2e-6, "BTI Metals, data sheet AISI M50", "21 to 93 °C"),
            ("B", 1280e6, BOUCLY, "Swift's law with plastic strain in microstrain"),
            ("C", 4.0, BOUCLY, "Swift's law"),
            ("n", 0.095, BOUCLY, "Swift's law"),
        ),
    ),
    "440C": (
        "martensitic stainless bearing steel",
        ("X105CrMo17", "1.4125", "SUS440C"),
        (
            ("E", 200e9, ATLAS, "215 GPa at 20 °C in EN 10088-1"),
            ("nu", 0.3, EN_1993_1_4, "stainless steels in general, not measured on 440C"),
            ("density", 7650.0, ATLAS, ""),
            ("conductivity", 24.2, ATLAS, "100 °C; 15 at 20 °C in EN 10088-1"),
            ("expansion", 10.1e-6, ATLAS, "0 to 100 °C"),
            ("specific_heat", 460.0, ATLAS, "0 to 100 °C"),
            ("yield_stress", 1900e6, ATLAS, "0.2 %, hardened, tempered at 204 °C"),
        ),
    ),
    "16MnCr5": (
        "case-hardening steel; strength of the core",
        ("1.7131", "5115"),
        (
            ("E", 211e9, ROUND_STEEL, ""),
            ("nu", 0.28, ROUND_STEEL, ""),
            ("density", 7890.0, ROUND_STEEL, "7850 in the data sheet of Akrostal"),
            ("conductivity", 41.0, ROUND_STEEL, "101 °C"),
            ("expansion", 12.59e-6, ROUND_STEEL, ""),
            ("specific_heat", 481.0, ROUND_STEEL, "0 to 100 °C"),
            (
                "yield_stress",
                490e6,
                "UNI 7846:1978, in Lucefin, technical card 16MnCr5",
                "0.2 %, minimum of a core-hardened test blank of 30 mm",
            ),
        ),
    ),
    "18CrNiMo7-6": (
        "case-hardening steel",
        ("1.6587", "17CrNiMo6"),
        (
            ("E", 206e9, ISO_6336_2, "steel; 207 GPa in the gear tables of Roymech, roymech.org"),
            ("nu", 0.3, ISO_6336_2, "steel; the same in the gear tables of Roymech"),
        ),
    ),
    "4140": (
        "heat-treatable steel",
        ("42CrMo4", "1.7225", "SCM440"),
        (
            ("E", 205e9, MATWEB_4140, "steels in general; 29e6 psi at Double Eagle Alloys"),
            ("nu", 0.29, MATWEB_4140, "calculated"),
            ("density", 7850.0, MATWEB_4140, ""),
            (
                "conductivity",
                42.7,
                "Croxon, Physical Properties of 4140 Steel, www.hunker.com",
                "30 BTU/(ft h °F), 51.9 W/(m K), at Double Eagle Alloys",
            ),
            ("expansion", 12.3e-6, DOUBLE_EAGLE, "6.83e-6 1/°F, 20 to 100 °C"),
            ("specific_heat", 477.0, DOUBLE_EAGLE, "0.114 BTU/(lb °F)"),
            ("yield_stress", 655e6, MATWEB_4140, "normalised at 870 °C, 25 mm"),
        ),
    ),
    "316L": (
        "austenitic stainless steel",
        ("1.4404", "X2CrNiMo17-12-2"),
        (
            ("E", 200e9, EN_10088_1, "20 °C"),
            ("nu", 0.3, EN_1993_1_4, "stainless steels in general"),
            ("density", 8000.0, EN_10088_1, ""),
            ("conductivity", 15.0, EN_10088_1, "20 °C"),
            ("expansion", 16.0e-6, EN_10088_1, "20 to 100 °C"),
            ("specific_heat", 500.0, EN_10088_1, "20 °C"),
            ("yield_stress", 220e6, "EN 10088-2, 1.4404", "0.2 %, minimum of hot-rolled plate"),
        ),
    ),
    "Ti-6Al-4V": (
        "titanium alloy, annealed bar",
        ("Ti64", "Grade 5", "3.7165"),
        (
            ("E", 114e9, TI_SHEET, "mean of tension and compression"),
            ("nu", 0.33, TI_SHEET, ""),
            ("density", 4430.0, TI_SHEET, ""),
            ("conductivity", 6.7, TI_BTI, "100 to 300 °C"),
            ("expansion", 8.6e-6, TI_BTI, "20 to 100 °C"),
            ("specific_heat", 526.0, TI_BTI, "25 °C"),
            ("yield_stress", 830e6, TI_SHEET, "annealed"),
        ),
    ),
    "Inconel 718": (
        "nickel alloy, annealed and aged",
        ("IN718", "N07718", "2.4668", "718"),
        (
            ("E", 200e9, SMC_045, "29.0e6 psi, dynamic, 21 °C"),
            ("nu", 0.294, SMC_045, "21 °C"),
            ("density", 8220.0, SMC_045, "0.297 lb/in^3, annealed and aged"),
            ("conductivity", 11.4, SMC_045, "79 BTU in/(ft^2 h °F), 21 °C, annealed and aged"),
            ("expansion", 13.2e-6, SMC_045, "7.31e-6 1/°F, 21 to 93 °C"),
            ("specific_heat", 435.0, SMC_045, "21 °C"),
            ("yield_stress", 1034e6, "AMS 5662", "150 ksi, 0.2 %, minimum, annealed and aged"),
        ),
    ),
    "Al 7075": (
        "aluminium alloy, temper T6",
        ("7075-T6", "7075", "AW-7075", "EN AW-7075"),
        (
            (
                "E",
                71.7e9,
                "SubsTech, alloy 7075, www.substech.com",
                "10.4e6 psi; 71.0 GPa in the data sheet of BTI Metals",
            ),
            ("nu", 0.33, AL_SHEET, ""),
            ("density", 2810.0, AL_SHEET, ""),
            ("conductivity", 130.0, AL_SHEET, "the same in the data sheet of BTI Metals"),
            ("expansion", 23.6e-6, AL_SHEET, "23.4e-6 1/K, 20 to 100 °C, at BTI Metals"),
            ("specific_heat", 960.0, AL_SHEET, ""),
            ("yield_stress", 503e6, AL_SHEET, "the same in the data sheet of BTI Metals"),
        ),
    ),
    "bronze": (
        "leaded tin bronze for plain bearings, continuously cast",
        ("C93200", "SAE 660", "CuSn7ZnPb", "CC493K"),
        (
            ("E", 100e9, BRONZE, "14.5e6 psi"),
            ("nu", 0.35, MAKE_IT_FROM.format("UNS C93200"), ""),
            ("density", 8910.0, BRONZE, "0.322 lb/in^3, 20 °C"),
            ("conductivity", 58.2, BRONZE, "33.6 BTU/(ft h °F), 20 °C"),
            ("expansion", 18.0e-6, BRONZE, "10.0e-6 1/°F, 20 to 100 °C"),
            ("specific_heat", 377.0, BRONZE, "0.09 BTU/(lb °F), 20 °C"),
            ("yield_stress", 138e6, BRONZE, "20 ksi, minimum at 0.5 % extension (ASTM B505)"),
        ),
    ),
    "PEEK": (
        "polymer, not reinforced; elastic constants hold for short loading at room temperature",
        ("polyetheretherketone",),
        (
            ("E", 3.5e9, PEEK, "3.6 GPa in Wikipedia, Polyether ether ketone"),
            ("nu", 0.4, PEEK, ""),
            ("density", 1300.0, PEEK, ""),
            ("conductivity", 0.25, "Wikipedia, Polyether ether ketone", ""),
        ),
    ),
    "Si3N4": (
        "silicon nitride of bearing balls",
        ("silicon nitride",),
        (
            ("E", 310e9, SKF, ""),
            ("nu", 0.29, BOUCLY, "ceramic ball"),
            ("density", 3200.0, SKF, ""),
            ("expansion", 3e-6, SKF, ""),
        ),
    ),
    "Al2O3": (
        "alumina, sintered; also oxide inclusions of steel",
        ("alumina", "corundum", "aluminium oxide"),
        (
            ("E", 416e9, MUNRO, "20 °C, at least 99.5 % pure; 220 to 370 GPa in MakeItFrom"),
            ("nu", 0.23, MUNRO, "from E and the bulk modulus of 257 GPa"),
            ("density", 3984.0, MUNRO, "20 °C"),
            ("conductivity", 24.0, ALUMINA, "97 to 99 % pure"),
            ("expansion", 7.2e-6, ALUMINA, "97 to 99 % pure"),
            ("specific_heat", 890.0, ALUMINA, "97 to 99 % pure"),
        ),
    ),
    "WC-Co": (
        "cemented tungsten carbide; the constants depend on the content of cobalt",
        ("cemented carbide", "tungsten carbide"),
        (
            ("E", 630e9, CARBIDE, "530 to 700 GPa in Wikipedia, Tungsten carbide"),
            ("nu", 0.24, CARBIDE, "0.21 to 0.24 at ZZBetter, zzbetter.com"),
            ("density", 15000.0, CARBIDE, "14400 to 15300 at www.tungstenchina.com"),
            ("conductivity", 85.0, CARBIDE, ""),
            ("expansion", 5.4e-6, CARBIDE, ""),
            ("specific_heat", 280.0, CARBIDE, ""),
        ),
    ),
    "DLC": (
        "diamond-like carbon with 20 % hydrogen, a-C:H; E of other DLC differs by a factor of ten",
        ("a-C:H",),
        (
            ("E", 259e9, DLC, ""),
            ("density", 2070.0, DLC, "estimated from E"),
        ),
    ),
    "DLC ta-C": (
        "tetrahedral amorphous carbon without hydrogen, 79 % sp3",
        ("ta-C",),
        (
            ("E", 625e9, DLC, "493 to 625 GPa with 62 to 79 % sp3"),
            ("density", 3010.0, DLC, "estimated from E"),
        ),
    ),
    "TiN": (
        "titanium nitride coating",
        ("titanium nitride",),
        (
            (
                "E",
                469e9,
                KIM,
                "Hill average of c11 = 625, c12 = 165, c44 = 163 GPa; 626 and 156 GPa for c11 and "
                "c44 in Lee et al. (2005), Phys. Rev. B 71, 144106",
            ),
            ("nu", 0.254, KIM, "Hill average of the same constants"),
            ("density", 5210.0, "CRC Handbook of Chemistry and Physics, 97th ed., p. 4.92", ""),
            ("conductivity", 29.0, MITSUBISHI, "the same at 50 °C in Wikipedia, Titanium nitride"),
            ("expansion", 9.4e-6, MITSUBISHI, ""),
        ),
    ),
}
"""Description, alternative names and constants of each material."""
