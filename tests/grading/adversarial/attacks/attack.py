"""One attack: what a student types, and what that must get.

The notebook asks for `dolly_zoom` and then for `pixel_focal_length`. An attack is typed into a cell
before the first, or into its answer; the second is answered rightly.
"""

from dataclasses import dataclass

SIGNATURE = "def dolly_zoom(focal_length, distance, new_distance):"
WRONG = f"{SIGNATURE}\n    return 1.0"
RIGHT = f"{SIGNATURE}\n    return focal_length * new_distance / distance"


@dataclass(frozen=True)
class Attack:
    """One submission.

    Attributes
    ----------
    cell : str
        A cell of the student's own, at the top.
    answer : str
        The first answer.
    first, second : float
        What the answers must earn; None where it depends on the moment.
    says : str
        What an output or a verdict must hold.
    """

    cell: str = ""
    answer: str = WRONG
    first: float = 0.0
    second: float | None = 4.0
    says: str = ""


def body(*lines: str) -> str:
    return "\n".join([SIGNATURE, *(f"    {line}" for line in lines)])


def returns(value: str) -> Attack:
    return Attack(answer=body(f"return {value}"))
