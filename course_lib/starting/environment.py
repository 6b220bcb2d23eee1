"""The private environment ``.venv``: where it is, and what its stamp says about it.

The stamp holds one fingerprint for each step of the set-up that is complete; while they fit,
nothing is asked of pip. An environment holds absolute paths and cannot be moved, so the
stamp names its place too.
"""

import hashlib
import json
import os
import sys
import sysconfig
from dataclasses import dataclass
from pathlib import Path

LOCKS = {"run": "requirements.lock", "test": "requirements-test.lock"}
PROJECT = (
    "pyproject.toml",
    "course_lib/starting/lab_settings.json",
    "course_lib/widgets/export_config.json",
    "course_lib/widgets/server_config.json",
)
# What tells pip where packages come from is the user's; what tells it where to put them, ours.
KEPT_PIP = frozenset(
    """CACHE_DIR CERT CLIENT_CERT CONFIG_FILE DEFAULT_TIMEOUT EXTRA_INDEX_URL FIND_LINKS INDEX_URL
    KEYRING_PROVIDER NO_CACHE_DIR NO_INDEX PROXY RETRIES TIMEOUT TRUSTED_HOST USE_FEATURE
    """.split()  # noqa: SIM905 - eighteen words read better than eighteen strings
)


@dataclass(frozen=True)
class Environment:
    """Where the course's private environment lies."""

    root: Path

    @property
    def folder(self) -> Path:
        """The environment itself."""
        return self.root / ".venv"

    @property
    def commands(self) -> Path:
        """The folder of its programs."""
        return self.folder / ("Scripts" if os.name == "nt" else "bin")

    @property
    def python(self) -> Path:
        """Its Python."""
        return self.commands / ("python.exe" if os.name == "nt" else "python")

    @property
    def packages(self) -> Path:
        """The folder of its packages."""
        paths = {"base": str(self.folder), "platbase": str(self.folder)}
        return Path(sysconfig.get_path("purelib", "venv", vars=paths))

    @property
    def stamp(self) -> Path:
        """The file that says which steps are complete."""
        return self.folder / "course.json"

    @property
    def log(self) -> Path:
        """What the programs of the last set-up printed."""
        return self.root / ".venv.log"


def needed(env: Environment) -> dict[str, str]:
    """Return what a complete stamp says: one fingerprint a step."""
    version = f"{sys.implementation.cache_tag} {sysconfig.get_platform()}"
    files = {"run": [LOCKS["run"]], "test": [*LOCKS.values()], "project": [*PROJECT]}
    prints = {step: _fingerprint(env.root, names) for step, names in files.items()}
    return {"place": f"{env.folder} {version}", **prints}


def _fingerprint(root: Path, names: list[str]) -> str:
    digest = hashlib.sha256()
    for path in (root / name for name in names):
        digest.update(path.read_bytes() if path.exists() else b"")
    return digest.hexdigest()


def found(env: Environment) -> dict[str, str]:
    """Return the environment's stamp; empty if it has none that can be used."""
    try:
        stamp = json.loads(env.stamp.read_text("utf-8"))
        return stamp if isinstance(stamp, dict) and _is_alive(env) else {}
    except (OSError, ValueError):
        return {}


def _is_alive(env: Environment) -> bool:
    # The Python that the environment was made with may have been removed or moved since.
    settings = (env.folder / "pyvenv.cfg").read_text("utf-8").splitlines()
    homes = [line.partition("=")[2].strip() for line in settings if line.startswith("home")]
    return env.python.exists() and all(Path(home).exists() for home in homes)


def write_stamp(env: Environment, stamp: dict[str, str]) -> None:
    """Replace the stamp in one stroke."""
    new = env.stamp.with_suffix(".new")
    new.write_text(json.dumps(stamp, indent=1), "utf-8")
    new.replace(env.stamp)


def is_foreign(env: Environment) -> bool:
    """Return whether a folder lies in the environment's place that the set-up did not make."""
    return env.folder.exists() and any(env.folder.iterdir()) and not env.stamp.exists()


def steps_to(wanted: str, stamp: dict[str, str], need: dict[str, str]) -> list[str]:
    """Return the steps that are left until the environment is complete.

    Parameters
    ----------
    wanted : {"run", "test"}
        "test" needs all that "run" does, and more.
    stamp, need : dict
        What `found` and `needed` say.

    Returns
    -------
    list of str
        In order, out of "create", "run" or "test" (packages), "project".
    """
    fits = {key for key, value in need.items() if stamp.get(key) == value}
    if not {"place", "run"} <= fits:
        return ["create", wanted, "project"]
    # The tests' lock file pins the same versions and adds some: no package need be taken out.
    steps = [wanted] if wanted == "test" and "test" not in fits else []
    return steps if "project" in fits else [*steps, "project"]


def variables(env: Environment) -> dict[str, str]:
    """Return the environment variables for all that runs in the environment.

    Another Python's paths (of ROS, of an active conda) would mix its packages with ours.
    """
    foreign = {"PYTHONPATH", "PYTHONHOME", "__PYVENV_LAUNCHER__"}
    kept = {
        name: value
        for name, value in os.environ.items()
        if name not in foreign
        and (not name.startswith("PIP_") or name.removeprefix("PIP_") in KEPT_PIP)
    }
    ours = {"PIP_USER": "0", "PYTHONUTF8": "1", "PYTHONUNBUFFERED": "1"}
    path = os.pathsep.join([str(env.commands), os.environ.get("PATH", os.defpath)])
    return kept | ours | {"VIRTUAL_ENV": str(env.folder), "PATH": path}
