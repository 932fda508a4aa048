# SPDX-License-Identifier: MIT
"""The functions of sphere.h in float arithmetic, which have no form in double: ..._fastf and ..._fast_arrayf, each made
when it is imported."""

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._cor import lib
from ._docs import DOCS
from ._evaluate import Array, address, check_out, fits, prepared_array

_FLOAT32: "np.dtype[Any]" = np.dtype(np.float32)
_NUMBERS = frozenset((float, np.float32))


def _float32(x: ArrayLike) -> Array:
    given = np.asarray(x)
    if not np.can_cast(given.dtype, _FLOAT32) and type(x) not in (int, float):
        raise TypeError(f"float32 is needed, not {given.dtype}")
    return prepared_array(given, _FLOAT32)


def __getattr__(name: str) -> Any:
    function = getattr(lib, f"cor_sphere_{name}")

    def of_number(x: ArrayLike, /) -> Any:
        return np.float32(function(x if type(x) in _NUMBERS else _float32(x).item()))

    def of_array(x: ArrayLike, /, *, out: Optional[Array] = None) -> Any:
        numbers = _float32(x)
        if out is not None:
            check_out(out, numbers.shape, _FLOAT32)
        result = out if fits(out, [numbers], numbers.shape, _FLOAT32) else np.empty(numbers.shape, _FLOAT32)
        assert result is not None
        function(address(numbers), address(result, True), result.size)
        if out is not None and result is not out:
            np.copyto(out, result, casting="same_kind")
        return result[()] if out is None else out

    made: Any = of_array if name.endswith("_arrayf") else of_number
    made.__name__ = made.__qualname__ = name
    made.__doc__ = f"Takes and returns float32.\n\n{DOCS[f'cor_sphere_{name}']}\n\nC: cor_sphere_{name}"
    return made
