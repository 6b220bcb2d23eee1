import asyncio
import json
import logging
import socket
from pathlib import Path

from tornado.httpserver import HTTPServer
from tornado.testing import bind_unused_port
from tornado.web import Application
from tornado.websocket import WebSocketHandler, websocket_connect

import course_lib.widgets.server as server


def no_delay(handler_class):
    """Open a WebSocket to `handler_class`; return TCP_NODELAY of the server's socket."""

    async def visit():
        listening, port = bind_unused_port()
        http = HTTPServer(Application([("/", handler_class)]))
        http.add_socket(listening)
        connection = await websocket_connect(f"ws://127.0.0.1:{port}/")
        option = await connection.read_message()
        connection.close()
        http.stop()
        await http.close_all_connections()
        return int(option)

    return asyncio.run(visit())


def greeting_handler():
    class Greeting(WebSocketHandler):
        def open(self):
            option = self.ws_connection.stream.socket.getsockopt(
                socket.IPPROTO_TCP, socket.TCP_NODELAY
            )
            self.write_message(str(option))

    return Greeting


def test_a_socket_sends_at_once():
    handler = greeting_handler()
    assert no_delay(handler) == 0
    server.send_at_once(handler)
    assert no_delay(handler) != 0


def test_a_class_is_changed_once():
    handler = greeting_handler()
    server.send_at_once(handler)
    changed = handler.open
    server.send_at_once(handler)
    assert handler.open is changed


def test_a_socket_that_cannot_is_opened_all_the_same(caplog):
    class Stubborn(greeting_handler()):
        def set_nodelay(self, value):
            raise OSError("not this socket")

    server.send_at_once(Stubborn)
    assert no_delay(Stubborn) == 0
    assert "not this socket" in caplog.text


class Application_:
    log = logging.getLogger("test server")


def test_the_extension_says_what_it_does(caplog):
    caplog.set_level(logging.INFO)
    server._load_jupyter_server_extension(Application_())
    assert "TCP_NODELAY is on" in caplog.text
    from jupyter_server.services.kernels.websocket import KernelWebsocketHandler

    assert getattr(KernelWebsocketHandler.open, server._MARK)


def test_the_extension_never_stops_the_server(caplog, monkeypatch):
    monkeypatch.setattr("jupyter_server.services.kernels.websocket.KernelWebsocketHandler", object)
    server._load_jupyter_server_extension(Application_())
    assert "could not switch on TCP_NODELAY" in caplog.text


def test_jupyter_finds_the_extension():
    (point,) = server._jupyter_server_extension_points()
    config = json.loads(Path(server.__file__).with_name("server_config.json").read_text())
    assert config["ServerApp"]["jpserver_extensions"] == {point["module"]: True}
