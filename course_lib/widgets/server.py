"""Jupyter server extension: send widget messages at once.

Jupyter's server leaves Nagle's algorithm on for the socket between kernel and browser. Small
messages then wait for the acknowledgement of the one before, and a slider feels slow. The
extension switches it off (TCP_NODELAY) when such a socket opens, and changes nothing else.
"""

from __future__ import annotations

import logging
from functools import wraps
from typing import Any

_MARK = "_course_sends_at_once"


def _jupyter_server_extension_points() -> list[dict[str, str]]:
    """Tell Jupyter where the extension is."""
    return [{"module": "course_lib.widgets.server"}]


def _load_jupyter_server_extension(server: Any) -> None:
    """Change the server's kernel sockets; when that fails, say so and go on."""
    try:
        from jupyter_server.services.kernels.websocket import KernelWebsocketHandler

        send_at_once(KernelWebsocketHandler)
    except Exception as error:  # a slower slider is no reason for Jupyter not to start
        server.log.warning(
            f"course_lib: could not switch on TCP_NODELAY; explorers will be slower ({error!r})"
        )
    else:
        server.log.info("course_lib: TCP_NODELAY is on for the sockets of kernels")


def send_at_once(handler: type[Any]) -> None:
    """Make every WebSocket of a handler class set TCP_NODELAY when it opens.

    Parameters
    ----------
    handler : type
        A subclass of `tornado.websocket.WebSocketHandler`; changed in place, once.
    """
    opened = handler.open
    if getattr(opened, _MARK, False):
        return

    @wraps(opened)
    def open_at_once(self: Any, *args: Any, **kwargs: Any) -> Any:
        try:
            self.set_nodelay(True)
        except Exception as error:  # the socket works all the same
            logging.getLogger(__name__).warning("TCP_NODELAY not set: %r", error)
        return opened(self, *args, **kwargs)

    setattr(open_at_once, _MARK, True)
    handler.open = open_at_once
