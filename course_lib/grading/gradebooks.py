"""Where a term's gradebook is: a file of SQLite, or a database of PostgreSQL by its URL."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from sqlalchemy.engine import URL, make_url
from sqlalchemy.exc import ArgumentError, DBAPIError

DRIVER = "postgresql+psycopg"
EXAMPLE = "postgresql://USER@HOST/DATABASE"


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
def reachable() -> Iterator[None]:
    """Say in a sentence what is wrong where a gradebook does not do what it should.

    Raises
    ------
    RuntimeError
        If it does not answer, or refuses; what was recorded before stays.
    """
    try:
        yield
    except DBAPIError as error:
        said = " ".join(str(error.orig).split())[:300].rstrip(".?")
        raise RuntimeError(
            f"the gradebook does not do what it should: {said}. What is recorded stays; when it "
            "answers again, the same command goes on"
        ) from None
    except ModuleNotFoundError as error:
        if error.name != "psycopg":
            raise
        _demand_driver()
