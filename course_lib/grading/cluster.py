"""Grade many submissions at once on a Dask cluster: the same steps, on other machines.

A task is one submission, sent as bytes; what was graded comes back, and is written down where
the command runs. The cluster's processes judge, so they see hidden inputs and references; the
term's key and the gradebook stay here.
"""

from __future__ import annotations

import hashlib
import logging
import pickle
import threading
import time
import uuid
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import course_lib
import data_generators
from course_lib.grading.assignment import Assignment
from course_lib.grading.isolation import Isolation, NoIsolationError, demand
from course_lib.grading.keeping import kept_judge
from course_lib.grading.one import Graded, grade_one
from course_lib.grading.parcels import Parcel, pack
from course_lib.grading.workers import SET_ASIDE, Manner

#: Seconds to wait for the scheduler; for a worker where there is none; for the next answer; and
#: until one looks again whether there is a worker.
CONNECT, PATIENCE, LOOK, PAUSE = 15.0, 60.0, 5.0, 0.5
AGAIN = "What is graded is recorded; run the same command again to go on"
HOW = "Start some, one for each core: dask worker SCHEDULER --nworkers=-1 --nthreads 1"
DIFFERENT = "it has not the same version of the course as this machine; install it there"
_ONE_AT_A_TIME = threading.Lock()


class ClusterError(RuntimeError):
    """The cluster cannot grade, or no longer; the message says what to do."""


def grade_on_cluster(
    assignment: Assignment,
    students: Sequence[str],
    manner: Manner,
    address: str,
    at_once: int | None = None,
) -> Iterator[Graded]:
    """Grade submissions on the workers of a Dask cluster; yield each as soon as it is done.

    Parameters
    ----------
    assignment : Assignment
        What was asked.
    students : sequence of str
        Whose submissions.
    manner : Manner
        How they are run.
    address : str
        The scheduler's, e.g. ``tcp://192.168.0.10:8786``.
    at_once : int, optional
        How many at a time; one for each worker unless told otherwise.

    Yields
    ------
    Graded
        In the order in which they are done.

    Raises
    ------
    ClusterError
        If there is no scheduler or no worker, a worker refuses, or the scheduler is lost.
    """
    if not students:
        return
    with _connected(address) as client:
        _look_at_workers(client, manner)
        yield from _Run(client, assignment, manner, at_once).grade(students)


@contextmanager
def _connected(address: str) -> Iterator[Any]:
    try:
        from distributed import Client
    except ImportError:
        raise ClusterError(
            "grading on a cluster needs Dask here, too: pip install distributed"
        ) from None
    for handler in logging.getLogger("distributed").handlers:
        handler.setLevel(logging.CRITICAL)  # its news are said below; its loggers have own levels
    try:
        client = Client(address, timeout=CONNECT)
    except (OSError, ValueError, TypeError, ImportError) as error:
        raise ClusterError(f"no Dask scheduler answers at {address} ({error})") from None
    try:
        yield client
    except (CancelledError, OSError) as error:
        raise ClusterError(f"the scheduler at {address} is lost ({error}). {AGAIN}") from None
    finally:
        client.close(timeout=2)


def _look_at_workers(client: Any, manner: Manner) -> None:
    """Make sure that there are workers, and that each can do what is asked."""
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
    except TimeoutError:
        raise ClusterError(f"the cluster has no worker. {HOW}") from None
    found = client.run(_there("why_refuse"), manner.isolation, library_mark(), on_error="return")
    refusals = [f"{worker}: {_words(why)}" for worker, why in sorted(found.items()) if why]
    if refusals:
        number = f"{len(refusals)} of {len(found)} workers cannot grade"
        raise ClusterError(f"{number}.\n" + "\n".join(refusals))


def _there(name: str) -> Callable[..., Any]:
    """Return a function of this module for the cluster, which says so where there is none."""

    def call(*arguments: Any) -> Any:  # sent as code: a name that is not found would stop a worker
        from importlib import import_module

        return getattr(import_module("course_lib.grading.cluster"), name)(*arguments)

    return call


def _words(why: str | Exception) -> str:
    if isinstance(why, (ImportError, AttributeError)):
        return f"{DIFFERENT} ({why})"
    return str(why)


@cache
def library_mark() -> str:
    """Return what tells one version of the course from another: a hash of its modules."""
    digest = hashlib.sha256()
    for package in (course_lib, data_generators):
        root = Path(str(package.__file__)).parent
        for path in sorted(root.rglob("*.py")):
            digest.update(f"{path.relative_to(root)}\x1f".encode() + path.read_bytes())
    return digest.hexdigest()


def why_refuse(isolation: Isolation, mark: str) -> str:
    """Return why this process of a cluster does not grade, in a sentence; empty if it does.

    Parameters
    ----------
    isolation : str
        How submissions are to be kept.
    mark : str
        `library_mark` of the machine that asks.
    """
    if library_mark() != mark:
        return DIFFERENT
    try:
        demand(isolation)
    except NoIsolationError as error:
        return str(error)
    return ""


def grade_there(isolation: Isolation, mark: str, packed: bytes) -> Graded | str:
    """Grade one submission in a process of the cluster; return a sentence if it refuses.

    Parameters
    ----------
    isolation, mark : str
        For `why_refuse`: this process may have come after the others were asked.
    packed : bytes
        The assignment's notebooks, the parcel and what it may use.
    """
    refusal = why_refuse(isolation, mark)
    if refusal:
        return refusal
    given, parcel, allowance = pickle.loads(packed)
    with _ONE_AT_A_TIME:  # however many threads the worker has
        return grade_one(given, parcel, kept_judge(isolation, allowance))


class _Run:
    """What waits, and what the cluster is at."""

    def __init__(
        self, client: Any, assignment: Assignment, manner: Manner, at_once: int | None
    ) -> None:
        self._client, self._assignment, self._manner = client, assignment, manner
        self._at_once = at_once
        self._running: dict[Any, Parcel] = {}

    def grade(self, students: Sequence[str]) -> Iterator[Graded]:
        """Keep the workers busy until all is graded."""
        waiting, alone_since = deque(students), time.monotonic()
        while waiting or self._running:
            workers = len(self._client.nthreads())
            if workers:
                alone_since = time.monotonic()
            elif time.monotonic() - alone_since > PATIENCE:
                raise ClusterError(f"the cluster's last worker is gone. {HOW}. {AGAIN}")
            elif not self._running:
                time.sleep(PAUSE)
            while waiting and len(self._running) < (self._at_once or workers):
                parcel = pack(self._assignment, waiting.popleft())
                if parcel.trouble:
                    yield Graded(parcel.student, parcel.fingerprint, parcel.trouble)
                else:
                    self._send(parcel)
            yield from self._next_done()

    def _send(self, parcel: Parcel) -> None:
        packed = pickle.dumps((self._assignment.notebooks, parcel, self._manner.allowance))
        what = (self._manner.isolation, library_mark(), packed)
        name = f"grade-{uuid.uuid4().hex}"  # it is shown to whoever looks at the scheduler
        task = self._client.submit(_there("grade_there"), *what, key=name, pure=False)
        self._running[task] = parcel

    def _next_done(self) -> Iterator[Graded]:
        from distributed import wait

        try:
            done = wait(list(self._running), timeout=LOOK, return_when="FIRST_COMPLETED").done
        except TimeoutError:
            return
        for future in done:
            yield self._taken(future, self._running.pop(future))

    def _taken(self, future: Any, parcel: Parcel) -> Graded:
        from distributed import KilledWorker

        error = future.exception()
        if isinstance(error, KilledWorker):  # the scheduler has tried it on several
            return Graded(parcel.student, parcel.fingerprint, SET_ASIDE)
        if isinstance(error, CancelledError):
            raise error
        found = _words(error) if error else future.result()
        if isinstance(found, Graded):
            return found
        raise ClusterError(f"a worker of the cluster cannot grade: {found}. {AGAIN}")
