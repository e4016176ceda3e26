# SPDX-License-Identifier: MIT
"""contactlaws.h in Python.

    law = Law("dry_hill", young=29e9, poisson=0.15, friction=0.4)    or    Law(file="LAW.toml")
    state = law.new_state()
    force, torque1, torque2 = law.step(dt, Body(x=(0, 0, 0), radius=7.5e-3), Body(x=(0, 0, 12.4e-3), radius=5e-3), state)

The shared library is libcontactlaws.so beside this file, or the path in the environment variable CONTACTLAWS_LIBRARY.
"""
import ctypes
import os
from ctypes import POINTER, c_char_p, c_double, c_int, c_size_t, c_void_p

Vector = c_double * 3


class Body(ctypes.Structure):
    _fields_ = [("x", Vector), ("v", Vector), ("w", Vector), ("radius", c_double), ("mass", c_double)]


_face = ctypes.CDLL(os.environ.get("CONTACTLAWS_LIBRARY",
                                   os.path.join(os.path.dirname(os.path.abspath(__file__)), "libcontactlaws.so")))


def _declare(name, result, *arguments):
    function = getattr(_face, "contactlaws_" + name)
    function.restype, function.argtypes = result, arguments
    return function


_error = _declare("error", c_char_p)
_make = _declare("make", c_void_p, c_char_p, c_size_t, POINTER(c_char_p), POINTER(c_double))
_free = _declare("free", None, c_void_p)
_state_size = _declare("state_size", c_size_t, c_void_p)
_state_name = _declare("state_name", c_char_p, c_void_p, c_size_t)
_exchange_sign = _declare("exchange_sign", c_int, c_void_p, c_size_t)
_new_state = _declare("new_state", None, c_void_p, POINTER(c_double))
_make_wet = _declare("make_wet", c_int, c_void_p, c_double, c_double, POINTER(c_double))
_range = _declare("range", c_double, c_void_p, c_double, c_double)
_step = _declare("step", c_int, c_void_p, c_double, c_size_t, POINTER(Body), POINTER(Body), POINTER(c_double),
                 POINTER(Vector), POINTER(Vector), POINTER(Vector))


def _checked(failed):
    if failed:
        raise ValueError(_error().decode())


class Law:
    def __init__(self, name=None, file=None, **parameters):
        if file is not None:
            if not hasattr(_face, "contactlaws_read"):
                raise RuntimeError("this libcontactlaws.so reads no files: it was built without contactlaws_toml.cpp")
            self._law = _declare("read", c_void_p, c_char_p)(os.fsencode(file))
        else:
            count = len(parameters)
            names = (c_char_p * count)(*(key.encode() for key in parameters))
            self._law = _make(name.encode(), count, names, (c_double * count)(*parameters.values()))
        _checked(not self._law)
        values = range(_state_size(self._law))
        self.state_names = [_state_name(self._law, i).decode() for i in values]
        self.exchange_signs = [_exchange_sign(self._law, i) for i in values]

    def __del__(self):
        _free(getattr(self, "_law", None))

    def new_state(self):
        state = (c_double * len(self.state_names))()
        _new_state(self._law, state)
        return state

    def make_wet(self, overlap, moisture_gap, state):
        _checked(_make_wet(self._law, overlap, moisture_gap, state))

    def range(self, radius1, radius2):
        return _range(self._law, radius1, radius2)

    def step(self, dt, body1, body2, state):
        """Force on body 2, and the torques about both centres; updates `state`."""
        out = Vector(), Vector(), Vector()
        _checked(_step(self._law, dt, 1, body1, body2, state, *out))
        return out
