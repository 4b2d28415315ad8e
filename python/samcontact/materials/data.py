# SPDX-License-Identifier: GPL-3.0-or-later
"""Constants of the library of materials in SI units, each with its source and condition."""

from __future__ import annotations

Row = tuple[str, float, str, str]
"""Name of a constant, value in SI units, source, condition."""

BOUCLY = "Boucly (2008), doctoral thesis, INSA Lyon"
SKF = "SKF, Rolling bearings catalogue, properties of bearing steel and silicon nitride"
ISO_6336_2 = "ISO 6336-2, elasticity factor"
ASM_STEEL = "ASM Handbook, vol. 1 (1990), physical constants of carbon and low-alloy steels"
MIL_HDBK_5 = "MIL-HDBK-5, low-alloy steels"
ATLAS = "Atlas Steels, grade data sheet 440A, 440B, 440C"
EN_10088_1 = "EN 10088-1, 1.4404"
EN_1993_1_4 = "EN 1993-1-4"
SMC_045 = "Special Metals, data sheet SMC-045"
TI_SHEET = "ASM Aerospace Specification Metals, data sheet MTP644"
AL_SHEET = "Aluminum Association, in ASM Aerospace Specification Metals, data sheet MA7075T6"
CDA = "Copper Development Association, alloy C93200"
VICTREX = "Victrex, data sheet PEEK 450G"
CARBIDE = "ASM Handbook, vol. 2 (1990), cobalt-bonded cemented carbides"
FERRARI = "Ferrari et al. (1999), Appl. Phys. Lett. 75, 1893-1895"
KIM = "Kim et al. (1992), J. Appl. Phys. 72, 1805-1811"
HOLLECK = "Holleck (1986), J. Vac. Sci. Technol. A 4, 2661-2669"

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
            ("E", 206e9, ISO_6336_2, "steel"),
            ("nu", 0.3, ISO_6336_2, "steel"),
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
        (("E", 206e9, ISO_6336_2, "steel"), ("nu", 0.3, ISO_6336_2, "steel")),
    ),
    "4140": (
        "heat-treatable steel",
        ("42CrMo4", "1.7225", "SCM440"),
        (
            ("E", 200e9, MIL_HDBK_5, "29.0e6 psi"),
            ("nu", 0.32, MIL_HDBK_5, ""),
            ("density", 7850.0, "Callister, Materials Science and Engineering, table B.1", ""),
            ("conductivity", 42.7, ASM_STEEL, "100 °C, hardened and tempered"),
            ("expansion", 12.3e-6, ASM_STEEL, "20 to 100 °C"),
            ("specific_heat", 473.0, ASM_STEEL, "150 to 200 °C"),
            ("yield_stress", 655e6, "ASM, in MatWeb, AISI 4140", "normalised at 870 °C, 25 mm"),
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
            ("conductivity", 6.7, "BTI Metals, data sheet Ti 6Al-4V", "100 to 300 °C"),
            ("expansion", 8.6e-6, "BTI Metals, data sheet Ti 6Al-4V", "20 to 100 °C"),
            ("specific_heat", 526.0, "BTI Metals, data sheet Ti 6Al-4V", "25 °C"),
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
            ("E", 71.7e9, AL_SHEET, "mean of tension and compression"),
            ("nu", 0.33, AL_SHEET, ""),
            ("density", 2810.0, AL_SHEET, ""),
            ("conductivity", 130.0, AL_SHEET, ""),
            ("expansion", 23.6e-6, AL_SHEET, "20 to 100 °C"),
            ("specific_heat", 960.0, AL_SHEET, ""),
            ("yield_stress", 503e6, AL_SHEET, "typical"),
        ),
    ),
    "bronze": (
        "leaded tin bronze for plain bearings, continuously cast",
        ("C93200", "SAE 660", "CuSn7ZnPb", "CC493K"),
        (
            ("E", 100e9, CDA, "14.5e6 psi"),
            ("nu", 0.3, ISO_6336_2, "tin bronze"),
            ("density", 8910.0, CDA, "0.322 lb/in^3"),
            ("conductivity", 58.2, CDA, "33.6 BTU/(ft h °F), 20 °C"),
            ("expansion", 18.0e-6, CDA, "10.0e-6 1/°F"),
            ("specific_heat", 377.0, CDA, "0.09 BTU/(lb °F), 20 °C"),
            ("yield_stress", 138e6, "ASTM B505", "20 ksi, minimum at 0.5 % extension"),
        ),
    ),
    "PEEK": (
        "polymer, not reinforced; elastic constants hold for short loading at 23 °C",
        ("PEEK 450G",),
        (
            ("E", 4.0e9, VICTREX, "tension, 23 °C"),
            ("nu", 0.4, "Victrex, Materials Properties Guide", "23 °C"),
            ("density", 1300.0, VICTREX, "crystalline"),
            ("conductivity", 0.32, VICTREX, "23 °C"),
            ("expansion", 55e-6, VICTREX, "mean of the directions, below 143 °C"),
            ("specific_heat", 2200.0, VICTREX, "23 °C"),
            ("yield_stress", 98e6, VICTREX, "tensile strength at yield, 23 °C"),
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
    "WC-Co": (
        "cemented carbide with 6 % cobalt, medium grain",
        ("WC-6Co", "tungsten carbide"),
        (
            ("E", 648e9, CARBIDE, "94WC-6Co, medium grain"),
            ("nu", 0.22, "ZZBetter, characteristics of cemented carbide", "0.21 to 0.24"),
            ("density", 15000.0, CARBIDE, "94WC-6Co, medium grain"),
            ("conductivity", 100.0, CARBIDE, "94WC-6Co, medium grain"),
            ("expansion", 4.3e-6, CARBIDE, "94WC-6Co, up to 200 °C"),
        ),
    ),
    "DLC": (
        "diamond-like carbon with hydrogen, ta-C:H; E of other DLC differs by a factor of ten",
        ("ta-C:H",),
        (
            ("E", 300e9, FERRARI, "± 49 GPa, Brillouin scattering, 70 % sp3"),
            ("nu", 0.3, FERRARI, "from the bulk and shear moduli"),
            ("density", 2360.0, FERRARI, ""),
        ),
    ),
    "DLC ta-C": (
        "tetrahedral amorphous carbon without hydrogen",
        ("ta-C",),
        (
            ("E", 757e9, FERRARI, "± 47.5 GPa, Brillouin scattering, 88 % sp3"),
            ("nu", 0.12, FERRARI, ""),
            ("density", 3260.0, FERRARI, ""),
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
            ("density", 5400.0, HOLLECK, ""),
            ("expansion", 9.4e-6, HOLLECK, ""),
        ),
    ),
}
"""Description, other names and constants of each material."""
