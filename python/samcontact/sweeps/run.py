# SPDX-License-Identifier: GPL-3.0-or-later
"""Handing the cases to an executor, and collecting what comes back."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import (
    BrokenExecutor,
    CancelledError,
    Future,
    ProcessPoolExecutor,
    as_completed,
)
from contextlib import contextmanager, nullcontext
from multiprocessing import get_context
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._util.checks import boolean, file_path, integer
from .._util.progress import progress_bar
from .._util.short_text import in_short
from ..diagnostics import resolution
from ..files.atomic import undisturbed
from ..restart.lock import locked
from . import worker
from .worker import Outcome, case_key, failure

if TYPE_CHECKING:
    import xarray as xr

    from ..cases.base import CaseFile
    from .store import Store

Tasks = dict[str, tuple[dict[str, Any], str]]
Take = Callable[[str, Outcome], None]


class SweepInterrupted(KeyboardInterrupt):
    """Ctrl-C during a sweep; what was finished by then is in the attribute `dataset`."""

    def __init__(self, dataset: xr.Dataset) -> None:
        super().__init__("the sweep was interrupted; its attribute dataset has what was finished")
        self.dataset = dataset


def sweep(
    case: CaseFile | str | os.PathLike[str],
    parameters: Mapping[str, Sequence[Any]],
    *,
    executor: Any = None,
    output: str | os.PathLike[str] | None = None,
    progress: bool = True,
    mode: str = "product",
) -> xr.Dataset:
    """Solve a case for many values of its fields; one dataset of all.

    Results have the same bits whatever solves them.

    Parameters
    ----------
    case : Case, TuggingCase or path
        What all cases have in common, or the case file.
    parameters : mapping of str to sequence
        Values of fields in SI units, by dotted name: "body2.yield_stress", "path[0].load". A whole
        section may be given as dictionaries.
    executor : optional
        What solves the cases: by default this process, one after the other; a number of worker
        processes on this machine, of one thread each; an executor of `concurrent.futures` or one
        that is like it; a Dask client.
    output : path, optional
        Folder of the results: each case is written there as soon as it is done, all in `sweep.nc`
        at the end. A later call reads what is done and tries again what failed.
    progress : bool, optional
        Show a progress bar; where there is no terminal, ten lines at most.
    mode : {"product", "zip"}, optional
        All combinations of values, each parameter being a dimension; or the first values of all
        parameters, then the second ones, and so on, along a dimension "case".

    Returns
    -------
    xarray.Dataset
        All quantities with one value per increment (those of `results.scalars`; of a tugging those
        of `asperities.tug`), with NaN behind the end of shorter paths and for cases that failed;
        status "done" or "failed", and error, a text, of each case.

    Raises
    ------
    CaseError
        A case that is not valid, a field that does not exist, a file that cannot be read: before
        any case is solved. A ValueError.
    ValueError, TypeError
        Parameters, mode or executor that cannot be used.
    OSError
        The output cannot be written.
    SweepInterrupted
        Ctrl-C. What is finished is kept.

    Warns
    -----
    ResolutionWarning
        Once: how many cases are fewer than 8 cells across, or have plastic zones of fewer than 8
        layers.
    """
    from ..cases import load_case
    from ..cases.base import CaseFile
    from ..results import save
    from .plan import make_plan
    from .store import Store, assemble

    boolean("progress", progress)
    base = case if isinstance(case, CaseFile) else load_case(file_path("case", case))
    plan = make_plan(base, parameters, mode)
    digests: dict[Path, str] = {}
    keys = [case_key(made, digests) for made in plan.cases]
    cases = dict(zip(keys, plan.cases, strict=True))
    interrupted: KeyboardInterrupt | None = None
    folder = None if output is None else file_path("output", output)
    with nullcontext() if folder is None else locked(folder):
        run = _Run(cases, None if folder is None else Store(folder))
        with _resolved(executor) as chosen:
            try:
                run.solve(chosen, progress)
            except KeyboardInterrupt as stop:
                interrupted = stop
                if isinstance(chosen, _OwnPool):
                    chosen.terminate()
        dataset = assemble(plan, keys, run.outcomes, base)
        resolution.warn_of_sweep(dataset, stacklevel=2)
        if output is not None:
            save(dataset, Path(output) / "sweep.nc")
    if interrupted is not None:
        raise SweepInterrupted(dataset) from interrupted
    return dataset


class _Run:
    """The different cases of a sweep by key, and the outcomes so far."""

    def __init__(self, cases: dict[str, CaseFile], store: Store | None) -> None:
        self.cases, self.store = cases, store
        self.outcomes: dict[str, Outcome] = {}

    def solve(self, executor: Any, progress: bool) -> None:
        """Find the outcome of every case: what is kept of it, or a new one."""
        with progress_bar(len(self.cases), "case", shown=progress) as bar:

            def take(key: str, outcome: Outcome) -> None:
                with undisturbed():
                    if self.store is not None and "variables" in outcome:
                        self.store.write(key, outcome["variables"])
                    self.outcomes[key] = outcome
                    bar.update()

            tasks: Tasks = {}
            for key, case in self.cases.items():
                if self.store is not None and (kept := self.store.read(key)) is not None:
                    self.outcomes[key] = {"variables": kept}
                    bar.update()
                else:
                    content = case.model_dump(exclude_unset=True)
                    tasks[key] = content, str(case.source.resolve())
            _solve(executor, tasks, take)


def _solve(executor: Any, tasks: Tasks, take: Take) -> None:
    """Hand on the outcome of each task, as they come."""
    if executor is None:
        for key, task in tasks.items():
            take(key, worker.solve_case(*task))
        return
    futures: dict[Future[Outcome], str] = {}
    try:
        for key, task in tasks.items():
            try:
                futures[executor.submit(worker.solve_case, *task)] = key
            except BrokenExecutor as error:  # a worker has died already
                take(key, failure(error))
        for future in as_completed(list(futures)):
            take(futures.pop(future), _outcome(future))
    except BaseException as error:
        for future in futures:
            future.cancel()
        if isinstance(error, KeyboardInterrupt):
            for future, key in futures.items():
                if future.done() and not future.cancelled() and future.exception() is None:
                    take(key, future.result())
        raise


def _outcome(future: Future[Outcome]) -> Outcome:
    """What a task returned, or the end of the process that had it."""
    try:
        error = future.exception()
    except CancelledError as cancelled:
        error = cancelled
    return future.result() if error is None else failure(error)


@contextmanager
def _resolved(executor: Any) -> Iterator[Any]:
    """The executor that the user's argument stands for."""
    if executor is None:
        yield None
    elif isinstance(executor, int):
        with _one_thread(), _OwnPool(integer("executor", executor, 1)) as pool:
            yield pool
    elif hasattr(executor, "get_executor"):
        # a Dask client; not pure, else a failed case would be remembered instead of tried again
        yield executor.get_executor(pure=False)
    elif hasattr(executor, "submit"):
        yield executor
    else:
        raise TypeError(
            "executor must be None, a number of processes, an executor or a Dask client, "
            f"got {in_short(executor)}"
        )


class _OwnPool(ProcessPoolExecutor):
    """Worker processes that end with a sweep.

    They are spawned: a fork of a process that used OpenMP hangs.
    """

    def __init__(self, count: int) -> None:
        super().__init__(count, get_context("spawn"))

    def submit(self, *task: Any, **named: Any) -> Future[Any]:
        """Workers that start now inherit that Ctrl-C is not for them, also while they import."""
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            return super().submit(*task, **named)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)

    def terminate(self) -> None:
        """End the workers now, in the middle of their cases."""
        for process in list((self._processes or {}).values()):
            process.terminate()


@contextmanager
def _one_thread() -> Iterator[None]:
    """Processes started meanwhile use one thread each, unless the user has set a number."""
    name = "OMP_NUM_THREADS"
    given = os.environ.get(name)
    os.environ.setdefault(name, "1")
    try:
        yield
    finally:
        if given is None:
            del os.environ[name]
