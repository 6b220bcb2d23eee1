"""Share the tests out to the workers: a file stays together, but every chapter's exercises part."""

from course_lib.exercises import CHAPTERS


def pytest_xdist_make_scheduler(config, log):
    from xdist.scheduler import LoadScopeScheduling

    class ByFileAndChapter(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            file, _, test = nodeid.partition("::")
            here = file.startswith("tests/exercises")
            chapters = [name for name in CHAPTERS if here and f"{name}." in test]
            return " ".join([file, *chapters])

    return ByFileAndChapter(config, log)
