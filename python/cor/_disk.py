# SPDX-License-Identifier: MIT
"""Wraps functions of disk.h that fill arrays or call a function of the caller, and defines the class of mode tables."""

import os
from typing import Any, Callable, Optional, Tuple, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike

from ._cor import ffi, lib
from ._docs import DOCS
from ._evaluate import (
    Array,
    CorError,
    address,
    in_parts,
    judge,
    ma,
    mask_of,
    number,
    plain_dtype,
    pointer,
    record_dtype,
)

F = TypeVar("F", bound=Callable[..., Any])
CENTRE_OF_MASS = int(lib.COR_DISK_DATUM_CENTRE_OF_MASS)
_MODE = plain_dtype("cor_disk_mode")


def _documented(name: str) -> Callable[[F], F]:
    """Appends the comment of the header to the docstring."""

    def add(function: F) -> F:
        function.__doc__ = f"{function.__doc__}\n\n{DOCS[name]}\n\nC: {name}"
        return function

    return add


class DiskModes:
    """Free modes of an elastic disk: a table for functions of cor.disk, which are also methods of the table.

    DiskModes(nu, count) computes the lowest count modes for Poisson's ratio nu by cor_disk_modes_compute;
    DiskModes.read(path) reads a file of corgen. cor.disk.modes_nu033 and modes_nu090 are the tables of the library.
    mode is a structured array with the fields n, l, omega, c, s.
    """

    _struct = "cor_disk_modes"
    __slots__ = ("_c", "mode")
    _c: Any
    mode: Array

    def __init__(self, nu: float, count: int) -> None:
        made = modes_compute(nu, count)
        self._c, self.mode = made._c, made.mode

    @classmethod
    def _of(cls, mode: Array, c: Any) -> "DiskModes":
        made = cls.__new__(cls)
        mode.flags.writeable = False
        made._c, made.mode = c, mode
        return made

    @classmethod
    def from_table(cls, nu: float, mode: Array) -> "DiskModes":
        """Returns modes from a structured array with the fields of struct cor_disk_mode, by increasing omega."""
        copy = np.array(mode, _MODE, order="C", ndmin=1)
        c = ffi.new("struct cor_disk_modes *", (nu, copy.size, _modes_address(copy)))
        return cls._of(copy, c)

    @classmethod
    def read(cls, path: Union[str, "os.PathLike[str]"]) -> "DiskModes":
        """Reads the modes from a file that corgen wrote (cor_disk_modes_read)."""
        return modes_read(path)

    @property
    def nu(self) -> float:
        """Poisson's ratio"""
        return float(self._c.nu)

    @property
    def count(self) -> int:
        """Number of modes"""
        return int(self._c.count)

    def __len__(self) -> int:
        return self.count

    def __repr__(self) -> str:
        return f"<DiskModes nu={self.nu!r} count={self.count}>"

    def __reduce__(self) -> Tuple[Any, ...]:
        return DiskModes.from_table, (self.nu, np.array(self.mode))

    def _modes(self, n_modes: Optional[ArrayLike]) -> ArrayLike:
        return self.count if n_modes is None else n_modes

    def rayleigh(self, speed: ArrayLike, n_modes: Optional[int] = None, datum: int = CENTRE_OF_MASS) -> Any:
        """Calls rayleigh for one speed, rayleigh_array for several. Uses all modes if n_modes is None."""
        n = self.count if n_modes is None else n_modes
        speeds = np.asarray(speed, np.float64)
        return rayleigh_array(self, n, datum, speeds) if speeds.ndim else rayleigh(self, n, datum, float(speeds))

    def collision(self, speed: ArrayLike, alpha: float, tolerance: float, n_modes: Optional[ArrayLike] = None) -> Any:
        """Calls cor.disk.collision for one or several speeds. Uses all modes if n_modes is None."""
        from . import disk

        return disk.collision(self, self._modes(n_modes), disk.CollisionOptions(alpha, tolerance), speed)

    def hard_wall(self, speed: ArrayLike, tolerance: float, n_modes: Optional[ArrayLike] = None) -> Any:
        """Calls cor.disk.hard_wall for one or several speeds. Uses all modes if n_modes is None."""
        from . import disk

        return disk.hard_wall(self, self._modes(n_modes), disk.HardWallOptions(tolerance), speed)


def _modes_address(mode: Array) -> Any:
    return ffi.from_buffer("struct cor_disk_mode[]", mode)


def _constant(c: Any) -> DiskModes:
    """Returns a table of the library, which is valid until the program ends."""
    table = np.frombuffer(ffi.buffer(c.mode, c.count * _MODE.itemsize), _MODE)
    return DiskModes._of(table, ffi.addressof(c))


modes_nu033 = _constant(lib.cor_disk_modes_nu033)
modes_nu090 = _constant(lib.cor_disk_modes_nu090)


@_documented("cor_disk_modes_read")
def modes_read(path: Union[str, "os.PathLike[str]"]) -> DiskModes:
    """Reads the modes of a file. If a line of the file is wrong, CorError has its number as the attribute `line`."""
    name = os.fsencode(path)
    c = ffi.new("struct cor_disk_modes *")
    line = ffi.new("size_t *")
    status = lib.cor_disk_modes_read(name, ffi.NULL, 0, c, line)
    mode = np.zeros(c.count if status == lib.COR_ERROR_CAPACITY else 0, _MODE)
    if status == lib.COR_ERROR_CAPACITY:
        status = lib.cor_disk_modes_read(name, _modes_address(mode), mode.size, c, line)
    if status:
        error = CorError(status)
        error.line = int(line[0])  # type: ignore[attr-defined]
        error.args = (f"{os.fspath(path)}: {error.args[0]}" + (f" (line {line[0]})" if line[0] else ""),)
        raise error
    return DiskModes._of(mode, c)


@_documented("cor_disk_modes_compute")
def modes_compute(nu: float, count: int) -> DiskModes:
    """Computes the lowest count modes of a disk."""
    nu, count = number("nu", nu), number("count", count, True, -(2**63))
    if count > lib.COR_DISK_MODES_MAX_COUNT or count < 1:
        raise CorError(lib.COR_ERROR_MODES)
    mode = np.zeros(count, _MODE)
    c = ffi.new("struct cor_disk_modes *")
    judge(np.asarray(lib.cor_disk_modes_compute(nu, count, _modes_address(mode), c)))
    return DiskModes._of(mode, c)


def _table(modes: DiskModes) -> Any:
    return pointer(modes, "cor_disk_modes")


def _fractions_array(
    modes: DiskModes, n_modes: int, shape: Tuple[int, ...], wanted: bool
) -> Tuple[Optional[Array], Any]:
    """Returns an array for the fractions of the modes, and its address. Returns no array if C will refuse n_modes."""
    if not wanted or not 0 < n_modes <= modes.count:
        return None, ffi.NULL
    fractions = np.zeros(shape + (n_modes,))
    return fractions, address(fractions, True)


def _record(struct: str, call: Callable[[Any], int]) -> Any:
    """Returns a record of the results and the status. call(out): fills the struct and returns the status."""
    out = np.zeros((), record_dtype(struct))
    out["status"] = call(ffi.cast(f"struct {struct} *", ffi.from_buffer("char[]", out, True)))
    judge(np.asarray(out["status"]))
    return out.view(np.recarray)[()]


def _records(struct: str, speed: ArrayLike, function: Any, given: Tuple[Any, ...], more: Tuple[Any, ...] = ()) -> Any:
    """Returns an array of records, shaped like speed, with results and status. more: arguments of `function` after the
    results. If `more` is not empty, one call computes all speeds."""
    speeds = np.array(speed, np.float64, order="C")
    mask = mask_of([speed], speeds.shape)
    out = np.zeros(speeds.size, plain_dtype(struct))
    status = np.zeros(speeds.size, np.intc)
    results = ffi.from_buffer(f"struct {struct}[]", out, True)

    def run(first: int, count: int) -> None:
        whole = function(*given, address(speeds) + first, count, results + first, *more, address(status, True) + first)
        if whole and not status[first : first + count].any():
            raise CorError(whole)

    if more:
        run(0, speeds.size)
    else:
        in_parts(speeds.size, run)
    judge(np.where(mask, 0, status.reshape(speeds.shape)))
    result = np.zeros(out.size, record_dtype(struct))
    for name in out.dtype.names or ():
        result[name] = out[name]
    result["status"] = status
    result = result.reshape(speeds.shape)
    return result.view(np.recarray)[()] if mask is ma.nomask else ma.array(result, mask=mask)


@_documented("cor_disk_rayleigh")
def rayleigh(modes: DiskModes, n_modes: int, datum: int, speed: float, mode_fraction: bool = False) -> Any:
    """Returns a record of the results and the status; with mode_fraction also the array of the fractions."""
    table = _table(modes)
    n_modes = number("n_modes", n_modes, True)
    fractions, at = _fractions_array(modes, n_modes, (), mode_fraction)
    given = (table, n_modes, datum, number("speed", speed))
    result = _record("cor_disk_rayleigh", lambda out: int(lib.cor_disk_rayleigh(*given, out, at)))
    return (result, fractions) if mode_fraction else result


@_documented("cor_disk_rayleigh_array")
def rayleigh_array(modes: DiskModes, n_modes: int, datum: int, speed: ArrayLike, mode_fraction: bool = False) -> Any:
    """Returns an array of records, shaped like speed, with results and status. With mode_fraction it also
    returns the fractions, an array with one more axis."""
    table = _table(modes)
    n_modes = number("n_modes", n_modes, True)
    fractions, at = _fractions_array(modes, n_modes, np.shape(speed), mode_fraction)

    records = _records("cor_disk_rayleigh", speed, lib.cor_disk_rayleigh_array, (table, n_modes, datum), (at,))
    return (records, fractions) if mode_fraction else records


@_documented("cor_disk_rayleigh_tolerance")
def rayleigh_tolerance(modes: DiskModes, datum: int, speed: float, tolerance: float) -> Tuple[Any, int]:
    """Returns a record of the results and the status, and the number of modes."""
    given = (_table(modes), datum, number("speed", speed), number("tolerance", tolerance))
    n_modes = ffi.new("size_t *")
    result = _record("cor_disk_rayleigh", lambda out: int(lib.cor_disk_rayleigh_tolerance(*given, out, n_modes)))
    return result, int(n_modes[0])


@_documented("cor_disk_collision_array")
def collision_array(modes: DiskModes, n_modes: int, options: Any, speed: ArrayLike) -> Any:
    """Returns an array of records, shaped like speed, with results and status."""
    given = (_table(modes), number("n_modes", n_modes, True), pointer(options, "cor_disk_collision_options"))
    return _records("cor_disk_collision", speed, lib.cor_disk_collision_array, given)


class _Detail:
    """Optional results of one collision, filled by the function that receives this object.

    energy_after, energy_average   arrays with one element for each mode
    observe                        is called at every step with a record of the motion and the arrays q and q_dot
                                   of the amplitudes. Copy the arrays to store them. An exception from observe is raised
                                   after the collision.
    """

    _struct: str
    _moment: str

    def __init__(self, n_modes: int, observe: Optional[Callable[[Any, Array, Array], None]] = None) -> None:
        self.energy_after = np.full(n_modes, np.nan)
        self.energy_average = np.full(n_modes, np.nan)
        self.observe = observe
        self._q = np.zeros(n_modes)
        self._q_dot = np.zeros(n_modes)
        self._dtype = plain_dtype(self._moment)
        self._error: Optional[BaseException] = None
        self._handle = ffi.new_handle(self)
        self._c = ffi.new(f"struct {self._struct} *")
        for name in ("energy_after", "energy_average"):
            setattr(self._c, name, address(getattr(self, name), True))
        if observe is not None:
            self._c.observe = getattr(lib, f"cor_python_observe_{self._struct[len('cor_'):]}")
            self._c.context = self._handle
            self._c.q = address(self._q, True)
            self._c.q_dot = address(self._q_dot, True)

    def _seen(self, moment: Any) -> None:
        if self._error is None and self.observe is not None:
            record = np.frombuffer(ffi.buffer(moment), np.dtype((np.record, self._dtype))).copy()[0]
            try:
                self.observe(record, self._q, self._q_dot)
            except BaseException as error:  # KeyboardInterrupt, too: an exception cannot pass through C
                self._error = error


class CollisionDetail(_Detail):
    __doc__ = _Detail.__doc__
    _struct = "cor_disk_collision_detail"
    _moment = "cor_disk_moment"


class HardWallDetail(_Detail):
    __doc__ = _Detail.__doc__
    _struct = "cor_disk_hard_wall_detail"
    _moment = "cor_disk_hard_wall_moment"


def _seen(context: Any, moment: Any) -> None:
    ffi.from_handle(context)._seen(moment)


for _name in ("disk_collision_detail", "disk_hard_wall_detail"):
    ffi.def_extern(name=f"cor_python_observe_{_name}")(_seen)


def _in(what: str) -> Callable[..., Any]:
    """cor_disk_<what>_in"""
    struct = f"cor_disk_{what}"
    function = getattr(lib, f"{struct}_in")

    def call(
        workspace: Any, modes: DiskModes, n_modes: int, options: Any, speed: float, detail: Optional[_Detail] = None
    ) -> Any:
        """Returns a record of the results and the status. workspace: writable buffer, as np.empty(bytes, np.uint8)."""
        memory = ffi.from_buffer("char[]", workspace, True)
        n_modes, speed = number("n_modes", n_modes, True), number("speed", speed)
        if detail is not None and detail.energy_after.size < n_modes <= modes.count:
            raise ValueError(f"the detail has room for {detail.energy_after.size} modes, not for {n_modes}")
        of_detail = ffi.NULL if detail is None else pointer(detail, f"{struct}_detail")
        given = (memory, len(memory), _table(modes), n_modes, pointer(options, f"{struct}_options"), speed)

        def filled(out: Any) -> int:
            status = function(*given, out, of_detail)
            if detail is not None and detail._error is not None:
                error, detail._error = detail._error, None
                raise error
            return int(status)

        return _record(struct, filled)

    call.__name__ = call.__qualname__ = f"{what}_in"
    return _documented(f"{struct}_in")(call)


collision_in = _in("collision")
hard_wall_in = _in("hard_wall")
