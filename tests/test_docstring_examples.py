"""Every example in a docstring gives what it says."""

import doctest
import importlib
import importlib.util
import pkgutil

import pytest

import course_lib
import data_generators

EXAMPLE = "\n    >>> "


def with_examples() -> list[str]:
    """Name every module that shows an example."""
    found = []
    for package in (course_lib, data_generators):
        for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            spec = importlib.util.find_spec(module.name)
            loader = spec.loader if spec else None
            if loader and EXAMPLE in (loader.get_source(module.name) or ""):
                found.append(module.name)
    return found


@pytest.mark.parametrize("name", with_examples())
def test_the_examples_of_docstrings_run(name: str) -> None:
    tested = doctest.testmod(importlib.import_module(name))
    assert tested.attempted > 0, "an example that nobody finds"
    assert tested.failed == 0
