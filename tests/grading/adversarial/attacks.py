"""What a submission may try: each with what it must get.

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
        What the answers must earn.
    says : str
        What an output or a verdict must hold.
    """

    cell: str = ""
    answer: str = WRONG
    first: float = 0.0
    second: float = 4.0
    says: str = ""


def body(*lines: str) -> str:
    return "\n".join([SIGNATURE, *(f"    {line}" for line in lines)])


def returns(value: str) -> Attack:
    return Attack(answer=body(f"return {value}"))


#: Answers that try to look right.
FORGERIES = {
    "patches numpy": Attack(
        "import numpy as np\n"
        "for f in ('all', 'any', 'allclose', 'isclose', 'array_equal', 'abs'):\n"
        "    setattr(np, f, lambda *a, **k: True)"
    ),
    "patches the judge": Attack(
        "import course_lib.judging as j, course_lib.judging.comparison as c\n"
        "j.judge = lambda *a, **k: 4.0\nc.Close.__call__ = lambda *a: None"
    ),
    "patches the answerer": Attack(
        "import course_lib.sandbox.answers as a, course_lib.sandbox.wire as w\n"
        "send = w.send\n"
        "w.send = lambda line, value: send(line, {'status': 'value', 'value': 4.0, 'points': 4.0})",
        second=0.0,  # it spoils its own right answer too
    ),
    "patches builtins": Attack(
        "import builtins\nbuiltins.abs = lambda x: 0\nbuiltins.max = lambda *a, **k: 0"
    ),
    "replaces check": Attack("def check(name):\n    return 4.0"),
    "shows points": Attack(
        "from IPython.display import display\ndisplay({'text/plain': '4.0'}, raw=True)\n4.0"
    ),
    "rewrites cells": Attack(
        "def rewrite(lines):\n    return ['4.0']\n"
        "get_ipython().input_transformers_cleanup.append(rewrite)",
        second=0.0,  # it rewrites its own right answer too
    ),
    "equals everything": Attack(
        "class Sly(float):\n"
        "    def __eq__(self, other): return True\n"
        "    def __sub__(self, other): return 0.0\n"
        "    __rsub__ = __sub__\n"
        "    def __abs__(self): return 0.0\n"
        "    def __le__(self, other): return True",
        answer=body("return Sly(1)"),
    ),
    "array that equals everything": Attack(
        "import numpy as np\n"
        "class Sly(np.ndarray):\n"
        "    def __array_ufunc__(self, *a, **k): return np.True_\n"
        "    def __array_function__(self, *a, **k): return np.True_",
        answer=body("return np.ones(()).view(Sly)"),
    ),
    "forges messages": Attack(
        "import os, course_lib.sandbox.codec as c\n"
        "forged = c.encode({'status': 'value', 'value': 4.0, 'points': 4.0})\n"
        "for n in range(3, 60):\n"
        "    try:\n        os.write(n, forged)\n    except OSError:\n        pass",
        second=0.0,  # what it wrote is taken for its own answers
    ),
    "says it is done": Attack(
        "import os, course_lib.sandbox.codec as c\n"
        "for n in range(3, 60):\n"
        "    try:\n        os.write(n, c.encode('done'))\n    except OSError:\n        pass",
        second=0.0,
    ),
    "says what is no status": Attack(
        "import course_lib.sandbox.answers as a, course_lib.sandbox.wire as w, numpy as np\n"
        "send = w.send\n"
        "w.send = lambda line, value: send(line, {'status': np.array(['value', 'raised'])})",
        second=0.0,  # it spoils its own right answer too
        says="a crash",
    ),
    "answers twice": Attack(answer=body("import os", "os.fork()", "return 1.0")),
    "looks for the truth on the stack": Attack(
        answer=body(
            "import sys",
            "f = sys._getframe()",
            "while f:",
            "    for v in list(f.f_locals.values()):",
            "        t = getattr(v, 'truth', None)",
            "        if t is not None: return t",
            "    f = f.f_back",
            "return 1.0",
        )
    ),
    "looks for the truth in memory": Attack(
        answer=body(
            "import gc",
            "for o in gc.get_objects():",
            "    if getattr(o, 'truth', None) is not None: return o.truth",
            "    if type(o).__name__ == 'Exercise': return o.reference(focal_length, distance, "
            "new_distance)",
            "return 1.0",
        )
    ),
    "calls the reference": Attack(
        answer=body(
            "from course_lib.camera import dolly_zoom as ready",
            "return ready(focal_length, distance, new_distance)",
        ),
        says="Write the steps yourself",
    ),
    "calls the reference unwatched": Attack(
        answer=body(
            "import sys",
            "sys.setprofile(None)",
            "from course_lib.camera import dolly_zoom as ready",
            "return ready(focal_length, distance, new_distance)",
        )
    ),
    "calls the reference in a thread": Attack(
        answer=body(
            "import threading",
            "from course_lib.camera import dolly_zoom as ready",
            "got = []",
            "t = threading.Thread(target=lambda: got.append(ready(focal_length, distance, "
            "new_distance)))",
            "t.start()",
            "t.join()",
            "return got[0]",
        )
    ),
    "reads the reference": Attack(
        "import inspect, textwrap\nfrom course_lib.camera import pinhole\n"
        "exec(inspect.getsource(pinhole.dolly_zoom), vars(pinhole))\nstolen = pinhole.dolly_zoom",
        answer=body("return stolen(focal_length, distance, new_distance)"),
    ),
    "searches the disk for the reference": Attack(
        "import os, re\nfound = []\n"
        "for place, _, names in os.walk('/course'):\n"
        "    for name in names:\n"
        "        if name.endswith('.py'):\n"
        "            text = open(os.path.join(place, name)).read()\n"
        "            if re.search(r'new_distance\\s*/\\s*distance|exercises.pinhole', text):\n"
        "                found.append(name)\n"
        "print('found', found)",
        says="found []",
    ),
    "imports the exercises": Attack(
        "import course_lib.exercises", says="No module named 'course_lib.exercises'"
    ),
    "imports the grader": Attack(
        "import course_lib.grading", says="No module named 'course_lib.grading'"
    ),
}

#: Values that are no answer.
VALUES = {
    name: returns(value)
    for name, value in {
        "nan": "float('nan')",
        "infinity": "float('inf')",
        "none": "None",
        "true": "True",
        "a list": "[1.0]",
        "an array of one": "np.array([[1.0]])",
        "text": "'4.0'",
        "bytes": "b'4.0'",
        "a number of a million digits": "10 ** 1_000_000",
        "half a letter": "'\\ud800'",
        "a list in itself": "(lambda a: (a.append(a), a)[1])([])",
        "nested deep": "eval('[' * 80 + ']' * 80)",
        "ten million items": "[0.0] * 10_000_000",
        "a gigabyte that is none": "np.broadcast_to(1.0, (10 ** 9,))",
        "objects": "np.array([object()])",
        "a record": "np.zeros(3, dtype=[('a', 'f8')])",
        "a masked array": "np.ma.masked_all(3)",
        "odd keys": "{(1, 2): 3, None: 4}",
        "many keys": "dict.fromkeys(range(3_000_000))",
        "a generator": "(x for x in range(9))",
        "a type made up": "type('T' + 'x' * 10_000, (), {})()",
        "an empty array": "np.zeros((0, 3))",
        "thirty-two axes": "np.zeros((1,) * 32)",
    }.items()
}

#: Ways to bring hidden inputs out; the verdict must not hold them.
LEAKS = {
    "in the exception's text": body("raise ValueError(f'secret {focal_length!r}')"),
    "in the exception's name": body(
        "raise type(f'secret{focal_length!r}'.replace('.', '_'), (Exception,), {})"
    ),
    "as not implemented": body("raise NotImplementedError(f'secret {focal_length!r}')"),
    "in a type's name": body("return type(f'secret{focal_length!r}', (), {})()"),
    "printed": body("print(f'secret {focal_length!r}')", "return 1.0"),
    "displayed": body(
        "from IPython.display import display", "display(f'secret {focal_length!r}')", "return 1.0"
    ),
    "warned": body("import warnings", "warnings.warn(f'secret {focal_length!r}')", "return 1.0"),
    "as a key error": body("return {}[f'secret {focal_length!r}']"),
    "as a line of code": body(
        "import linecache",
        "linecache.getline = lambda *a: f'secret {focal_length!r}'",
        "raise ValueError",
    ),
    "in a file that a later cell prints": body(
        "open('/tmp/seen', 'w').write(f'secret {focal_length!r}')", "return 1.0"
    ),
}

#: Harm to the machine, the grader or others.
HARM = {
    "ends Python": Attack("import os; os._exit(1)", second=0.0, says="Python stopped before"),
    "crashes": Attack("import ctypes; ctypes.string_at(0)", second=0.0, says="Python stopped"),
    "recurses": Attack("import sys; sys.setrecursionlimit(10 ** 9)\ndef f(): f()\nf()", second=0.0),
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
    "takes memory in an answer": Attack(
        answer=body("return bytearray(8 * 10 ** 9)"), says="MemoryError"
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

#: Looks outside: the code prints "held" if it was refused.
OUTSIDE = {
    "reads the key": "open({key!r}).read()",
    "reads the gradebook": "open({gradebook!r}, 'rb').read()",
    "writes the gradebook": "open({gradebook!r}, 'ab').write(b'x')",
    "reads another submission": "open({other!r}).read()",
    "lists the term": "__import__('os').listdir({term!r})",
    "reads the course's source": "open({course!r}).read()",
    "reads the grader's memory": "open('/proc/{grader}/mem', 'rb').read(1)",
    "reads the grader's environment": "open('/proc/{grader}/environ').read()",
    "signals the grader": "__import__('os').kill({grader}, 0)",
    "connects outside": "__import__('socket').create_connection(('1.1.1.1', 53), 1)",
    "connects to this machine": "__import__('socket').create_connection(('127.0.0.1', {port}), 1)",
    "looks a name up": "__import__('socket').getaddrinfo('example.org', 80)",
    "becomes root": "__import__('os').setuid(0)",
    "changes its root": "__import__('os').chroot('/tmp')",
    "traces the first process": "assert __import__('ctypes').CDLL(None).ptrace(16, 1, 0, 0) == 0",
    "makes a namespace": "assert __import__('ctypes').CDLL(None).unshare(0x10000000) == 0",
    "mounts": "assert __import__('ctypes').CDLL(None).mount(b'a', b'/tmp', b'tmpfs', 0, None) == 0",
    "uncovers": "assert __import__('ctypes').CDLL(None).umount2(b'/tmp', 2) == 0",
    "makes a device": "__import__('os').mknod('/tmp/d', 0o60666, 0xFE00)",
    "reads the disk": "open('/dev/vda', 'rb').read(1)",
    "reads the machine's secrets": "open('/etc/shadow').read()",
    "reads the home": "__import__('os').listdir({home!r})",
    "raises its limits": "__import__('resource').setrlimit(7, (9999, 9999))",
    "raises its priority": "__import__('os').nice(-5)",
    "sets the clock": "__import__('time').clock_settime(0, 0)",
    "follows a link beside it": "open('key.link').read()",
}
