"""What was tried later: other names for the reference, raw messages, shapes, other ways out.

All of this came after a first hour of cheating, whose attempts are in the other modules.
"""

from attacks.attack import RIGHT, Attack, body, returns

#: Writes bytes into everything that is open.
WRITE = (
    "import os\n"
    "for n in range(3, 60):\n"
    "    try:\n        os.write(n, {})\n    except OSError:\n        pass"
)
#: The right answer as something else.
ANSWER = "focal_length * new_distance / distance"

LATER_FORGERIES = {
    "imports the reference by its text": Attack(
        answer=body(
            "import importlib",
            "module = importlib.import_module('course_lib.camera.pinhole')",
            "return getattr(module, 'dolly' + '_zoom')(focal_length, distance, new_distance)",
        ),
        says="Write the steps yourself",
    ),
    "calls every function of that name in memory": Attack(
        answer=body(
            "import gc, types",
            "for f in gc.get_objects():",
            "    if isinstance(f, types.FunctionType) and f.__name__ == 'dolly_zoom':",
            "        try: return types.FunctionType(f.__code__, dict(f.__globals__))(focal_length, "
            "distance, new_distance)",
            "        except Exception: pass",
            "return 1.0",
        ),
    ),
    "looks for sources in the frames of a run that has others": Attack(
        answer=body(
            "import sys",
            "from course_lib.camera import pixel_focal_length",
            "try: pixel_focal_length(1.0, (1.0, 1.0), (1, 1))",
            "except Exception: return 1.0",
            "f, scope = sys._getframe(), {}",
            "while f:",
            "    for given in [v for v in f.f_locals.values() if isinstance(v, dict)]:",
            "        for source in (given.get('given_back') or {}).values():",
            "            exec('from __future__ import annotations\\n' + source, scope)",
            "    f = f.f_back",
            "return scope['dolly_zoom'](focal_length, distance, new_distance)",
        ),
    ),
    "looks for checks in what IPython keeps": Attack(
        "past = get_ipython().history_manager.get_range(output=True)\n"
        "seen = map(str, (*In, *Out.values(), *past))\n"
        "others = [text for text in seen if 'import check' not in text and 'past' not in text]\n"
        "print('found', [text for text in others if 'check' in text])",
        answer=body("kept = get_ipython().user_ns", "return [*kept['Out'].values(), 1.0][0]"),
        says="found []",
    ),
    "looks for its notebook": Attack(
        "import glob\n"
        "print('found', glob.glob('/tmp/**/*.ipynb', recursive=True) + glob.glob('**/*.ipynb'))",
        says="found []",
    ),
    "says that it missed a function": Attack(
        "import course_lib.sandbox.answers as a, course_lib.sandbox.wire as w\n"
        "send = w.send\n"
        "w.send = lambda line, value: send(line, {**value, 'hidden': ['a.b', 'course_lib.x.y']})",
        second=None,  # what its cells report is spoilt, too
    ),
    "sends brackets": Attack(
        WRITE.format("b'cam1' + (100_000).to_bytes(4, 'big') + bytes(4) + b'[' * 100_000"),
        second=0.0,
    ),
    "says that two gigabytes come": Attack(WRITE.format("b'cam1' + b'\\x7f' * 8"), second=0.0),
    "sends half a message": Attack(
        WRITE.format("b'cam1' + (9_000).to_bytes(4, 'big') + bytes(4) + b'[1,'"), second=0.0
    ),
    "sends a shape without end": Attack(
        WRITE.format(
            "(lambda t: b'cam1' + len(t).to_bytes(4, 'big') + bytes(4) + t)"
            "(b'[\"array\",\"f8\",[0' + b',9223372036854775807' * 31 + b'],0]')"
        ),
        second=0.0,
    ),
    "closes its line at the question": Attack(
        answer=body("import os", "os.closerange(3, 60)", "return 4.0"), says="a crash"
    ),
    "is an array when asked": Attack(
        "class Sly:\n    def __array__(self, *a, **k): return 4.0\n    __float__ = __array__",
        answer=body("return Sly()"),
        says="kind that you made",
    ),
    "is a text with another length": Attack(
        "class Sly(str):\n    def __len__(self): return 0",
        answer=body("return Sly('x' * 30_000_000)"),
    ),
    "the answer as a complex number": returns(f"complex({ANSWER}, 0)"),
    "the answer as a text": returns(f"str({ANSWER})"),
    "the answer as a truth": returns(f"bool({ANSWER})"),
    "the answer among others": returns(f"({ANSWER}, 1.0)"),
    "the answer as a time": returns(f"np.datetime64(int({ANSWER}), 's')"),
    "the answer as an interval": returns(f"np.array([-np.inf, {ANSWER}, np.inf])"),
    "texts that fill the memory as an array": returns("[''] * 4000 + ['x' * 4_000_000]"),
    "keys in one place of a table": returns("{(2 ** 61 - 1) * k: 0.0 for k in range(1, 30_000)}"),
}

LATER_LEAKS = {
    "as an empty shape": body("return np.zeros((0, int(focal_length * 1e6)))"),
    "as a decimal comma": body("return int(focal_length * 1e6), 5"),
    "as a size": body("return np.broadcast_to(0.0, int(focal_length * 1e8))"),
    "as many axes": body(
        "return np.zeros([1 + (int(focal_length * 1e6) >> k) % 2 for k in range(24)])"
    ),
    "as a name of a missing function": "dolly_zoom = 'secret'",
    "as colours of a terminal": body("raise ValueError('\\x1b]0;secret\\x07')"),
}

_CALL = "assert __import__('ctypes').CDLL(None).syscall({}) >= 0"
LATER_OUTSIDE = {
    "talks to the machine that runs this one": "__import__('socket').socket(40, 1)",
    "keeps a key for the next": _CALL.format("248, b'user', b'covert', b'x', 1, -3"),
    "reads the keys of the session": _CALL.format("250, 0, -3, 0"),
    "asks for a ring of requests": _CALL.format("425, 8, bytes(bytearray(120))"),
    "reads the kernel's messages": "assert __import__('ctypes').CDLL(None).klogctl(10, 0, 0) >= 0",
    "names a program for crashes": "open('/proc/sys/kernel/core_pattern', 'w').write('|/tmp/x')",
    "restarts the machine": "open('/proc/sysrq-trigger', 'w').write('b')",
    "names the machine": "assert __import__('ctypes').CDLL(None).sethostname(b'x', 1) == 0",
    "reads the first process": "open('/proc/1/mem', 'rb').read(1)",
    "lists the first process's files": "__import__('os').listdir('/proc/1/fd')",
    "writes the terminal": "open('/dev/tty', 'w').write('x')",
    "makes the library its own": "__import__('os').chmod('/course', 0o777)",
}

LATER_HARM = {
    "writes magics": Attack("!a\n" * 2000, second=None),
    "takes all watches": Attack(
        "import ctypes\nlibc = ctypes.CDLL(None)\nwhile libc.inotify_init() >= 0: pass",
        second=None,
    ),
    "leaves busy grandchildren": Attack(
        "import os\n"
        "for _ in range(6):\n"
        "    if os.fork() == 0:\n"
        "        os.setsid()\n"
        "        if os.fork() == 0:\n"
        "            while True: pass\n"
        "        os._exit(0)",
        RIGHT,
        first=4.0,
    ),
}
