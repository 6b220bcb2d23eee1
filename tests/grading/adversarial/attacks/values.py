"""Values that are no answer."""

from attacks.attack import returns

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
