"""A PostgreSQL server of one's own, in a temporary folder, for as long as it is needed."""

from __future__ import annotations

import glob
import os
import pwd
import secrets
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from tests.browser.lab import free_port

OWNER = "teacher"
#: Who runs the server where root starts it: PostgreSQL refuses root. Debian's package makes it.
SYSTEM_USER = "postgres"
#: A server that is thrown away need not survive a power cut.
SETTINGS = ("fsync=off", "listen_addresses=127.0.0.1", "unix_socket_directories=", "jit=off")


class NoServerError(RuntimeError):
    """There is no PostgreSQL server here, or it does not start."""


@dataclass(frozen=True)
class Server:
    """A server that runs, and what a program needs in its environment to enter."""

    port: int
    environment: dict[str, str]

    def make_database(self, name: str, template: str = "template0") -> str:
        """Make a database, empty or a copy; return its URL, in which there is no password."""
        where = ["--host=127.0.0.1", f"--port={self.port}", f"--username={OWNER}"]
        command = [_program("createdb"), *where, f"--template={template}", name]
        subprocess.run(command, env=os.environ | self.environment, check=True)
        return f"postgresql://{OWNER}@127.0.0.1:{self.port}/{name}"


@contextmanager
def postgres_server() -> Iterator[Server]:
    """Start a server that asks for a password; stop it and remove all of it afterwards.

    Raises
    ------
    NoServerError
        If PostgreSQL is not installed (Debian: ``apt install postgresql``), or does not start.
    """
    folder = Path(tempfile.mkdtemp(prefix="postgres-"))
    try:
        password = folder / "password"
        password.write_text(secrets.token_hex(16) + "\n")
        if os.getuid() == 0:
            owner = pwd.getpwnam(SYSTEM_USER)
            for path in (folder, password):
                os.chown(path, owner.pw_uid, owner.pw_gid)
        options = [f"--username={OWNER}", f"--pwfile={password}", "--auth=scram-sha-256"]
        _run([_program("initdb"), "-D", f"{folder}/data", *options, "-E", "UTF8", "--no-sync"])
        port = free_port()
        entry = f"127.0.0.1:{port}:*:{OWNER}:{password.read_text()}"
        with tempfile.NamedTemporaryFile("w", prefix="pgpass-") as passes:  # 0600, and ours
            passes.write(entry)
            passes.flush()
            with _started(folder, port):
                yield Server(port, {"PGPASSFILE": passes.name})
    finally:
        shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def _started(folder: Path, port: int) -> Iterator[None]:
    settings = [word for setting in (*SETTINGS, f"port={port}") for word in ("-c", setting)]
    command = [_program("postgres"), "-D", f"{folder}/data", *settings]
    log = folder / "log"
    with log.open("w") as file:
        process = subprocess.Popen(command, stdout=file, stderr=file, **_as_owner())
    try:
        deadline = time.monotonic() + 60
        asks = [_program("pg_isready"), "--quiet", "--host=127.0.0.1", f"--port={port}"]
        while subprocess.run(asks, check=False).returncode:
            if process.poll() is not None or time.monotonic() > deadline:
                raise NoServerError(f"PostgreSQL does not start: {log.read_text()[-500:]}")
            time.sleep(0.05)
        yield
    finally:
        process.terminate()
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


def _program(name: str) -> str:
    """Return where one of PostgreSQL's programs is: Debian keeps the server's off the path."""
    versions = sorted(glob.glob(f"/usr/lib/postgresql/*/bin/{name}"))
    found = versions[-1] if versions else shutil.which(name)
    if not found:
        raise NoServerError(f"{name} of PostgreSQL is not installed (apt install postgresql)")
    return found


def _as_owner() -> dict:
    own = {"user": SYSTEM_USER, "group": SYSTEM_USER, "extra_groups": []}
    return {"cwd": "/", **(own if os.getuid() == 0 else {})}


def _run(command: list[str]) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False, **_as_owner())
    if done.returncode:
        raise NoServerError(f"{command[0]} failed: {done.stderr[-500:]}")
