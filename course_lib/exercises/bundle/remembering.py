"""Remember what wrong answers have in common: a judge tries all of them on the same inputs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

#: How many results are kept before all are forgotten.
MANY = 3000


def once(
    compute: Callable[..., Any],
    *parts: Any,
    known: dict[bytes, Any] = {},  # noqa: B006 - the memory, by function and inputs; pasted empty
) -> Any:
    """Return what a function gives, from memory if it was asked before; nobody may change it."""
    name = f"{compute.__module__}.{compute.__qualname__}"
    key = b"|".join([name.encode(), *(np.asarray(part).tobytes() for part in parts)])
    if key not in known:
        if len(known) >= MANY:
            known.clear()
        known[key] = compute(*parts)
    return known[key]
