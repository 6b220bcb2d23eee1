"""More than one's share: of memory, of space in files and outputs, of time."""

from attacks.attack import Attack, body

#: Each name has the word in it, by which the test knows them.
MEMORY = {
    "takes memory": Attack("x = bytearray(8 * 10 ** 9)", says="MemoryError"),
    "takes memory little by little": Attack(
        "x = []\nwhile True: x.append(bytearray(10 ** 8))", says="MemoryError"
    ),
    "takes memory in many processes": Attack(
        "import os, time\n"
        "for _ in range(20):\n"
        "    if os.fork() == 0:\n"
        "        x = bytearray(os.urandom(1)) * 250_000_000; time.sleep(60)\n"
        "time.sleep(60)",
        second=0.0,
        says="too much memory",
    ),
    "takes shared memory": Attack(
        "import mmap, os, time\n"
        "kept = []\n"
        "for _ in range(40):\n"
        "    m = mmap.mmap(-1, 10 ** 8); m.write(bytes(10 ** 8)); kept.append(m)\n"
        "    if os.fork() == 0: time.sleep(60)",
        second=None,
    ),
    "takes memory in files without a name": Attack(
        "import os, time\nkept = []\n"
        "for _ in range(60):\n"
        "    kept.append(os.memfd_create('a')); os.write(kept[-1], bytes(5 * 10 ** 7))\n"
        "time.sleep(9)",
        second=0.0,
        says="too much memory",
    ),
    "takes memory and hides": Attack(
        "import ctypes, os, time\nctypes.CDLL(None).prctl(4, 0, 0, 0, 0)\n"
        "for _ in range(9):\n"
        "    if os.fork() == 0:\n"
        "        x = b'a' * 250_000_000; time.sleep(60)\n"
        "time.sleep(60)",
        second=0.0,
        says="too much memory",
    ),
    "takes old shared memory": Attack(
        "import ctypes\nlibc = ctypes.CDLL(None)\n"
        "print('got', [n for n in range(50) if libc.shmget(0, 10 ** 8, 0o1600) >= 0])",
        says="got []",
    ),
    "floods the grader's memory": Attack(
        "import os, course_lib.sandbox.codec as c\nimport numpy as np\n"
        "message = c.encode({'cell': 1, 'outputs': [], 'more': np.zeros(2_000_000)})\n"
        "while True:\n"
        "    for n in range(3, 60):\n"
        "        try:\n"
        "            left = message\n"
        "            while left: left = left[os.write(n, left):]\n"
        "        except OSError:\n            pass",
        second=0.0,
        says="printed far too much",
    ),
    "takes memory in an answer": Attack(
        answer=body("return bytearray(8 * 10 ** 9)"), says="MemoryError"
    ),
}

#: In files and in outputs.
SPACE = {
    "fills the temporary folder": Attack(
        "for n in range(99):\n    open(f'/tmp/{n}', 'wb').write(bytes(10 ** 7))", says="OSError"
    ),
    "fills the shared folder": Attack(
        "for n in range(99):\n    open(f'/dev/shm/{n}', 'wb').write(bytes(10 ** 7))", says="OSError"
    ),
    "makes a million files": Attack(
        "for n in range(10 ** 6):\n    open(f'/tmp/{n}', 'w').close()", says="OSError"
    ),
    "opens everything": Attack(
        "kept = []\nwhile True: kept.append(open('/dev/null'))", second=None, says="Too many open"
    ),
    "prints without end": Attack("while True: print('x' * 10 ** 6)", says="TimeLimitReached"),
    "prints fifty megabytes": Attack("print('x' * 50_000_000)"),
    "displays fifty megabytes": Attack("'x' * 50_000_000"),
    "displays a million times": Attack("for n in range(20_000): display(n)"),
    "raises fifty megabytes": Attack("raise ValueError('x' * 50_000_000)"),
}

#: In cells and in answers.
TIME = {
    "never ends": Attack("while True: pass", says="stopped after"),
    "never ends and swallows": Attack(
        "while True:\n    try:\n        while True: pass\n    except BaseException: pass",
        second=None,  # it depends on where it is when the bell rings
    ),
    "never ends in C": Attack("import re; re.match('(a|aa)+b', 'a' * 99)", second=None),
    "sleeps deaf": Attack(
        "import signal, time\n"
        "signal.pthread_sigmask(signal.SIG_BLOCK, range(1, 65))\ntime.sleep(600)",
        second=0.0,
        says="too long",
    ),
    "never answers": Attack(answer=body("while True: pass"), says="Does a loop never end"),
    "never answers and swallows": Attack(
        answer=body(
            "while True:",
            "    try:",
            "        while True: pass",
            "    except BaseException: pass",
        ),
        says="Does a loop never end",
    ),
    "never answers in C": Attack(
        answer=body("return 7 ** (10 ** 9)"), says="Does a loop never end"
    ),
}
