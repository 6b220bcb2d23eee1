"""The catalogue of what a submission may try: each with what it must get."""

from attacks.attack import RIGHT, Attack
from attacks.forgeries import FORGERIES
from attacks.hunger import MEMORY, SPACE, TIME
from attacks.later import LATER_FORGERIES, LATER_HARM, LATER_LEAKS, LATER_OUTSIDE
from attacks.leaks import LEAKS
from attacks.outside import OUTSIDE
from attacks.processes import PROCESSES
from attacks.values import VALUES

FORGERIES |= LATER_FORGERIES
LEAKS |= LATER_LEAKS
OUTSIDE |= LATER_OUTSIDE
#: Harm to the machine, the grader or others.
HARM = PROCESSES | MEMORY | SPACE | TIME | LATER_HARM

__all__ = ["FORGERIES", "HARM", "LEAKS", "OUTSIDE", "RIGHT", "VALUES", "Attack"]
