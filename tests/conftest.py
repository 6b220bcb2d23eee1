"""Share the tests out to the workers: a file stays together, but every chapter's exercises part."""

import pytest


@pytest.hookimpl(tryfirst=True)  # before the workers read the groups
def pytest_collection_modifyitems(config, items):
    for item in items:
        exercise = item.callspec.params.get("exercise") if hasattr(item, "callspec") else None
        file = item.path.relative_to(config.rootpath).as_posix()
        group = f"{file} {getattr(exercise, 'chapter', '')}".strip()
        item.add_marker(pytest.mark.xdist_group(group))
