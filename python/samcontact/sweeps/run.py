# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of the cases of a parameter study, in this process or by an executor."""

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

Tasks = dict[str, tuple[Any, ...]]
"""Arguments of `worker.solve_case` for each case."""
Take = Callable[[str, Outcome], None]


class SweepInterrupted(KeyboardInterrupt):
    """Interruption of a sweep by Ctrl-C; its attribute `dataset` contains the finished cases."""

    def __init__(self, dataset: xr.Dataset) -> None:
        super().__init__("sweep interrupted; the attribute dataset contains the finished cases")
        self.dataset = dataset


def sweep(
    case: CaseFile | str | os.PathLike[str],
    parameters: Mapping[str, Sequence[Any]],
    *,
    executor: Any = None,
    output: str | os.PathLike[str] | None = None,
    progress: bool = True,
    mode: str = "product",
    find: Mapping[str, Any] | None = None,
) -> xr.Dataset:
    """Solve a case for many values of its fields, and return one dataset.

    Results are bit-identical for all executors.

    Parameters
    ----------
    case : Case, AsperityCase, SlidingCase or path
        Base case, or case file.
    parameters : mapping of str to sequence
        Values of each field in SI units, by dotted name: "body2.yield_stress", "path[0].load". To
        vary a whole section, give dictionaries as values.
    executor : optional
        None: this process solves the cases one after the other. A number: the cases are solved by
        this number of worker processes on this machine, with one thread each. Otherwise an executor
        with the interface of `concurrent.futures`, or a Dask client.
    output : path, optional
        Folder of the results. Each case is written as soon as it is solved; at the end, all cases
        are written to `sweep.nc`. A later call with this folder reads the solved cases, and solves
        failed cases again.
    progress : bool, optional
        Show a progress bar; without a terminal, at most ten lines.
    mode : {"product", "zip"}, optional
        "product": all combinations of values, with one dimension per parameter. "zip": the values
        of all parameters are combined pairwise, along a dimension "case".
    find : mapping, optional
        Arguments of `find_load`, e.g. ``{"quantity": "yield"}``. If given, each case is not solved
        at its own load; instead, the load is found at which the quantity reaches its target value.

    Returns
    -------
    xarray.Dataset
        All quantities that have one value per increment (see `results.scalars`; for asperity
        collisions, see `asperities.collide`) or, for wear, per cycle. Cases with fatigue also have
        the maximum of each criterion, cases with shakedown the response to repeated cycles. With
        `find`, the dataset contains the load found and its error. Values are NaN for failed cases,
        and after the last increment of a case with fewer increments than others. Each case has a
        status, "done" or "failed", and an error text.

    Raises
    ------
    CaseError
        A case is invalid, a field does not exist or a file cannot be read; raised before any case
        is solved. CaseError is a subclass of ValueError.
    ValueError, TypeError
        Parameters, mode or executor are invalid.
    OSError
        The output cannot be written.
    SweepInterrupted
        The sweep was interrupted by Ctrl-C. Finished cases are kept.

    Warns
    -----
    ResolutionWarning
        Some cases have fewer than 8 cells across the contact or fewer than 8 layers across the
        plastic zone. The warning is issued once and states the number of these cases.
    """
    from ..cases import load_case
    from ..cases.base import CaseFile
    from ..results import save
    from .plan import make_plan
    from .store import Store, assemble
    from .tasks import checked_search

    boolean("progress", progress)
    base = case if isinstance(case, CaseFile) else load_case(file_path("case", case))
    plan = make_plan(base, parameters, mode)
    digests: dict[Path, str] = {}
    search = checked_search(find, plan.cases)
    keys = [case_key(made, digests, search) for made in plan.cases]
    cases = dict(zip(keys, plan.cases, strict=True))
    interrupted: KeyboardInterrupt | None = None
    folder = None if output is None else file_path("output", output)
    with nullcontext() if folder is None else locked(folder):
        run = _SweepRun(cases, None if folder is None else Store(folder), search)
        with _resolved(executor) as chosen:
            try:
                run.solve(chosen, progress)
            except KeyboardInterrupt as stop:
                interrupted = stop
                if isinstance(chosen, _WorkerPool):
                    chosen.terminate()
        dataset = assemble(plan, keys, run.outcomes, base)
        resolution.warn_of_sweep(dataset, stacklevel=2)
        if output is not None:
            save(dataset, Path(output) / "sweep.nc")
    if interrupted is not None:
        raise SweepInterrupted(dataset) from interrupted
    return dataset


class _SweepRun:
    """Distinct cases of a sweep, and the outcomes obtained so far, by the hash `case_key`."""

    def __init__(
        self, cases: dict[str, CaseFile], store: Store | None, search: dict[str, Any] | None
    ) -> None:
        self.cases, self.store, self.search = cases, store, search
        self.outcomes: dict[str, Outcome] = {}

    def solve(self, executor: Any, progress: bool) -> None:
        """Read the outcome of each stored case, and solve all other cases."""
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
                    searched = () if self.search is None else (self.search,)
                    tasks[key] = content, str(case.source.resolve()), *searched
            _solve(executor, tasks, take)


def _solve(executor: Any, tasks: Tasks, take: Take) -> None:
    """Solve all tasks with an executor; pass each outcome to `take` as soon as it is available."""
    if executor is None:
        for key, task in tasks.items():
            take(key, worker.solve_case(*task))
        return
    futures: dict[Future[Outcome], str] = {}
    try:
        for key, task in tasks.items():
            try:
                futures[executor.submit(worker.solve_case, *task)] = key
            except BrokenExecutor as error:  # a worker process has terminated
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
    """Return the outcome of a task; if the process that ran the task died, a failed outcome."""
    try:
        error = future.exception()
    except CancelledError as cancelled:
        error = cancelled
    return future.result() if error is None else failure(error)


@contextmanager
def _resolved(executor: Any) -> Iterator[Any]:
    """Context manager that provides the executor described by the argument `executor`."""
    if executor is None:
        yield None
    elif isinstance(executor, int):
        with _one_thread(), _WorkerPool(integer("executor", executor, 1)) as pool:
            yield pool
    elif hasattr(executor, "get_executor"):
        # a Dask client; pure=False, so that failed cases are solved again
        yield executor.get_executor(pure=False)
    elif hasattr(executor, "submit"):
        yield executor
    else:
        raise TypeError(
            "executor must be None, a number of processes, an executor or a Dask client, "
            f"got {in_short(executor)}"
        )


class _WorkerPool(ProcessPoolExecutor):
    """Pool of worker processes that are terminated at the end of a sweep.

    The processes are spawned, because a forked process hangs if its parent used OpenMP.
    """

    def __init__(self, count: int) -> None:
        super().__init__(count, get_context("spawn"))

    def submit(self, *task: Any, **named: Any) -> Future[Any]:
        """Submit a task; worker processes that are started for it ignore Ctrl-C."""
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            return super().submit(*task, **named)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)

    def terminate(self) -> None:
        """Terminate the workers immediately."""
        for process in list((self._processes or {}).values()):
            process.terminate()


@contextmanager
def _one_thread() -> Iterator[None]:
    """Context manager in which new processes use one thread, unless OMP_NUM_THREADS is set."""
    name = "OMP_NUM_THREADS"
    given = os.environ.get(name)
    os.environ.setdefault(name, "1")
    try:
        yield
    finally:
        if given is None:
            del os.environ[name]
