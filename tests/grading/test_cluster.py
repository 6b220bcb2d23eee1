"""`course grade --scheduler`: the same on a Dask cluster, whatever happens to its workers."""

import json
import os
import signal
import time
from dataclasses import replace
from urllib.parse import urlsplit

import dask
import nbformat
import pytest
from distributed import Client, LocalCluster
from nbformat.v4 import new_code_cell
from small_course import run
from walls import walled

from benchmarks.scenes import ASSIGNMENT, PATIENCE, Scene, records
from benchmarks.snapshots import snapshot
from course_lib.cli import main
from course_lib.grading import cluster
from course_lib.grading.cluster import DIFFERENT, _there, _words, library_mark, why_refuse
from course_lib.grading.workers import SET_ASIDE
from data_generators.classes import write_submissions

pytestmark = [pytest.mark.slow, walled]
#: Tries whoever listens, each process, and the folders in which workers keep what they get.
SPY = """
import os, socket
def look(what, act):
    try:
        act()
        print('reached', what)
    except OSError as error:
        print('held', what, error)
for port in {ports}:
    look(port, lambda: socket.create_connection(('127.0.0.1', port), 1))
for process in {processes}:
    for name in ('environ', 'mem', 'cmdline'):
        look(name, lambda: open(f'/proc/{{process}}/{{name}}', 'rb').read(1))
    look('kill', lambda: os.kill(process, 0))
for folder in {folders}:
    look(folder, lambda: os.listdir(folder))
print(dict(os.environ))
"""
CLASS = ("right", "rewritten", "half-done", "misconception-2", "copied-out", "cut-off")


@pytest.fixture(scope="module")
def plain(new_term):
    """What grading on this machine gives."""
    term = new_term("here", CLASS)
    assert run("course", "grade", ASSIGNMENT, cwd=term).returncode == 1  # one is cut off
    return snapshot(term, Scene(term, term.parent))


def local_cluster(workers, **options):
    return LocalCluster(
        n_workers=workers, threads_per_worker=1, dashboard_address=":0", silence_logs=50, **options
    )


def kill_a_worker(there, number=0):
    os.kill(list(there.workers.values())[number].pid, signal.SIGKILL)


def start(term, there, *options):
    return Scene(term, term.parent, scheduler=there.scheduler_address).start(term, *options)


def wait_until(process, happened):
    """Wait for something while a run goes on."""
    limit = time.monotonic() + PATIENCE
    while not happened() and process.poll() is None:
        assert time.monotonic() < limit
        time.sleep(0.02)


def said(term):
    return (term / "grade.log").read_text()


def test_the_same_as_here_though_workers_are_killed(new_term, plain):
    term = new_term("there", CLASS)
    with local_cluster(2) as there:
        process = start(term, there)
        for number in (0, 1):
            wait_until(process, lambda done=number + 1: len(records(term)) >= done)
            assert process.poll() is None
            kill_a_worker(there, number)
        assert process.wait(PATIENCE) == 1, said(term)
    assert "5 graded" in said(term)
    assert snapshot(term, Scene(term, term.parent)) == plain


def test_what_is_lost_with_the_cluster_is_graded_by_the_next_run(new_term, plain):
    term = new_term("lost", CLASS)
    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 0}),
        local_cluster(1) as there,
    ):
        process = start(term, there)
        wait_until(process, lambda: len(records(term)) >= 2)
        kill_a_worker(there)  # what it was at is set aside at once by this scheduler
        wait_until(process, lambda: any(SET_ASIDE in r.read_text() for r in records(term)))
        assert process.poll() is None, said(term)
    assert process.wait(PATIENCE) == 2
    assert "is lost" in said(term)
    assert "run the same command again" in said(term)
    assert "Traceback" not in said(term)
    assert run("course", "grade", ASSIGNMENT, cwd=term).returncode == 1
    assert snapshot(term, Scene(term, term.parent)) == plain


def place_of(dask_worker):
    """Return a worker's ports, processes and folder, and what it knows."""
    addresses = (dask_worker.address, dask_worker.nanny)
    ports = [int(address.rpartition(":")[2]) for address in addresses]
    folder = str(dask_worker.local_directory)
    return ports, [os.getpid(), os.getppid()], folder, os.environ.get("PGPASSWORD")


def test_a_submission_reaches_nothing_of_the_cluster(new_term, submissions):
    term, right = new_term("spied-out", ()), submissions["right"]
    with local_cluster(2, env={"PGPASSWORD": "a-password"}) as there, Client(there) as client:
        places = client.run(place_of).values()
        assert [knows for *_, knows in places] == ["a-password"] * 2
        ports = [port for its_ports, *_ in places for port in its_ports]
        ports += [there.scheduler.port, urlsplit(there.dashboard_link).port]
        processes = [process for _, its_own, *_ in places for process in its_own]
        folders = [folder for _, _, folder, _ in places]
        spy = SPY.format(ports=ports, processes=processes, folders=folders)
        notebook = nbformat.reads(right.content, as_version=4)
        notebook.cells.insert(0, new_code_cell(spy))
        content = nbformat.writes(notebook).encode()
        write_submissions(term, ASSIGNMENT, [replace(right, student="spy", content=content)])
        assert start(term, there).wait(PATIENCE) == 0, said(term)
    graded = nbformat.read(term / f"autograded/spy/{ASSIGNMENT}/{ASSIGNMENT}.ipynb", 4)
    (seen,) = (output.text for output in graded.cells[0].outputs)
    assert seen.count("held") == len(ports) + 4 * len(processes) + 2
    assert "reached" not in seen
    assert "a-password" not in seen
    (record,) = records(term)
    exercises = json.loads(record.read_text())["exercises"]
    earned = {name: found["points"] for name, found in exercises.items()}
    assert earned == {name: right.points[name] for name in earned}


def test_a_worker_without_walls_refuses(new_term, tmp_path):
    term = new_term("no-walls", CLASS[:1])
    with local_cluster(1, env={"PATH": str(tmp_path)}) as there:
        process = start(term, there)
        assert process.wait(PATIENCE) == 2
    assert "1 of 1 workers cannot grade" in said(term)
    assert "bubblewrap is not installed" in said(term)
    assert not records(term)


def test_a_worker_with_another_version_of_the_course_refuses():
    assert why_refuse("none", library_mark()) == ""
    assert why_refuse("none", "another") == DIFFERENT
    with local_cluster(1, processes=False) as there, Client(there) as client:
        (missing,) = client.run(_there("judge_of_next_year"), on_error="return").values()
    assert DIFFERENT in _words(missing)


def test_without_a_scheduler_it_says_so(new_term, monkeypatch, capsys):
    monkeypatch.setattr(cluster, "CONNECT", 0.5)
    term = new_term("nobody-there", CLASS[:1])
    options = ["--term", str(term), "--scheduler", "tcp://127.0.0.1:1"]
    assert main(["grade", ASSIGNMENT, *options]) == 2
    assert "no Dask scheduler answers at tcp://127.0.0.1:1" in capsys.readouterr().err
