# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies: points to run, their stored records, and a page generated from the records.

A study is a module of this package, or the module `page` of a folder, with a `STUDY`. The command
of a study is `python -m benchmarks.NAME`. A point is a dictionary of arguments; its entry `of`
names the group of the point. A record contains a point, the results of its run, and `on` (version
and processor).
"""

from __future__ import annotations

import importlib
import json
import os
import platform
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import click

import samcontact as sc

ROOT = Path(__file__).resolve().parents[1]
DRAWN = "build/figures"
"""Folder of figures that are drawn from stored records, also when the site is built."""
Record = dict[str, Any]


@dataclass(frozen=True)
class Study:
    """Points of a study, the function for one point, and the output made from the records."""

    name: str
    about: str
    """First line of the help text of the command of the study."""
    points: Callable[[bool], Sequence[Record]]
    """Function that returns all points or, with the argument True, a few small points."""
    run: Callable[..., Record | list[Record]]
    """Function that runs a point, given as keyword arguments; returns one record or several."""
    page: Callable[[list[Record]], str] = lambda records: ""
    draw: Callable[[list[Record]], dict[str, Any]] = lambda records: {}
    """Function that draws the figures from the records, and returns them by file name."""
    document: str = ""
    """Name of the page, if it differs from the name of the study."""
    fresh: bool = False
    """Whether each point runs in a separate process whose memory is measured."""
    lasting: bool = False
    """Whether measurements take so long that each is stored, and --docs uses only stored ones."""
    keeps_quick: bool = False
    """Whether small points are stored with the others."""
    figures: str = DRAWN
    """Folder of the figures; docs/figures if they cannot be drawn from stored records."""

    @property
    def file(self) -> Path:
        """Return the file of the stored records."""
        place = Path(__file__).with_name(self.name)
        return place / "results.json" if place.is_dir() else place.with_suffix(".json")

    @property
    def document_file(self) -> Path:
        return ROOT / "docs" / f"{self.document or self.name}.md"

    def records(self) -> list[Record]:
        """Return the stored records in the order of the points."""
        found: list[Record] = json.loads(self.file.read_text("utf-8")) if self.file.exists() else []
        return found

    def keep(self, new: Sequence[Record]) -> None:
        """Store new records in place of old ones, in the order of the points, one per line."""
        every = [*self.points(False), *(self.points(True) if self.keeps_quick else ())]
        names = sorted({name for point in every for name in point})

        def key(record: Record) -> str:
            return json.dumps([record.get(name) for name in names])

        order = {key(point): place for place, point in enumerate(every)}
        again = {key(record) for record in new}
        kept = [record for record in self.records() if key(record) not in again]
        kept = [record for record in [*kept, *new] if key(record) in order]
        kept.sort(key=lambda record: order[key(record)])
        lines = ",\n".join(json.dumps(record, ensure_ascii=False) for record in kept)
        self.file.write_text(f"[\n{lines}\n]\n", encoding="utf-8")

    def write(self, records: list[Record]) -> None:
        """Write the page and its figures."""
        self.document_file.write_text(self.page(records), encoding="utf-8")
        save(self.draw(records), self.figures)

    def solve(self, points: Sequence[Record], processes: int = 1) -> Iterator[list[Record]]:
        """Compute the records of points in single-threaded processes, and iterate over them."""
        os.environ["OMP_NUM_THREADS"] = "1"
        for batch in [[point] for point in points] if self.fresh else [points]:
            with ProcessPoolExecutor(processes, mp_context=get_context("spawn")) as pool:
                yield from pool.map(_solved, [self.name] * len(batch), batch)

    def main(self) -> None:
        """Run the command of the study."""
        command(self)(prog_name=f"python -m benchmarks.{self.name}")


def find(name: str) -> Study:
    """Return the study with this name."""
    folder = Path(__file__).with_name(name)
    module = importlib.import_module(f"benchmarks.{name}" + ".page" * folder.is_dir())
    found: Study = module.STUDY
    return found


def save(figures: dict[str, Any], folder: str = DRAWN) -> None:
    """Write figures by file name, each atomically."""
    (ROOT / folder).mkdir(parents=True, exist_ok=True)
    for name, figure in figures.items():
        part = ROOT / folder / f"{name}.{os.getpid()}"
        figure.savefig(part, format="png", dpi=150)
        part.replace(ROOT / folder / name)


def measured_on() -> str:
    """Return version of samcontact and name of the processor; studies use one thread."""
    return f"samcontact {sc.__version__}, {platform.machine()}"


def _solved(name: str, point: Record) -> list[Record]:
    """Return the records of one point of a study."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # small, coarse or extreme setups are intended
        found = find(name).run(**point)
    rows = found if isinstance(found, list) else [found]
    return [point | row | {"on": measured_on()} for row in rows]


def command(study: Study) -> click.Command:
    """Choose points, run them, store their records, and write the page."""
    groups = list(dict.fromkeys(point["of"] for point in study.points(False)))
    page = study.document_file.relative_to(ROOT)
    docs = "write" if study.lasting else "store the records, and write"

    @click.command(help=f"{study.about}\n\nGroups of points: {', '.join(groups)}.")
    @click.argument("names", nargs=-1, metavar="[GROUP]...", type=click.Choice(groups))
    @click.option("--rows", default="", metavar="TEXT", help="Only points that contain this text.")
    @click.option("--largest", type=int, metavar="K", help="Only the last K points of each group.")
    @click.option("--quick", is_flag=True, help="Only a few small points.")
    @click.option("--processes", default=1, help="Number of points run in parallel.")
    @click.option("--docs", is_flag=True, help=f"Also {docs} {page}.")
    @click.option("--page", is_flag=True, help=f"Only write {page}, from stored records.")
    def run(
        names: tuple[str, ...], rows: str, largest: int | None, quick: bool, processes: int,
        docs: bool, page: bool,
    ) -> None:  # fmt: skip
        os.environ.setdefault("MPLBACKEND", "Agg")
        keeps = (study.lasting or docs) and (study.keeps_quick or not quick)
        for records in (
            ()
            if page or (docs and study.lasting)
            else study.solve(chosen(study.points(quick), names, rows, largest), processes)
        ):
            click.echo("\n".join(map(_shown, records)))
            if keeps:
                study.keep(records)
        if docs or page:
            study.write(study.records())

    return run


def chosen(
    points: Sequence[Record], names: Sequence[str], rows: str = "", largest: int | None = None
) -> list[Record]:
    """Return the points of the named groups whose arguments contain the text `rows`.

    largest: number of points to return, from the end of each group; None for all.
    """
    found: dict[str, list[Record]] = {}
    for point in points:
        shown = " ".join(str(value) for key, value in point.items() if key != "of")
        if rows in shown and (not names or point["of"] in names):
            found.setdefault(point["of"], []).append(point)
    return [point for group in found.values() for point in group[-(largest or 0) :]]


def _shown(record: Record) -> str:
    return ", ".join(f"{key} {value}" for key, value in record.items() if key != "on")


def by_group(records: Iterable[Record]) -> dict[str, list[Record]]:
    """Return the records of each group, in order."""
    found: dict[str, list[Record]] = {}
    for record in records:
        found.setdefault(record["of"], []).append(record)
    return found


def table(heading: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a Markdown table."""
    lines = [heading, ["---"] * len(heading), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def table_of(rows: Sequence[dict[str, str]]) -> str:
    """Return the Markdown table of rows with equal keys; the keys are the heading."""
    return table(list(rows[0]), [list(row.values()) for row in rows])
