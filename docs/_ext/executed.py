# SPDX-License-Identifier: GPL-3.0-or-later
"""Notebooks and pages with the outputs of their code in a run of this package.

The outputs of a run are stored in build/executed, under a hash of everything that they depend on.
The site and the tests use the same outputs. A run has no time limit.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
import re
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any

import nbclient
import nbformat

import samcontact

ROOT = Path(__file__).parents[2]
STORE = ROOT / "build" / "executed"
NEVER = 10**8  # seconds, where None is not accepted

STRICT = """
import warnings
warnings.simplefilter("error")
# from the kernel itself, when it shuts down
warnings.simplefilter("ignore", PendingDeprecationWarning)
# from libraries that look for others
warnings.simplefilter("ignore", ImportWarning)
"""


@cache
def fingerprint() -> str:
    """Hash of this package with the compiled core, and of the versions of installed packages."""
    found = hashlib.sha256(Path(__file__).read_bytes())
    package = Path(samcontact.__file__).parent
    for file in sorted(package.rglob("*")):
        if file.is_file() and file.suffix != ".pyc":
            found.update(str(file.relative_to(package)).encode() + file.read_bytes())
    installed = {f"{one.metadata['Name']}=={one.version}" for one in metadata.distributions()}
    found.update("\n".join([sys.version, *sorted(installed)]).encode())
    return found.hexdigest()


def executed(notebook: Any) -> Any:
    """Return a notebook with outputs, from the store or from a new run.

    An error in a cell raises `nbclient.exceptions.CellExecutionError`.
    """
    key = hashlib.sha256((fingerprint() + nbformat.writes(notebook)).encode()).hexdigest()
    STORE.mkdir(parents=True, exist_ok=True)
    kept = STORE / f"{key}.ipynb"
    with (STORE / f"{key}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # a second process waits, then reads
        if not kept.exists():
            nbformat.write(_run(notebook), kept.with_suffix(".part"))
            kept.with_suffix(".part").rename(kept)
    return nbformat.read(kept, as_version=4)


def _run(notebook: Any) -> Any:
    """Run a notebook in an empty folder, with warnings as errors."""
    strict = nbformat.v4.new_code_cell(STRICT)
    whole = nbformat.v4.new_notebook(cells=[strict, *notebook.cells], metadata=notebook.metadata)
    # The kernel imports from the same places as this process.
    places = [str(Path(place).resolve()) for place in sys.path if place]
    with tempfile.TemporaryDirectory() as folder:
        nbclient.NotebookClient(
            whole,
            timeout=None,
            startup_timeout=NEVER,
            kernel_name="python3",
            extra_arguments=["--IPKernelApp.log_level=40"],
            resources={"metadata": {"path": folder}},
        ).execute(env={**os.environ, "PYTHONPATH": os.pathsep.join(places)})
        whole.metadata["files"] = sorted(file.name for file in Path(folder).iterdir())
    del whole.cells[0]
    return whole


# A page of text: Python code, and a case file with the command below it.
BLOCK = re.compile(
    r"^```python\n(?P<code>.*?)^```\n"
    r"|^```toml\n(?P<case>.*?)^```\n(?P<between>(?:(?!```).)*?)"
    r"^```console\n\$ samcontact (?P<words>run (?P<file>[\w.]+))\n```\n",
    re.MULTILINE | re.DOTALL,
)
FIGURE = "<!-- figure -->\n"
COMMAND = """
import os, pathlib, subprocess, sys
pathlib.Path({file!r}).write_text({case!r})
command = [sys.executable, "-m", "samcontact", *{words!r}.split()]
plain = {{**os.environ, "FORCE_COLOR": "", "CLICOLOR_FORCE": ""}}  # kernels ask for colours
print(subprocess.run(command, check=True, capture_output=True, text=True, env=plain).stdout)
"""
# One figure of a command is enough.
SAVED = """
import pathlib, IPython.display
here = pathlib.Path()
for saved in sorted([*here.glob("*.png"), *here.glob("results/*/sections.png")]):
    IPython.display.display(IPython.display.Image(data=saved.read_bytes()))
    saved.unlink()
"""


def _cell(block: re.Match[str]) -> Any:
    code = block["code"] or COMMAND.format(**block.groupdict())
    return nbformat.v4.new_code_cell(code + SAVED, id=f"block-{block.start()}")


def _shown(cell: Any) -> Iterator[str]:
    """Yield the printed output and the saved figures of a cell as Markdown."""
    printed = "".join(o.text for o in cell.outputs if o.output_type == "stream").rstrip()
    if printed:
        yield f"\n`````{{code-block}} text\n:class: output\n{printed}\n`````\n"
    for output in cell.outputs:
        if picture := output.get("data", {}).get("image/png"):
            encoded = picture.replace("\n", "")
            yield f"\n![Figure drawn by the code](data:image/png;base64,{encoded})\n"


def with_outputs(page: str) -> str:
    """Return a page of Markdown with the outputs of each code block below the block.

    If the page contains the comment `FIGURE`, the last picture replaces this comment.
    """
    blocks = list(BLOCK.finditer(page))
    notebook = executed(nbformat.v4.new_notebook(cells=[_cell(block) for block in blocks]))
    parts, position = [], 0
    for block, cell in zip(blocks, notebook.cells, strict=True):
        parts += [page[position : block.end()], *_shown(cell)]
        position = block.end()
    parts.append(page[position:])
    if FIGURE in page:
        picture = parts.pop(max(k for k, part in enumerate(parts) if part.startswith("\n![")))
        parts = [part.replace(FIGURE, picture) for part in parts]
    return "".join(parts)


LINK = re.compile(r"\[([^]]+)\]\((\w+)\.ipynb\)")


def _page_of(notebook: Any) -> Any:
    """Return a notebook in which links to other notebooks are links to pages of the site."""
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = LINK.sub(r"{doc}`\1 <\2>`", cell.source)
    return notebook


def show(app: Any, docname: str, content: list[str]) -> None:
    """Add outputs to the source of a notebook, or of a page listed in `executed_pages`."""
    path = app.env.doc2path(docname)
    if path.suffix == ".ipynb":
        notebook = nbformat.reads(content[0], as_version=4)
        run = notebook if path.stem in app.config.unexecuted_notebooks else executed(notebook)
        content[0] = nbformat.writes(_page_of(run))
    elif docname in app.config.executed_pages:
        content[0] = with_outputs(content[0])


def setup(app: Any) -> dict[str, bool]:
    app.add_config_value("executed_pages", [], "env", list)
    app.add_config_value("unexecuted_notebooks", [], "env", list)  # shown without outputs
    app.add_config_value("executed_by", fingerprint(), "env", str)  # a change rebuilds all pages
    app.connect("source-read", show)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
