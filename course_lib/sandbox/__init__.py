"""What runs behind the walls while submissions are graded: a server, a notebook, its answers.

Nothing here knows references, seeds or verdicts; the grader (`course_lib.grading`) keeps those in
its own process and talks to this one in plain values (`wire`).
"""
