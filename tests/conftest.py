"""Share the tests out to the workers: a file stays together, but every chapter's exercises part.

What lessons and drawings compute for a chapter, as a reconstruction, is kept while a worker runs:
their tests of a chapter stay together, whatever the file.
"""

import re

from course_lib.exercises import CHAPTERS


def pytest_xdist_make_scheduler(config, log):
    from xdist.scheduler import LoadScopeScheduling

    class ByFileAndChapter(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            file, _, test = nodeid.partition("::")
            kept = file.startswith(("tests/drawing", "tests/lessons"))
            if kept and file != "tests/lessons/test_lessons.py":  # whose kernels keep nothing
                named = (name for part in (file, test) for name in CHAPTERS if name in part)
                return next(named, file)
            here = file.startswith(("tests/exercises", "tests/lessons"))
            chapters = [name for name in CHAPTERS if here and re.search(rf"{name}[.\]]", test)]
            return " ".join([file, *chapters])

    return ByFileAndChapter(config, log)
