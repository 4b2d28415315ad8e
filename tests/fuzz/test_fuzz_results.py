# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged results are refused by all readers; damaged files of heights are read or refused."""

import numpy as np
import pytest
import xarray as xr
from damaging import damage, edit, write_edited
from fuzzing import tried, try_all, unless_refused
from hypothesis import strategies as st

import samcontact as sc
from case_texts import BODIES
from samcontact import measured, report, results
from samcontact.cases import parse_case

CASE = f"""
title = "small"
[grid]
nx = 8
ny = 8
dx = 1e-4
dy = 1e-4
nz = 8
dz = 1e-4
{BODIES}
[contact]
tol = 1e-4
[[path]]
load = 400.0
increments = 2
"""


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """Return the bytes of a results file, and its dataset."""
    case = parse_case(CASE)
    simulation, path = case.build()
    dataset = results.to_dataset(simulation, simulation.run(path, progress=False), case)
    file = results.save(dataset, tmp_path_factory.mktemp("saved") / "results.nc")
    with results.open_results(file) as again:
        return file.read_bytes(), again.load()


@tried("flipped or cut bytes of results")
def test_damaged_bytes(saved, tmp_path, count):
    content, expected = saved
    file = tmp_path / "results.nc"

    def check(hurt):
        file.write_bytes(hurt(content))
        dataset = unless_refused(lambda: results.open_results(file), ValueError, str(file))
        if dataset is not None:
            with dataset:
                xr.testing.assert_identical(dataset.load(), expected)

    try_all(check, count, hurt=damage())


@tried("edited parts of results")
def test_edited_parts(saved, tmp_path, count, monkeypatch):
    """Files edited by another program give a report, or are refused."""
    file = tmp_path / "results.nc"
    # figures take a second, and read the same fields as the tables
    monkeypatch.setattr("samcontact.report.contact.contact_figures", lambda *_: [])

    def check(change):
        write_edited(saved[0], file, change, sealed=False)
        try:
            with results.open_results(file) as dataset:
                results.scalars(dataset)
                report.checks(dataset)
                report.write(dataset, tmp_path / "report.html")
        except ValueError:
            return
        assert (tmp_path / "report.html").stat().st_size > 1000

    try_all(check, count, change=edit())


tables = st.one_of(
    st.lists(
        st.lists(st.one_of(st.floats().map(repr), st.text(max_size=5)), max_size=5).map(" ".join),
        max_size=6,
    ).map(lambda rows: "\n".join(rows).encode("utf-8", "surrogatepass")),
    st.binary(max_size=300),
)
dtypes = st.sampled_from(["<f8", ">f8", "<f4", "<i8", "?", "<c16", "S3", "O", "<M8[s]", "<f8,<i4"])
headers = st.tuples(dtypes, st.lists(st.integers(-2, 2**40), max_size=4), st.binary(max_size=200))


def npy(parts):
    dtype, shape, rest = parts
    text = f"{{'descr': '{dtype}', 'fortran_order': False, 'shape': {tuple(shape)}, }}\n"
    header = b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text.encode()
    return header + rest


def plain(values, suffix):
    """Return an undamaged file."""
    if suffix == ".csv":
        return "\n".join(",".join(map(repr, row)) for row in values.tolist()).encode()
    return "\n".join(" ".join(map(repr, row)) for row in values.tolist()).encode()


@tried("files of heights")
def test_files_of_heights(tmp_path, count):
    whole = np.round(np.sin(np.arange(20.0)).reshape(4, 5), 3)

    def check(content, hurt, suffix, steps, detrend):
        file = tmp_path / f"heights{suffix}"
        file.write_bytes(plain(whole, suffix) if content is None else content)
        file.write_bytes(hurt(file.read_bytes()) if file.stat().st_size else b"")
        surface = unless_refused(
            lambda: measured.read(file, detrend=detrend, **steps), (ValueError, TypeError)
        )
        if surface is None:
            return
        assert surface.heights.ndim == 2
        assert np.isfinite(surface.heights).all()
        assert surface.dx > 0
        assert surface.dy > 0

    try_all(
        check,
        count,
        content=st.one_of(st.none(), tables, headers.map(npy)),
        hurt=st.one_of(st.just(lambda content: content), damage()),
        suffix=st.sampled_from([".npy", ".txt", ".csv", ".dat", ".x3p", ".sur"]),
        steps=st.one_of(
            st.just({"dx": 1e-6}),
            st.just({"dx": 1e-6, "dy": 2e-6}),
            st.just({}),
            st.floats().map(lambda dx: {"dx": dx}),
            st.just({"dx": 1e-6, "unit": "nm"}),
        ),
        detrend=st.sampled_from(["center", "height", "slope", "curvature", None]),
    )


def test_an_undamaged_file_of_heights_is_read(tmp_path):
    whole = np.round(np.sin(np.arange(20.0)).reshape(4, 5), 3)
    for suffix in (".txt", ".csv"):
        file = tmp_path / f"heights{suffix}"
        file.write_bytes(plain(whole, suffix))
        surface = sc.measured.read(file, dx=1e-6, detrend=None)
        np.testing.assert_array_equal(surface.heights, whole)
