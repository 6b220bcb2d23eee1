"""Where a term's gradebook is: a file of SQLite, or a database of PostgreSQL by its URL."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from logging import LogRecord

from nbgrader.api import Base, Gradebook, InvalidEntry
from sqlalchemy import create_engine, func, inspect, select
from sqlalchemy.engine import URL, Engine, make_url
from sqlalchemy.exc import ArgumentError, DBAPIError
from sqlalchemy.pool import NullPool
from tornado.log import app_log

DRIVER = "postgresql+psycopg"
EXAMPLE = "postgresql://USER@HOST/DATABASE"
#: The number of the lock that says who writes scores, among the locks of one database.
LOCK = 0x63616D657261
UPGRADE = "It was made by another nbgrader: make a copy of it, then run nbgrader db upgrade"
#: When the server looks whether a silent client is still there, in seconds; then, how often.
KEEP_ALIVE = {
    "tcp_keepalives_idle": "60",
    "tcp_keepalives_interval": "10",
    "tcp_keepalives_count": "6",
}
#: What to do, by words of SQLite and PostgreSQL.
ADVICE = {
    "file is not a database": "Put your copy of gradebook.db into its place",
    "database is locked": "Another program writes into it, and should be ended first",
    "no such column": UPGRADE,
    "UndefinedColumn": UPGRADE,
}


def gradebook_url(typed: str) -> str:
    """Return the URL that nbgrader needs for a database of PostgreSQL.

    Parameters
    ----------
    typed : str
        E.g. ``postgresql://teacher@db.example.org/camera_2026``.

    Returns
    -------
    str
        The same with the driver's name.

    Raises
    ------
    ValueError
        If it is no such URL, a password is in it, or there is no driver.
    """
    try:
        url = make_url(typed)
    except ArgumentError:
        raise ValueError(f"a gradebook's URL is like {EXAMPLE}, not {typed!r}") from None
    if url.get_backend_name() not in ("postgresql", "postgres"):
        raise ValueError(
            f"a gradebook's URL is like {EXAMPLE}, not {hidden(url)}; without one, the gradebook "
            "is a file of SQLite in the term's directory"
        )
    if not url.database:
        raise ValueError(f"{hidden(url)} names no database: {EXAMPLE}")
    if url.password is not None or "password" in url.query:
        raise ValueError(
            "leave the password out of the URL, since it would be written into a file: PostgreSQL "
            "takes it from ~/.pgpass (HOST:PORT:DATABASE:USER:PASSWORD, chmod 600) or PGPASSWORD"
        )
    _demand_driver()
    return url.set(drivername=DRIVER).render_as_string()


def hidden(url: URL | str) -> str:
    """Return a URL as it can be shown to anybody."""
    return make_url(url).render_as_string(hide_password=True)


def _demand_driver() -> None:
    try:
        import psycopg
    except ImportError:
        raise ValueError(
            "a gradebook on PostgreSQL needs its driver here: pip install 'psycopg[binary]'"
        ) from None
    del psycopg


@contextmanager
def open_gradebook(db_url: str, course_id: str) -> Iterator[Gradebook]:
    """Open a gradebook, and close it; what is wrong with it is said in a sentence.

    Parameters
    ----------
    db_url : str
        As in ``nbgrader_config.py``.
    course_id : str
        nbgrader's name for the course.

    Yields
    ------
    nbgrader.api.Gradebook
        Made if there is none yet.

    Raises
    ------
    ValueError
        If the URL cannot be used, or leads to a database that holds something else.
    RuntimeError
        If the database does not answer, or refuses; what was recorded before stays.
    """
    with _reachable(db_url), _without_traces():
        _demand_gradebook(db_url)
        with Gradebook(db_url, course_id) as gradebook:
            yield gradebook


def _demand_gradebook(db_url: str) -> None:
    """Make sure that a database is empty or a gradebook: nbgrader would put its tables into any."""
    engine = _engine(db_url)
    try:
        found = inspect(engine).get_table_names()
    finally:
        engine.dispose()
    if found and not {*found} & {*Base.metadata.tables}:
        some = ", ".join(sorted(found)[:5])
        raise ValueError(
            f"{hidden(db_url)} is no gradebook: it holds {some} and nothing of nbgrader's. Let "
            "CourseDirectory.db_url in nbgrader_config.py name the term's own database, or an "
            "empty one"
        )


def _engine(db_url: str) -> Engine:
    """Prepare the way to a database, on which nothing is kept open."""
    try:
        return create_engine(db_url, poolclass=NullPool, pool_reset_on_return=None)
    except ArgumentError as error:
        setting = "CourseDirectory.db_url in nbgrader_config.py"
        raise ValueError(f"{setting} is no URL of a database that can be used: {error}") from None
    except ModuleNotFoundError as error:
        if error.name == "psycopg":
            _demand_driver()
        raise ValueError(
            f"{hidden(db_url)} needs the driver {error.name}, which is not installed; for "
            f"PostgreSQL the gradebook's URL in nbgrader_config.py begins with {DRIVER}://"
        ) from None


@contextmanager
def only_writer(db_url: str) -> Iterator[None]:
    """Make sure that nobody else writes scores into a database of PostgreSQL.

    Two copies of a term's directory may share one. The lock is the connection's, so it ends with
    this process, or some minutes after its machine is gone. A file of SQLite lies in the directory,
    which has a lock of its own.

    Raises
    ------
    RuntimeError
        If somebody does.
    """
    engine = _engine(db_url)
    if engine.dialect.name != "postgresql":
        yield
        return
    with (
        _reachable(db_url),
        engine.connect().execution_options(isolation_level="AUTOCOMMIT") as connection,
    ):
        for setting, seconds in KEEP_ALIVE.items():
            connection.execute(select(func.set_config(setting, seconds, False)))
        if not connection.scalar(select(func.pg_try_advisory_lock(LOCK))):
            raise RuntimeError(
                "another `course grade` is at work with the gradebook of this term, in another "
                "folder or on another machine; wait until it has ended"
            )
        yield


@contextmanager
def _reachable(db_url: str) -> Iterator[None]:
    """Say in a sentence what is wrong where a database does not do what it should."""
    try:
        yield
    except (DBAPIError, InvalidEntry) as error:
        first = error if isinstance(error, DBAPIError) else error.__context__
        if not isinstance(first, DBAPIError):
            raise
        said = " ".join(str(first.orig).split())[:300].rstrip(".?")
        advice = _advice(f"{type(first.orig).__name__}: {said}", db_url)
        raise RuntimeError(
            f"the gradebook does not do what it should: {said}. {advice}. What is recorded stays, "
            "and the same command goes on"
        ) from None


def _advice(said: str, db_url: str) -> str:
    """Return what to do, by what a database said."""
    known = next((advice for words, advice in ADVICE.items() if words in said), "")
    url = make_url(db_url)
    if known or url.get_backend_name() == "sqlite":
        return known or f"Look after {url.database}"
    return (
        f"Look whether the server of {hidden(url)} runs, whether it has this database, and "
        "whether the password is in ~/.pgpass"
    )


@contextmanager
def _without_traces() -> Iterator[None]:
    """Keep nbgrader from printing a stack trace where a database refuses; a sentence follows."""

    def is_wanted(record: LogRecord) -> bool:
        return not str(record.msg).startswith("Rolling back session due to database error")

    app_log.addFilter(is_wanted)
    try:
        yield
    finally:
        app_log.removeFilter(is_wanted)
