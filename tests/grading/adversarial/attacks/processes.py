"""Harm to processes: its own, others', the grader's; and what is left behind."""

import sys

from attacks.attack import Attack, body

#: Points of the answer that follows recursion without end, which takes all memory: older Pythons
#: always end, newer ones sometimes end the cell only.
AFTER_RECURSION = 0.0 if sys.version_info < (3, 12) else None
PROCESSES = {
    "ends Python": Attack("import os; os._exit(1)", second=0.0, says="Python stopped before"),
    "crashes": Attack("import ctypes; ctypes.string_at(0)", second=0.0, says="Python stopped"),
    "recurses": Attack(
        "import sys; sys.setrecursionlimit(10 ** 9)\ndef f(): f()\nf()", second=AFTER_RECURSION
    ),
    "ends Python in an answer": Attack(answer=body("import os", "os._exit(0)"), says="a crash"),
    "crashes in an answer": Attack(
        answer=body("import ctypes", "ctypes.string_at(0)"), says="a crash"
    ),
    "becomes a shell": Attack(answer=body("import os", "os.execv('/bin/sh', ['sh'])")),
    "kills everybody": Attack("import os; os.kill(-1, 9)"),
    "kills its parent": Attack("import os\nfor n in (os.getppid(), 1): os.kill(n, 9)"),
    "stops its parent": Attack("import os, signal\nos.kill(os.getppid(), signal.SIGSTOP)"),
    "stops itself": Attack(
        "import os, signal\nos.kill(os.getpid(), signal.SIGSTOP)", second=0.0, says="too long"
    ),
    "closes everything": Attack("import os; os.closerange(0, 1000)", second=0.0),
    "closes its streams": Attack("import sys; sys.stdout.close(); sys.stderr.close()"),
    "forks without end": Attack(
        "import os\ntry:\n    while True: os.fork()\nexcept OSError:\n    pass", second=None
    ),
    "starts threads without end": Attack(
        "import threading, time\n"
        "try:\n"
        "    while True: threading.Thread(target=time.sleep, args=(99,), daemon=True).start()\n"
        "except RuntimeError as error:\n    print(error)",
        second=None,
        says="can't start new thread",
    ),
    "leaves a daemon": Attack(
        "import os, time\n"
        "if os.fork() == 0:\n"
        "    os.setsid()\n"
        "    if os.fork() == 0:\n"
        "        while True: time.sleep(0.1)\n"
        "    os._exit(0)"
    ),
    "spoils the modules": Attack(
        "import sys\nfor name in list(sys.modules): sys.modules[name] = None", second=None
    ),
    "plants files for others": Attack(
        "import os\n"
        "for place in ('/', '/course', '/usr/lib', '/tmp', '/dev', os.path.dirname(os.__file__)):\n"
        "    try:\n        open(f'{place}/sitecustomize.py', 'w').write('planted = 1')\n"
        "    except OSError as e:\n        print(place, e.strerror)\n"
        "print('planted')",
        says="Read-only file system",
    ),
}
