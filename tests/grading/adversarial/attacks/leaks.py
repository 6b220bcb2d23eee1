"""Ways to bring hidden inputs out; the verdict must not hold them."""

from attacks.attack import body

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
