"""A real JupyterLab and a real Chromium, for the browser tests and the benchmarks."""

from __future__ import annotations

import os
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import nbformat

ROOT = Path(__file__).resolve().parents[2]
CHROMIUM_FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
QUIET = """{
  "@jupyterlab/apputils-extension:notification": {"fetchNews": "false", "checkForUpdates": false},
  "@jupyterlab/apputils-extension:themes": {"theme": "JupyterLab %s"}
}"""


def chromium() -> str | None:
    """Return the path of Chromium: ``$COURSE_CHROMIUM``, Debian's, or one on the path."""
    places = [os.environ.get("COURSE_CHROMIUM", ""), "/usr/bin/chromium"]
    places += [
        shutil.which(name) or "" for name in ("chromium", "chromium-browser", "google-chrome")
    ]
    return next((place for place in places if place and Path(place).is_file()), None)


class Lab:
    """A JupyterLab server on a free port that serves `folder`; stop it with :meth:`stop`.

    Parameters
    ----------
    folder : Path
        Where its notebooks are.
    home : Path
        Empty directory for its configuration, run-time files and log.
    theme : str
        ``"Light"`` or ``"Dark"``.
    options : sequence of str
        More command-line options for ``jupyter lab``.
    """

    def __init__(
        self, folder: Path, home: Path, theme: str = "Light", options: tuple[str, ...] = ()
    ) -> None:
        self.folder, self.log = folder, home / "lab.log"
        self.port, self.token = free_port(), secrets.token_hex(16)
        self.url = f"http://127.0.0.1:{self.port}"
        settings = home / "app" / "settings"
        config = home / "config" / "labconfig"
        for directory in (settings, config):
            directory.mkdir(parents=True)
        (config / "default_setting_overrides.json").write_text(QUIET % theme)
        command = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root"]
        command += ["--expose-app-in-browser", f"--port={self.port}", "--ServerApp.port_retries=0"]
        command += [f"--IdentityProvider.token={self.token}", f"--notebook-dir={folder}", *options]
        with self.log.open("w") as log:
            self.process = subprocess.Popen(
                command, cwd=folder, env=_environment(home), stdout=log, stderr=log, text=True
            )
        self._wait()

    def _wait(self, seconds: float = 90) -> None:
        """Wait until the server answers; raise with its log if it does not."""
        end = time.monotonic() + seconds
        while time.monotonic() < end and self.process.poll() is None:
            try:
                urllib.request.urlopen(f"{self.url}/api?token={self.token}", timeout=5).close()
                return
            except (urllib.error.URLError, OSError):
                time.sleep(0.1)
        self.stop()
        raise RuntimeError(f"JupyterLab did not start; its log:\n{self.log.read_text()[-3000:]}")

    def stop(self) -> None:
        """Shut the server and its kernels down."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            try:
                self.process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()


def free_port() -> int:
    """Return a port nobody listens on."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def _environment(home: Path) -> dict[str, str]:
    """Return the server's environment: its own directories, no tuning of the BLAS."""
    dropped = {"OPENBLAS_CORETYPE", "OPENBLAS_L2_SIZE"}
    kept = {k: v for k, v in os.environ.items() if k not in dropped and not k.startswith("JUPYTER")}
    return kept | {
        "JUPYTER_CONFIG_DIR": str(home / "config"),
        "JUPYTER_DATA_DIR": str(home / "data"),
        "JUPYTER_RUNTIME_DIR": str(home / "runtime"),
        "JUPYTERLAB_SETTINGS_DIR": str(home / "app" / "settings"),
        "JUPYTERLAB_WORKSPACES_DIR": str(home / "app" / "workspaces"),
        "IPYTHONDIR": str(home / "ipython"),
        "PYTHONPATH": os.pathsep.join([str(ROOT), os.environ.get("PYTHONPATH", "")]).rstrip(":"),
    }


@contextmanager
def browser(*flags: str) -> Iterator[Any]:
    """Start Chromium, with further flags if there are any; yield Playwright's browser."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        program = playwright.chromium.launch(
            executable_path=chromium(), args=[*CHROMIUM_FLAGS, *flags]
        )
        try:
            yield program
        finally:
            program.close()


def write_notebook(path: Path, *cells: str) -> Path:
    """Write a notebook with code cells; return its path."""
    book = nbformat.v4.new_notebook(
        cells=[nbformat.v4.new_code_cell(cell) for cell in cells],
        metadata={
            "kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}
        },
    )
    path.parent.mkdir(parents=True, exist_ok=True)
    nbformat.write(book, path)
    return path


SHOWN = """() => {
  const app = window.jupyterapp;
  return Boolean(app?.shell.currentWidget?.sessionContext)
    && app.commands.hasCommand("notebook:run-all-cells");
}"""

READY = """async () => {
  const panel = window.jupyterapp.shell.currentWidget;
  await panel.context.ready;
  await panel.sessionContext.ready;
}"""

RUN_ALL = """async () => {
  const panel = window.jupyterapp.shell.currentWidget;
  await window.jupyterapp.commands.execute("notebook:run-all-cells");
  return panel.content.widgets
    .flatMap((cell) => (cell.model.type === "code" ? cell.model.outputs.toJSON() : []))
    .filter((output) => output.output_type === "error")
    .map((output) => `${output.ename}: ${output.evalue}`);
}"""


def open_notebook(page: Any, lab: Lab, path: Path) -> None:
    """Open a notebook of the lab's folder in a page and wait until its kernel is ready.

    A page that does not come is loaded once more, as a person would. Raises RuntimeError with what
    the page shows, and with the end of the server's log, if it does not come then either.
    """
    from playwright.sync_api import TimeoutError as TookTooLong

    place = path.relative_to(lab.folder).as_posix()
    for _ in range(2):
        page.goto(f"{lab.url}/lab/tree/{place}?token={lab.token}&reset")
        try:
            page.wait_for_function(SHOWN, timeout=60_000)
        except TookTooLong:
            continue
        page.evaluate(READY)
        return
    shown = page.evaluate("document.body.innerText")
    raise RuntimeError(
        f"JupyterLab does not show {place}. The page, {page.url}, says:\n{shown[:1000]}\n"
        f"The server's log ends with:\n{lab.log.read_text()[-3000:]}"
    )


def run_all_cells(page: Any) -> list[str]:
    """Run every cell of the open notebook; return the errors its cells ended with."""
    return list(page.evaluate(RUN_ALL))
