# SPDX-License-Identifier: MIT
"""Handles broadcasting, dtypes, structs and errors when generated modules call the loops of the C module."""

import operator
import re
import sys
import time
import warnings
from enum import IntEnum
from typing import Any, Callable, ClassVar, List, Optional, Sequence, Tuple, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._cor import ffi, lib

Array = NDArray[Any]
S = TypeVar("S", bound="Struct")

ma: Any = np.ma  # has no types in some versions of NumPy
_POINTER = {
    np.dtype(np.float64): "double[]",
    np.dtype(np.float32): "float[]",
    np.dtype(np.intc): "int[]",
    np.dtype(np.uintp): "size_t[]",
}
_INTC: "np.dtype[Any]" = np.dtype(np.intc)
_FLOAT64: "np.dtype[Any]" = np.dtype(np.float64)
_FLOAT32: "np.dtype[Any]" = np.dtype(np.float32)
_DTYPE = {ffi.typeof("double"): _FLOAT64, ffi.typeof("size_t"): np.dtype(np.uintp)}  # others: _INTC
_number = np.float64
_NUMBERS = frozenset((float, int, _number))


class CorError(ValueError):
    """An error status of cor. status: its number, a cor.status.Status. index: the place of the first element with this
    status, () for a single result."""

    __module__ = "cor"

    def __init__(self, status: int, index: Tuple[int, ...] = ()) -> None:
        from .status import Status

        text = string(lib.cor_status_text(status))
        super().__init__(f"{text} (at index {', '.join(map(str, index))})" if index else text)
        self.status = Status(status)
        self.index = index

    def __reduce__(self) -> Tuple[Any, ...]:
        return CorError, (int(self.status), self.index)


class CorWarning(UserWarning):
    """A status of cor for results that do not meet the request, such as a tolerance that was not reached."""

    __module__ = "cor"


def string(text: Any) -> str:
    """Returns a string of C; "" for NULL."""
    return "" if text == ffi.NULL else str(ffi.string(text).decode(errors="replace"))


def number(name: str, value: Any, integer: bool = False, least: int = 0) -> Any:
    """Returns a number for C. The error names the argument."""
    kind = "an integer" if integer else "a real number"
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        made = operator.index(value) if integer else float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: {kind} is needed, not {type(value).__name__}") from None
    except OverflowError:
        raise OverflowError(f"{name}: an integer too large for a double; allowed: up to 1.8e308 in magnitude") from None
    if integer and not least <= made < 2**63:
        raise OverflowError(f"{name}: {made} is out of range; allowed: {least} to 2^63 - 1")
    return made


def one_of(argument: str, value: object, allowed: Sequence[str]) -> int:
    """Returns the index of a name, which may have _ or a space for each hyphen."""
    names = [re.sub("[_ ]", "-", str(name).lower()) for name in (value, *allowed)]
    if names[0] not in names[1:]:
        raise ValueError(f"{argument}: {value!r}; allowed: {', '.join(allowed)}")
    return names.index(names[0], 1) - 1


def mask_of(values: Sequence[Any], shape: Tuple[int, ...]) -> Any:
    """Returns a mask of the elements with a masked argument; nomask if no argument is a masked array."""
    masks = [ma.getmaskarray(v) for v in values if isinstance(v, ma.MaskedArray)]
    return np.logical_or.reduce([np.broadcast_to(mask, shape) for mask in masks]) if masks else ma.nomask


def like(values: Sequence[Any], result: Any) -> Any:
    """Returns the result with the mask of the arguments, or with the index of a pandas object among them."""
    mask = mask_of(values, np.shape(result))
    if mask is not ma.nomask:
        return ma.array(result, mask=mask)
    frames = [v for v in values if type(v).__module__.startswith("pandas.") and np.shape(v) == np.shape(result) != ()]
    frames = [v for v in frames if hasattr(v, "index")]
    if not frames:
        return result
    if any(not v.index.equals(frames[0].index) for v in frames):
        raise ValueError("the arguments have different indexes; give them one index, for example by Series.align")
    first = frames[0]
    labels = {"columns": first.columns} if hasattr(first, "columns") else {"name": first.name}
    return type(first)(result, index=first.index, **labels)


def in_parts(size: int, run: Callable[[int, int], None]) -> None:
    """Calls run(first, count) for all elements in parts of a tenth of a second. Ctrl-C ends the call after a part."""
    first, count = 0, 8
    while first < size or first == 0:
        start = time.monotonic()
        run(first, min(count, size - first))
        first += count
        count = 2 * count if time.monotonic() - start < 0.05 else max(count // 2, 1)


def judge(status: Array) -> None:
    """Raises for the lowest status that is an error; otherwise warns of the first that is not COR_OK."""
    from .status import Status

    if not status.any():
        return
    for number in np.unique(status[status != 0]):
        if Status(int(number)).name.startswith("ERROR_"):
            raise CorError(int(number), tuple(int(i) for i in np.argwhere(status == number)[0]))
    first = status[status != 0].flat[0]
    warnings.warn(string(lib.cor_status_text(int(first))), CorWarning, caller())


def caller() -> int:
    """Returns the stacklevel, counted from judge, of the first caller outside this package."""
    level = 2
    frame = sys._getframe(2)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == __package__:
        frame = frame.f_back
        level += 1
    return level


class Struct:
    """An immutable struct of C that functions accept."""

    _struct: ClassVar[str]
    _fields: ClassVar[Tuple[str, ...]]
    __slots__ = ("_c",)

    def __init__(self, *fields: float) -> None:
        kinds = dict(ffi.typeof(f"struct {self._struct}").fields)
        given = [number(n, v, kinds[n].type.cname != "double") for n, v in zip(self._fields, fields)]
        self._c = ffi.new(f"struct {self._struct} *", given)

    @classmethod
    def _of(cls: "type[S]", c: Any) -> S:
        made = cls.__new__(cls)
        made._c = c
        return made

    def __getattr__(self, name: str) -> Any:
        if name not in self._fields:
            raise AttributeError(f"{type(self).__name__} has no {name}; it has {', '.join(self._fields)}")
        return getattr(self._c, name)

    def _values(self) -> Tuple[Any, ...]:
        return tuple(getattr(self._c, field) for field in self._fields)

    def __repr__(self) -> str:
        fields = ", ".join(f"{name}={value!r}" for name, value in zip(self._fields, self._values()))
        return f"{type(self).__name__}({fields})"

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self._values() == other._values()  # type: ignore[attr-defined]

    def __hash__(self) -> int:
        return hash((type(self), self._values()))

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), self._values()


def pointer(struct: Any, name: str, argument: str = "") -> Any:
    """Returns the address of a struct of this name. A number is accepted in place
    of the struct of a rigid wall, as its tolerance."""
    if getattr(struct, "_struct", None) == name:
        return struct._c
    if name == "cor_disk_hard_wall_options" and isinstance(struct, (int, float, np.number)):
        return ffi.new(f"struct {name} *", {"tolerance": float(struct)})
    raise TypeError(f"{argument and argument + ': '}{type(struct).__name__} is not a struct {name}")


def address(array: Array, writable: bool = False) -> Any:
    """Returns the address of a contiguous array's first element, for C. It keeps the array alive."""
    return ffi.from_buffer(_POINTER[array.dtype], array, writable)


def _is_narrow(value: Any, array: Array, name: str) -> Optional[bool]:
    """True if a real number's type fits in float32; None for a Python number, which adopts the others' type."""
    if array.dtype.kind == "O":
        for element in array.flat:
            number(name, element)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name}: a real number is needed, not {array.dtype}")
    if type(value) in (int, float):
        return None
    return bool(np.can_cast(array.dtype, _FLOAT32))


def _integers(array: Array, dtype: "np.dtype[Any]", name: str) -> Array:
    if array.dtype.kind not in "biu":
        raise TypeError(f"{name}: an integer is needed, not {array.dtype}")
    if array.dtype != dtype:
        limits = np.iinfo(dtype)
        if array.size and (int(array.min()) < limits.min or int(array.max()) > limits.max):
            raise OverflowError(f"{name}: an integer is outside {limits.min} to {limits.max}")
    return array.astype(dtype, order="C", copy=False)


def prepared_array(array: Array, dtype: "np.dtype[Any]") -> Array:
    """Returns an array of this dtype, contiguous and aligned, as C needs it. It is copied only if necessary."""
    array = array.astype(dtype, order="C", copy=False)
    return array if array.flags.aligned else array.copy()


class _Function:
    """A function of C. names: the arguments except the struct of results, which is argument number `out` in C.
    fixed: number of leading arguments that all elements share. They also share the structs. All other arguments are
    numbers or arrays."""

    def __init__(self, name: str, names: str, out: Optional[int] = None, fixed: int = 0) -> None:
        self._c = getattr(lib, name)
        c_type = ffi.typeof(self._c)
        kinds = list(c_type.args)
        self._out = None if out is None else kinds.pop(out).item.cname[len("struct ") :]
        self._result = _DTYPE.get(c_type.result, _INTC)
        structs = [kind.item.cname[len("struct ") :] if kind.kind == "pointer" else "" for kind in kinds]
        self._structs = [(i, struct) for i, struct in enumerate(structs) if struct]
        self._numbers = [i for i, struct in enumerate(structs) if i >= fixed and not struct]
        self._dtypes = [_DTYPE.get(kind, _INTC) for kind in kinds]
        self._names = names.split()

    def _pointers(self, given: Sequence[Any]) -> List[Any]:
        """Returns the arguments with structs replaced by their addresses."""
        made = list(given)
        for i, struct in self._structs:
            made[i] = pointer(made[i], struct, self._names[i])
        return made

    def _arrays(self, given: Sequence[ArrayLike], has_float: bool) -> Tuple[List[Array], bool]:
        """Returns the numbers as arrays of types that C accepts, and True if the result must be float32."""
        arrays = [np.asarray(given[i]) for i in self._numbers]
        kinds = [(a, self._dtypes[i], self._names[i]) for a, i in zip(arrays, self._numbers)]
        reals = [_is_narrow(given[i], a, n) for (a, dtype, n), i in zip(kinds, self._numbers) if dtype == _FLOAT64]
        narrow = True in reals and False not in reals
        real = _FLOAT32 if narrow and has_float else _FLOAT64
        return [prepared_array(a, real) if k == _FLOAT64 else _integers(a, k, name) for a, k, name in kinds], narrow


def _shape(arrays: List[Array]) -> Tuple[int, ...]:
    return arrays[0].shape if len(arrays) == 1 else np.broadcast_shapes(*[a.shape for a in arrays])


class Elementwise(_Function):
    """A function that returns a number. It has a loop in C, and with has_float also a float loop. Without has_float the
    double result is rounded once for float32 arguments."""

    def __init__(self, name: str, names: str, fixed: int = 0, has_float: bool = False) -> None:
        super().__init__(name, names, None, fixed)
        loop = "cor_loop_" + name[len("cor_") :]
        self._loop = getattr(lib, loop)
        self._float_loop = getattr(lib, loop + "f") if has_float else None

    def __call__(self, given: Sequence[Any], out: Optional[Array] = None) -> Any:
        pointers = self._pointers(given) if self._structs else given
        if out is None and self._result is _FLOAT64:
            for i in self._numbers:
                if type(given[i]) not in _NUMBERS and not isinstance(given[i], IntEnum):
                    break
            else:  # only numbers: no arrays are made
                try:
                    return _number(self._c(*pointers))
                except (OverflowError, TypeError):  # integer too large for a double; fraction for an integer
                    pass
        values = [given[i] for i in self._numbers]
        arrays, narrow = self._arrays(given, self._float_loop is not None)
        shape = _shape(arrays) if arrays else ()
        in_float = narrow and self._float_loop is not None
        loop = self._float_loop if in_float else self._loop
        dtype = _FLOAT32 if in_float else self._result
        final = _FLOAT32 if narrow and self._result is _FLOAT64 else self._result
        result = np.empty(shape, dtype) if not fits(out, arrays, shape, dtype) else out
        assert result is not None and loop is not None
        if out is not None:
            check_out(out, shape, final)
        arguments = [p for i, p in enumerate(pointers) if i not in self._numbers]
        for array in arrays:  # address and step; elements are repeated if broadcasting needs it
            if array.size not in (1, result.size):
                array = np.ascontiguousarray(np.broadcast_to(array, shape))
            arguments += [address(array), int(array.size == result.size)]
        loop(*arguments, address(result, True), result.size)
        if out is None:
            with np.errstate(over="ignore"):
                return like(values, result.astype(final, copy=False)[() if shape == () else ...])
        if isinstance(out, ma.MaskedArray):
            out.mask = mask_of(values, shape)
        if result is not out:
            with np.errstate(over="ignore"):
                np.copyto(out, result, casting="same_kind")
        return out


def fits(out: Optional[Array], arrays: List[Array], shape: Tuple[int, ...], dtype: "np.dtype[Any]") -> bool:
    """True if C may write to out: it has the format of the results, and no other array overlaps it."""
    if not isinstance(out, np.ndarray) or out.dtype != dtype or out.shape != shape:
        return False
    if not (out.flags.c_contiguous and out.flags.aligned and out.flags.writeable):
        return False
    return not any(
        np.may_share_memory(out, a) and (a.ctypes.data, a.nbytes) != (out.ctypes.data, out.nbytes) for a in arrays
    )


def check_out(out: Any, shape: Tuple[int, ...], dtype: "np.dtype[Any]") -> None:
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out must be an array, not {type(out).__name__}")
    if out.shape != shape:
        raise ValueError(f"out has the shape {out.shape}, but the result has {shape}")
    if not np.can_cast(dtype, out.dtype, "same_kind"):
        raise TypeError(f"{dtype} cannot be stored in {out.dtype}")
    if not out.flags.writeable:
        raise ValueError("out is read-only")


def plain_dtype(struct: str) -> "np.dtype[Any]":
    """Returns a dtype with the fields of a struct."""
    kinds = {"double": np.float64, "int": np.intc, "size_t": np.uintp, "unsigned long": np.uintp}
    c_type = ffi.typeof(f"struct {struct}")
    names, fields = zip(*c_type.fields)
    formats = [kinds[field.type.cname] for field in fields]
    offsets = [field.offset for field in fields]
    return np.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": ffi.sizeof(c_type)})


def record_dtype(struct: str) -> "np.dtype[Any]":
    """Returns a dtype with the fields of a struct of results, followed by the status."""
    plain = plain_dtype(struct)
    names, size = plain.names or (), plain.itemsize
    formats = [plain[name] for name in names] + [np.dtype(np.intc)]
    offsets = [plain.fields[name][1] for name in names] + [size]  # type: ignore[index]
    with_status = {"names": [*names, "status"], "formats": formats, "offsets": offsets, "itemsize": size + 8}
    return np.dtype((np.record, np.dtype(with_status)))  # type: ignore[call-overload]


class Record(_Function):
    """A function that returns a status and fills a struct of results. In Python it returns a record of the fields and
    the status, or an array of records."""

    def __init__(self, name: str, names: str, out: int = -1) -> None:
        super().__init__(name, names, out)
        self._at = out % (len(self._names) + 1)
        self._dtype = record_dtype(str(self._out))

    def _run(self, given: Sequence[Any]) -> Array:
        arrays, _ = self._arrays(given, False)
        shape = _shape(arrays) if arrays else ()
        result = np.zeros(shape, self._dtype)
        first, size = ffi.from_buffer("char[]", result, True), self._dtype.itemsize
        arguments = self._pointers(given)
        columns = [np.broadcast_to(array, shape).ravel().tolist() for array in arrays]
        status = np.zeros(result.size, np.intc)
        for k in range(result.size):
            for i, column in zip(self._numbers, columns):
                arguments[i] = column[k]
            to = ffi.cast(f"struct {self._out} *", first + k * size)
            status[k] = self._c(*arguments[: self._at], to, *arguments[self._at :])
        result["status"] = status.reshape(shape)
        mask = mask_of([given[i] for i in self._numbers], shape)
        judge(np.where(mask, 0, result["status"]))
        whole: Array = result if mask is ma.nomask else ma.array(result, mask=mask)
        return whole

    def __call__(self, given: Sequence[Any]) -> Any:
        result = self._run(given)
        return result if isinstance(result, ma.MaskedArray) else result.view(np.recarray)[()]


class Init(Record):
    """A function that fills a struct that other functions accept."""

    def __init__(self, name: str, names: str) -> None:
        super().__init__(name, names, 0)

    def __call__(self, given: Sequence[Any]) -> Any:
        for name, value in zip(self._names, given):
            if np.ndim(value):
                raise TypeError(f"{name}: a number is needed, not an array")
        made = ffi.new(f"struct {self._out} *")
        ffi.memmove(made, ffi.from_buffer("char[]", self._run(given)), ffi.sizeof(f"struct {self._out}"))
        return made
