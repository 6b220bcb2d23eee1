"""The socket between kernel and browser, looked at from inside the running server."""

import ctypes
import os
import socket
import sys

import pytest
from lab import Lab, open_notebook, run_all_cells, write_notebook

pytestmark = pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="only Linux lends a process's sockets"
)
PIDFD_GETFD = 438  # the same number on every architecture
OFF = '--ServerApp.jpserver_extensions={"course_lib.widgets.server": False}'


def borrowed_sockets(pid):
    """Yield duplicates of the TCP sockets that another process holds."""
    process = os.pidfd_open(pid)
    try:
        for name in os.listdir(f"/proc/{pid}/fd"):
            try:
                if not os.readlink(f"/proc/{pid}/fd/{name}").startswith("socket:"):
                    continue
            except FileNotFoundError:  # closed since it was listed
                continue
            copy = ctypes.CDLL(None, use_errno=True).syscall(PIDFD_GETFD, process, int(name), 0)
            if copy < 0:
                pytest.skip(f"the kernel does not lend sockets: {os.strerror(ctypes.get_errno())}")
            with socket.socket(fileno=copy) as borrowed:
                if borrowed.family == socket.AF_INET and borrowed.type == socket.SOCK_STREAM:
                    yield borrowed
    finally:
        os.close(process)


def sockets_that_send_at_once(lab):
    """Return how many connections of the lab's own port have TCP_NODELAY."""
    count = 0
    for borrowed in borrowed_sockets(lab.process.pid):
        accepted = not borrowed.getsockopt(socket.SOL_SOCKET, socket.SO_ACCEPTCONN)
        if accepted and borrowed.getsockname()[1] == lab.port:
            count += borrowed.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY) != 0
    return count


def connect(lab, chrome):
    """Run a notebook, so that the browser talks to a kernel."""
    path = write_notebook(lab.folder / "socket.ipynb", "1 + 1")
    page = chrome.new_page()
    open_notebook(page, lab, path)
    assert run_all_cells(page) == []
    return page


def test_the_extension_is_on_when_the_course_is_installed(lab, chrome):
    page = connect(lab, chrome)
    assert sockets_that_send_at_once(lab) >= 1
    assert "course_lib: TCP_NODELAY is on" in lab.log.read_text()
    page.close()


def test_without_it_the_socket_waits(tmp_path, chrome):
    folder, home = tmp_path / "notebooks", tmp_path / "home"
    folder.mkdir()
    home.mkdir()
    lab = Lab(folder, home, options=(OFF,))
    try:
        page = connect(lab, chrome)
        assert sockets_that_send_at_once(lab) == 0
        page.close()
    finally:
        lab.stop()
