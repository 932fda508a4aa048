# SPDX-License-Identifier: MIT
"""Broadcasting, dtypes, structs and errors: how the generated modules call the loops of the C module."""

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

_POINTER = {
    np.dtype(np.float64): "double[]",
    np.dtype(np.float32): "float[]",
    np.dtype(np.intc): "int[]",
    np.dtype(np.uintp): "size_t[]",
}
_INTEGER = {"i": np.dtype(np.intc), "n": np.dtype(np.uintp)}
_FLOAT64: "np.dtype[Any]" = np.dtype(np.float64)
_FLOAT32: "np.dtype[Any]" = np.dtype(np.float32)
_number = np.float64
_NUMBERS = frozenset((float, int, _number))


class CorError(ValueError):
    """A status of cor that is an error. status is its number, a cor.status.Status; index is the place of the first
    element that has it, () for a single result."""

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
    """A status of cor that comes with results, which are less than was asked for."""

    __module__ = "cor"


def string(text: Any) -> str:
    """A string of C; "" for NULL."""
    return "" if text == ffi.NULL else str(ffi.string(text).decode(errors="replace"))


def number(name: str, value: Any, integer: bool = False, least: int = 0) -> Any:
    """A number for C; the error names the argument."""
    kind = "an integer" if integer else "a real number"
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        made = operator.index(value) if integer else float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: {kind} is needed, not {type(value).__name__}") from None
    except OverflowError:
        raise OverflowError(f"{name}: an integer beyond the doubles; allowed: up to 1.8e308 in size") from None
    if integer and not least <= made < 2**63:
        raise OverflowError(f"{name}: {made} is not from {least} to 2^63 - 1")
    return made


def one_of(argument: str, value: object, allowed: Sequence[str]) -> int:
    """The index of a name, which may have _ or a space for each hyphen."""
    names = [re.sub("[_ ]", "-", str(name).lower()) for name in (value, *allowed)]
    if names[0] not in names[1:]:
        raise ValueError(f"{argument}: {value!r}; allowed: {', '.join(allowed)}")
    return names.index(names[0], 1) - 1


def mask_of(values: Sequence[Any], shape: Tuple[int, ...]) -> Any:
    """Where one of the numbers is masked; nomask: none of them is a masked array."""
    masks = [np.ma.getmaskarray(v) for v in values if isinstance(v, np.ma.MaskedArray)]
    return np.logical_or.reduce([np.broadcast_to(mask, shape) for mask in masks]) if masks else np.ma.nomask


def like(values: Sequence[Any], result: Any) -> Any:
    """The result with the mask of the arguments, or with the index of a Series or DataFrame of pandas among them."""
    mask = mask_of(values, np.shape(result))
    if mask is not np.ma.nomask:
        return np.ma.array(result, mask=mask)
    frames = [v for v in values if type(v).__module__.startswith("pandas.") and np.shape(v) == np.shape(result) != ()]
    frames = [v for v in frames if hasattr(v, "index")]
    if not frames:
        return result
    if any(not v.index.equals(frames[0].index) for v in frames):
        raise ValueError("the arguments have different indexes; allowed: one index, as Series.align gives")
    first = frames[0]
    labels = {"columns": first.columns} if hasattr(first, "columns") else {"name": first.name}
    return type(first)(result, index=first.index, **labels)


def in_parts(size: int, run: Callable[[int, int], None]) -> None:
    """Calls run(first, count) for all elements, in parts of a tenth of a second, between which Ctrl-C ends the call."""
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
    """The stacklevel, seen from judge, of the first caller outside this package."""
    level = 2
    frame = sys._getframe(2)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == __package__:
        frame = frame.f_back
        level += 1
    return level


class Struct:
    """A struct of C that functions take. It cannot be changed."""

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

    @classmethod
    def _of_fields(cls: "type[S]", *fields: float) -> S:
        return cls._of(ffi.new(f"struct {cls._struct} *", fields))

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
        return type(self)._of_fields, self._values()


def pointer(struct: Any, name: str, argument: str = "") -> Any:
    """The address of a struct, which has to be the one named. A number is the tolerance of a rigid wall."""
    if getattr(struct, "_struct", None) == name:
        return struct._c
    if name == "cor_disk_hard_wall_options" and isinstance(struct, (int, float, np.number)):
        return ffi.new(f"struct {name} *", {"tolerance": float(struct)})
    raise TypeError(f"{argument and argument + ': '}{type(struct).__name__} is not a struct {name}")


def address(array: Array, writable: bool = False) -> Any:
    """The address of the first element of a contiguous array, for C; it keeps the array alive."""
    return ffi.from_buffer(_POINTER[array.dtype], array, writable)


def _is_narrow(value: Any, array: Array, name: str) -> Optional[bool]:
    """Whether a real number is no wider than float32; None for a number of Python, which takes the type of others."""
    if array.dtype.kind == "O":
        for element in array.flat:
            number(name, element)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name}: a real number is needed, not {array.dtype}")
    if type(value) in (int, float):
        return None
    return bool(np.can_cast(array.dtype, _FLOAT32))


def _integers(array: Array, kind: str, name: str) -> Array:
    dtype = _INTEGER[kind]
    if array.dtype.kind not in "biu":
        raise TypeError(f"{name}: an integer is needed, not {array.dtype}")
    if array.dtype != dtype:
        limits = np.iinfo(dtype)
        if array.size and (int(array.min()) < limits.min or int(array.max()) > limits.max):
            raise OverflowError(f"{name}: an integer is outside {limits.min} to {limits.max}")
    return array.astype(dtype, order="C", copy=False)


def prepared_array(array: Array, dtype: "np.dtype[Any]") -> Array:
    """As C reads it: of this dtype, contiguous and aligned; copied only where it has to be."""
    array = array.astype(dtype, order="C", copy=False)
    return array if array.flags.aligned else array.copy()


class _Loop:
    """The numbers of one call: kinds has one letter for each, d for a real number, i for int, n for size_t; names are
    those of the arguments, with spaces between."""

    def __init__(self, kinds: str, names: str) -> None:
        self._kinds = kinds
        self._names = names.split()

    def _arrays(self, values: Sequence[ArrayLike], has_float: bool) -> Tuple[List[Array], bool]:
        """The numbers as arrays of the types that C takes; and whether the result is to be float32."""
        arrays = [np.asarray(value) for value in values]
        given = zip(values, arrays, self._kinds, self._names)
        reals = [_is_narrow(v, a, name) for v, a, kind, name in given if kind == "d"]
        narrow = True in reals and False not in reals
        real = _FLOAT32 if narrow and has_float else _FLOAT64
        kinds = zip(arrays, self._kinds, self._names)
        made = [prepared_array(a, real) if kind == "d" else _integers(a, kind, name) for a, kind, name in kinds]
        return made, narrow

    @staticmethod
    def _arguments(arrays: List[Array], shape: Tuple[int, ...], size: int) -> List[Any]:
        """Address and step of each array, repeated where broadcasting needs it."""
        arguments = []
        for array in arrays:
            if array.size == size:
                step = 1
            elif array.size == 1:
                step = 0
            else:
                array = np.ascontiguousarray(np.broadcast_to(array, shape))
                step = 1
            arguments += [address(array), step]
        return arguments


def _shape(arrays: List[Array]) -> Tuple[int, ...]:
    return arrays[0].shape if len(arrays) == 1 else np.broadcast_shapes(*[a.shape for a in arrays])


class Elementwise(_Loop):
    """A function that returns a number. result is d for a real number or n for size_t; has_float says whether there
    is a loop in float, too. Otherwise the double result is rounded once for arguments of float32."""

    def __init__(self, name: str, kinds: str, result: str, has_float: bool, names: str) -> None:
        super().__init__(kinds, names)
        loop = "cor_loop_" + name[len("cor_") :]
        self._loop = getattr(lib, loop)
        self._float_loop = getattr(lib, loop + "f") if has_float else None
        self._result = _FLOAT64 if result == "d" else _INTEGER[result]
        self._scalar = getattr(lib, name, None)

    def __call__(self, structs: Tuple[Any, ...], values: Tuple[ArrayLike, ...], out: Optional[Array] = None) -> Any:
        if out is None and self._scalar is not None:
            for value in values:
                if type(value) not in _NUMBERS and not isinstance(value, IntEnum):
                    break
            else:  # numbers alone: no arrays are made
                try:
                    return _number(self._scalar(*structs, *values))
                except (OverflowError, TypeError):  # an integer beyond the doubles; a fraction for an integer
                    pass
        arrays, narrow = self._arrays(values, self._float_loop is not None)
        shape = _shape(arrays) if arrays else ()
        in_float = narrow and self._float_loop is not None
        loop = self._float_loop if in_float else self._loop
        dtype = _FLOAT32 if in_float else self._result
        final = _FLOAT32 if narrow and self._result is _FLOAT64 else self._result
        result = np.empty(shape, dtype) if not fits(out, arrays, shape, dtype) else out
        assert result is not None and loop is not None
        if out is not None:
            check_out(out, shape, final)
        loop(*structs, *self._arguments(arrays, shape, result.size), address(result, True), result.size)
        if out is None:
            return like(values, result.astype(final, copy=False)[() if shape == () else ...])
        if isinstance(out, np.ma.MaskedArray):
            out.mask = mask_of(values, shape)
        if result is not out:
            np.copyto(out, result, casting="same_kind")
        return out


def fits(out: Optional[Array], arrays: List[Array], shape: Tuple[int, ...], dtype: "np.dtype[Any]") -> bool:
    """Whether C may write to out: it has to be as C wants it, and may be an argument, but not overlap one by a part."""
    if not isinstance(out, np.ndarray) or out.dtype != dtype or out.shape != shape:
        return False
    if not (out.flags.c_contiguous and out.flags.aligned and out.flags.writeable):
        return False
    return not any(
        np.may_share_memory(out, a) and (a.ctypes.data, a.nbytes) != (out.ctypes.data, out.nbytes) for a in arrays
    )


def check_out(out: Any, shape: Tuple[int, ...], dtype: "np.dtype[Any]") -> None:
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out is to be an array, not {type(out).__name__}")
    if out.shape != shape:
        raise ValueError(f"out has the shape {out.shape}, the result {shape}")
    if not np.can_cast(dtype, out.dtype, "same_kind"):
        raise TypeError(f"{dtype} cannot be stored in {out.dtype}")
    if not out.flags.writeable:
        raise ValueError("out is read-only")


def plain_dtype(struct: str) -> "np.dtype[Any]":
    """The fields of a struct."""
    kinds = {"double": np.float64, "int": np.intc, "size_t": np.uintp, "unsigned long": np.uintp}
    c_type = ffi.typeof(f"struct {struct}")
    names, fields = zip(*c_type.fields)
    formats = [kinds[field.type.cname] for field in fields]
    offsets = [field.offset for field in fields]
    return np.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": ffi.sizeof(c_type)})


def record_dtype(struct: str) -> "np.dtype[Any]":
    """The fields of a struct of results, and behind them the status."""
    plain = plain_dtype(struct)
    names, size = plain.names or (), plain.itemsize
    formats = [plain[name] for name in names] + [np.dtype(np.intc)]
    offsets = [plain.fields[name][1] for name in names] + [size]  # type: ignore[index]
    with_status = {"names": [*names, "status"], "formats": formats, "offsets": offsets, "itemsize": size + 8}
    return np.dtype((np.record, np.dtype(with_status)))  # type: ignore[call-overload]


class _Records(_Loop):
    def __init__(self, name: str, out: str, kinds: str, names: str) -> None:
        super().__init__(kinds, names)
        self._loop = getattr(lib, "cor_loop_" + name[len("cor_") :])
        self._out = out
        self._dtype = record_dtype(out)

    def _run(self, structs: Tuple[Any, ...], values: Tuple[ArrayLike, ...]) -> Array:
        arrays, _ = self._arrays(values, False)
        shape = _shape(arrays) if arrays else ()
        result = np.zeros(shape, self._dtype)
        arguments, size = self._arguments(arrays, shape, result.size), self._dtype.itemsize
        at = ffi.from_buffer("char[]", result, True)

        def run(first: int, count: int) -> None:
            steps = arguments[1::2]
            given = [x for a, step in zip(arguments[::2], steps) for x in (a + first * step, step)]
            self._loop(*structs, *given, at + first * size, size, count)

        in_parts(result.size, run)
        mask = mask_of(values, shape)
        judge(np.where(mask, 0, result["status"]))
        return result if mask is np.ma.nomask else np.ma.array(result, mask=mask)


class Record(_Records):
    """A function that returns a status and a struct of results: a record with these fields and the status, or an array
    of records."""

    def __call__(self, structs: Tuple[Any, ...], values: Tuple[ArrayLike, ...]) -> Any:
        result = self._run(structs, values)
        return result if isinstance(result, np.ma.MaskedArray) else result.view(np.recarray)[()]


class Init(_Records):
    """A function that fills a struct which other functions take."""

    def __call__(self, structs: Tuple[Any, ...], values: Tuple[ArrayLike, ...]) -> Any:
        for name, value in zip(self._names, values):
            if np.ndim(value):
                raise TypeError(f"{name}: a number is needed, not an array")
        result = self._run(structs, values)
        made = ffi.new(f"struct {self._out} *")
        ffi.memmove(made, ffi.from_buffer("char[]", result), ffi.sizeof(f"struct {self._out}"))
        return made
