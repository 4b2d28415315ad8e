# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of the applications, from stored records."""

from __future__ import annotations

import re
from io import BytesIO
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure
from PIL import Image

from .application import Application

DPI = 120
SPDX = "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->"
PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))
PLAIN = {"%": 100.0, "": 1.0, "µm³": 1e18}
"""Factors of units without prefixes."""


def shown(value: float, unit: str, digits: int = 4) -> str:
    """Return a value in SI units as text, with a prefix of the unit."""
    if unit in PLAIN:
        number = value * PLAIN[unit]
        text = f"{number:.0f}" if abs(number) >= 10**digits else f"{number:.{digits}g}"
        return f"{text} {unit}".strip()
    factor, prefix = next((p for p in PREFIXES if abs(value) >= p[0]), PREFIXES[-1])
    return f"{value / factor:.{digits}g} {prefix}{unit}"


def save(figure: Figure, file: Path) -> None:
    """Write a figure with a colour palette, which takes a third of the bytes of full colour."""
    drawn = BytesIO()
    figure.savefig(drawn, dpi=DPI, metadata={"Software": None})
    with Image.open(drawn) as image:
        few = image.convert("RGB").quantize(256)
    few.save(file, optimize=True, dpi=(DPI, DPI))


def error_text(share: float) -> str:
    """Return a relative error in per cent, e.g. "0.24 %" or "170 %"."""
    percent = 100 * share
    return f"{percent:.0f} %" if percent >= 99.5 else f"{percent:.2g} %"


def answers(record: dict[str, Any]) -> str:
    """Return the Markdown table of the answers."""
    heads = ["answer", "value", "estimated error", "by the check", "difference", "check"]
    lines = [f"| {' | '.join(heads)} |", "|---" * len(heads) + "|"]
    for one in record["answers"]:
        error = "" if one["error"] is None else error_text(one["error"])
        expected = difference = ""
        if one["expected"] is not None:
            expected = shown(one["expected"], one["unit"])
            off = 100 * (one["value"] / one["expected"] - 1)
            difference = f"{off:+.2f} %" if abs(off) >= 0.005 else "0.00 %"
        value = shown(one["value"], one["unit"])
        check = re.sub(r"\bsc\.[\w.]*\w", r"`\g<0>`", one["check"])
        cells = [one["quantity"], value, error, expected, difference, check]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def errors(application: Application) -> str:
    """Return the sentences on the errors."""
    text = (
        "The commands themselves estimate errors by a second solution on cells of twice the size."
    )
    if not application.coarser:
        return text
    changed = ", ".join(f"`{new}`" for _, new in application.coarser)
    other = (
        "For answers without such an estimate, the error is the\ndifference from a run of "
        "the same commands with"
    )
    return f"{text} {other} {changed} in the case file."


def page(application: Application, record: dict[str, Any]) -> str:
    """Return the page of an application."""
    one = application
    values = {a["key"]: shown(a["value"], a["unit"], 3) for a in record["answers"]}
    commands = "\n".join(f"$ samcontact {c}" for c in (f"new {one.kind}", *one.commands))
    timed = zip(one.commands, record["seconds"], strict=True)
    times = ", ".join(f"`{command.split()[0]}` {seconds:.0f} s" for command, seconds in timed)
    functions = "\n".join(f"- `{name}`: {what}" for name, what in one.functions)
    tables = "\n\n".join(f"```text\n{table}\n```" for table in record["tables"])
    title, guide = one.guide
    return f"""{SPDX}
<!-- Written by: python -m gallery.applications {one.name} -->
# {one.title}

{one.gains}

![{one.caption}]({one.name}.png)

{one.caption}

## Answer

{one.text.strip().format(**values)}

{answers(record)}

{errors(one)} The column "difference" gives the relative
difference between the value and the check.
{one.limits}

## Commands

```console
{commands}
```

Processor time on one core, figures included: {times}.

{tables}

## Case file

`samcontact new {one.kind}` writes this file:

```toml
{record["case"].strip()}
```

## In Python

{functions}

Guide: [{title}](../guides/{guide}).
"""


def index(applications: list[Application], records: dict[str, Any]) -> str:
    """Return the first page of the applications."""
    rows = [
        f"| [![{a.title}]({a.name}.png)]({a.name}.md) | [{a.title}]({a.name}.md) | {a.gains} |"
        for a in applications
    ]
    total = sum(sum(records[a.name]["seconds"]) for a in applications)
    names = "\n".join(a.name for a in applications)
    return f"""{SPDX}
<!-- Written by: python -m gallery.applications -->
# Applications

Each page answers one engineering task with a few commands and no Python. It shows the case file,
the answer with its estimated error, an independent check, and the processor time. The commands of
all pages together take {total / 60:.0f} min on one core. To solve your own task, write the case
file with `samcontact new KIND`, change its numbers, and repeat the commands.

<div class="gallery landing">

| | task | what you get |
|---|---|---|
{chr(10).join(rows)}

</div>

`python -m gallery.applications` runs all commands and writes these pages.

```{{toctree}}
:hidden:

{names}
```
"""
