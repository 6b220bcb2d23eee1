"""Is everything here that the course needs? One readable verdict per package."""

from __future__ import annotations

import importlib
import platform
from collections.abc import Iterable
from dataclasses import dataclass
from html import escape
from importlib import metadata

from packaging.requirements import Requirement

from course_lib.display import show_block

DISTRIBUTION = "camera-course"
#: Packages that hold compiled code: seeing them installed is not enough, they must load.
COMPILED = {
    "numpy": "numpy",
    "opencv-python-headless": "cv2",
    "matplotlib": "matplotlib",
    "scikit-image": "skimage",
    "scipy": "scipy",
}


@dataclass(frozen=True)
class PackageVerdict:
    """One package: what was needed, what was found, and what to do if they differ."""

    name: str
    needed: str
    found: str
    advice: str = ""

    @property
    def fine(self) -> bool:
        """Whether the package can be used."""
        return not self.advice


def package_verdict(requirement: Requirement) -> PackageVerdict:
    """Judge one package.

    Parameters
    ----------
    requirement : packaging.requirements.Requirement
        Name and versions that are needed.

    Returns
    -------
    PackageVerdict
        With advice where it is missing, too old, or does not load.
    """
    name, needed = requirement.name, str(requirement.specifier)
    try:
        found = metadata.version(name)
    except metadata.PackageNotFoundError:
        return PackageVerdict(name, needed, "not found", "is missing: start the course again")
    if not requirement.specifier.contains(found, prereleases=True):
        return PackageVerdict(name, needed, found, "is another version: start the course again")
    try:
        importlib.import_module(COMPILED.get(name, "sys"))
    except Exception as error:  # a broken package can raise anything while it loads
        return PackageVerdict(name, needed, found, f"does not load ({error})")
    return PackageVerdict(name, needed, found)


def needed_packages() -> list[Requirement]:
    """Return what the course says it needs, without what only its tests need."""
    stated = map(Requirement, metadata.requires(DISTRIBUTION) or [])
    return [one for one in stated if one.marker is None or one.marker.evaluate({"extra": ""})]


def check_environment() -> None:
    """Show whether Python and each package of the course are here and load."""
    verdicts = [package_verdict(requirement) for requirement in needed_packages()]
    show_block(_html(verdicts), _text(verdicts))


def _headline(verdicts: Iterable[PackageVerdict]) -> str:
    wrong = [verdict for verdict in verdicts if not verdict.fine]
    python = f"Python {platform.python_version()}"
    if not wrong:
        return f"Everything is here: {python} and all packages."
    names = ", ".join(verdict.name for verdict in wrong)
    return f"{python} is here, but {names} must be mended: close Lab and run `python3 start.py`."


def _text(verdicts: list[PackageVerdict]) -> str:
    lines = [
        f"  {'✓' if v.fine else '✗'} {v.name} {v.found} (needed {v.needed or 'any'}) {v.advice}"
        for v in verdicts
    ]
    return "\n".join([_headline(verdicts), *(line.rstrip() for line in lines)])


def _html(verdicts: list[PackageVerdict]) -> str:
    rows = "".join(
        f"<tr><td>{'✓' if v.fine else '✗'}</td><td style='text-align:left'>{escape(v.name)}</td>"
        f"<td>{escape(v.found)}</td><td>{escape(v.needed or 'any')}</td>"
        f"<td style='text-align:left'>{escape(v.advice or 'fine')}</td></tr>"
        for v in verdicts
    )
    head = "<tr><th></th><th>package</th><th>found</th><th>needed</th><th>verdict</th></tr>"
    return f"<p><b>{escape(_headline(verdicts))}</b></p><table>{head}{rows}</table>"
