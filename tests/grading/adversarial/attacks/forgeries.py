"""Answers that try to look right."""

from attacks.attack import Attack, body

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
