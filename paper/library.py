# SPDX-License-Identifier: MIT
"""libcor as its headers declare it, and the disks of paper/relaxed_disk.h, through ctypes. Units as in cor/disk.h.
COR_PAPER names the library that paper/CMakeLists.txt builds."""
import collections
import ctypes
import math
import os
import pathlib
import sys
import types

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "python"))
from bindings.declarations import Declarations  # noqa: E402

_declared = Declarations(ROOT / "include" / "cor")
_library = ctypes.CDLL(os.path.abspath(os.environ["COR_PAPER"]))
_KINDS = {"void": None, "int": ctypes.c_int, "double": ctypes.c_double, "size_t": ctypes.c_size_t,
          "const char *": ctypes.c_char_p}


def _kind(text):
    return _KINDS.get(text, ctypes.c_int if text.startswith("enum") else ctypes.c_void_p)


def _struct(name):
    fields = [(field.name, _kind(field.type)) for field in _declared.structs[name].fields]
    return type(name, (ctypes.Structure,), {"_fields_": fields})


def _function(name, result, *parameters):
    function = getattr(_library, name)
    function.restype, function.argtypes = result, parameters
    return function


def _of_header(function):
    return _function(function.name, _kind(function.result), *(_kind(p.type) for p in function.parameters))


# Functions and structs by their names without cor_: cor.disk_load, cor.struct.disk_collision
cor = types.SimpleNamespace(**{name[4:]: _of_header(function) for name, function in _declared.functions.items()
                               if name.startswith(("cor_disk_", "cor_status_"))})
cor.struct = types.SimpleNamespace(**{name[4:]: _struct(name) for name in _declared.structs
                                      if name.startswith("cor_disk_")})
ENUM = {name: value for enum in _declared.enums.values() for name, value, _ in enum.members}
DATUM = {name: ENUM["COR_DISK_DATUM_" + name.upper()] for name in ("centre_of_mass", "diameter", "printed")}
jn = _function("jn", ctypes.c_double, ctypes.c_int, ctypes.c_double)

Mode = collections.namedtuple("Mode", [field.name for field in _declared.structs["cor_disk_mode"].fields])


def constant(name):
    return float(_declared.constants[name].text)


def judge(status, where, *passing):
    """Ends the program unless the status is COR_OK or one of the given names."""
    if status not in [ENUM[name] for name in ("COR_OK",) + passing]:
        sys.exit("paper: %s: %s" % (where, cor.status_text(status).decode()))
    return status


class Material:
    """A table of modes of the library"""

    def __init__(self, name):
        self.table = cor.struct.disk_modes.in_dll(_library, name)
        self.nu, self.count = self.table.nu, self.table.count
        rows = (cor.struct.disk_mode * self.count).from_address(self.table.mode)
        self.modes = [Mode(*(getattr(row, field) for field in Mode._fields)) for row in rows]
        self.omega = [mode.omega for mode in self.modes]

    def rayleigh(self, datum, speed, n_modes=1800):
        """Returns the result and the fraction of each mode; None above the speed limit of the contact law."""
        out, fractions = cor.struct.disk_rayleigh(), (ctypes.c_double * n_modes)()
        status = judge(cor.disk_rayleigh(ctypes.byref(self.table), n_modes, datum, speed, ctypes.byref(out), fractions),
                       "v = %g" % speed, "COR_BEYOND_THEORY", "COR_ERROR_SPEED")
        return None if status == ENUM["COR_ERROR_SPEED"] else (out, fractions)

    def collision(self, n_modes, alpha, speed, tolerance, watch=None):
        """Computes one collision with the lowest modes. Returns the result, True if it reached the tolerance, and
        the energy of each mode: the average, and the energy after the collision. watch(moment, q, q_dot) is called at
        each step, with arrays that change."""
        out, arrays = cor.struct.disk_collision(), [(ctypes.c_double * n_modes)() for _ in range(4)]
        average, after, q, q_dot = arrays

        @ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.POINTER(cor.struct.disk_moment))
        def observe(_, moment):
            watch(moment[0], q, q_dot)

        detail = cor.struct.disk_collision_detail()
        if watch is not None:
            for name, array in zip(("energy_average", "energy_after", "q", "q_dot"), arrays):
                setattr(detail, name, ctypes.addressof(array))
            detail.observe = ctypes.cast(observe, ctypes.c_void_p)
        options = cor.struct.disk_collision_options(alpha=alpha, tolerance=tolerance)
        table, options = ctypes.byref(self.table), ctypes.byref(options)
        workspace = ctypes.create_string_buffer(cor.disk_collision_workspace(table, n_modes, options))
        status = judge(cor.disk_collision_in(workspace, len(workspace), table, n_modes, options, speed,
                                             ctypes.byref(out), ctypes.byref(detail)),
                       "nu = %g, %d modes, alpha = %g, v = %g" % (self.nu, n_modes, alpha, speed),
                       "COR_TOLERANCE_NOT_REACHED")
        return out, status == ENUM["COR_OK"], average, after


MATERIALS = {material.nu: material for material in map(Material, ("cor_disk_modes_nu033", "cor_disk_modes_nu090"))}


_DISK_OF = (_function("relaxed_disk_of_modes", ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_double,
                      ctypes.c_size_t),
            _function("relaxed_disk_of_all_modes", ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_size_t))
_press = _function("relaxed_disk_press", ctypes.c_double, ctypes.c_void_p, ctypes.c_double)


class RelaxedDisk:
    """A disk at rest against the wall, with the lowest modes of nu = 0.33, or all modes if n_modes is None"""

    def __init__(self, n_modes, alpha, points):
        self.disk = (_DISK_OF[1](0.33, alpha, points) if n_modes is None else
                     _DISK_OF[0](ctypes.byref(MATERIALS[0.33].table), n_modes, alpha, points))

    def load(self, compression):
        load = _press(self.disk, compression)
        if math.isnan(load):
            sys.exit("paper: no relaxed disk at a compression of %g" % compression)
        return load
