"""What grading a class has left behind, as far as it must be the same each time."""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from benchmarks.grading import ASSIGNMENT, ROOT
from benchmarks.scenes import Scene, records


def snapshot(term: Path, scene: Scene) -> dict[str, Any]:
    """Return everything that must be the same: gradebook, graded notebooks, records."""
    found: dict[str, Any] = {}
    for path in sorted((term / "autograded").rglob("*")):
        if path.is_file():
            found[str(path.relative_to(term))] = hashlib.sha256(path.read_bytes()).hexdigest()
    for path in records(term):
        found[str(path.relative_to(term))] = without_seconds(json.loads(path.read_text()))
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.snapshots", str(term)],
        cwd=ROOT,
        env=scene.environment(),
        check=True,
        capture_output=True,
        text=True,
    )
    return found | json.loads(done.stdout)


def without_seconds(record: Any) -> Any:
    """Return a record without what differs from one run to the next."""
    if isinstance(record, dict):
        return {k: without_seconds(v) for k, v in record.items() if k != "seconds"}
    return record


def print_gradebook(term: str) -> None:
    """Print all rows of a term's gradebook, by student and cell, and how many there are."""
    from nbgrader.api import Base, Gradebook
    from sqlalchemy import func, select

    from course_lib.grading.assignment import read_assignment

    assignment = read_assignment(Path(term), ASSIGNMENT)
    rows: dict[str, Any] = {}
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        for submission in gradebook.assignment_submissions(ASSIGNMENT):
            who = submission.student.id
            rows[who] = [str(submission.timestamp), submission.score]
            for notebook in submission.notebooks:
                rows[f"{who} {notebook.name}"] = notebook.late_submission_penalty
                for g in notebook.grades:
                    row = [g.auto_score, g.manual_score, g.extra_credit, g.needs_manual_grade]
                    rows[f"{who} grade {g.name}"] = row
                for c in notebook.comments:
                    rows[f"{who} comment {c.name}"] = [c.auto_comment, c.manual_comment]
        for table in Base.metadata.sorted_tables:
            number = gradebook.db.execute(select(func.count()).select_from(table)).scalar()
            rows[f"rows of {table.name}"] = number
    print(json.dumps(rows))


if __name__ == "__main__":
    print_gradebook(sys.argv[1])
