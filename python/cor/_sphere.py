# SPDX-License-Identifier: MIT
"""The functions of sphere.h that are arrays in float arithmetic and have no other form."""

from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._cor import lib
from ._docs import DOCS
from ._evaluate import Array, address, check_out, fits, prepared_array

_FLOAT32: "np.dtype[Any]" = np.dtype(np.float32)


def _fast_array(name: str) -> Callable[..., Any]:
    function = getattr(lib, f"cor_sphere_{name}")

    def fast(x: ArrayLike, /, *, out: Optional[Array] = None) -> Any:
        given = np.asarray(x)
        if not np.can_cast(given.dtype, _FLOAT32):
            raise TypeError(f"an array of float32 is needed, not of {given.dtype}")
        numbers = prepared_array(given, _FLOAT32)
        if out is not None:
            check_out(out, numbers.shape, _FLOAT32)
        result = out if fits(out, [numbers], numbers.shape, _FLOAT32) else np.empty(numbers.shape, _FLOAT32)
        assert result is not None
        function(address(numbers), address(result, True), result.size)
        if out is not None and result is not out:
            np.copyto(out, result, casting="same_kind")
        return result[()] if out is None else out

    fast.__name__ = fast.__qualname__ = name
    fast.__doc__ = f"Takes and returns float32.\n\n{DOCS[f'cor_sphere_{name}']}\n\nC: cor_sphere_{name}"
    return fast


eps_zero_overlap_fast_arrayf = _fast_array("eps_zero_overlap_fast_arrayf")
eps_zero_force_fast_arrayf = _fast_array("eps_zero_force_fast_arrayf")
loss_zero_overlap_fast_arrayf = _fast_array("loss_zero_overlap_fast_arrayf")
loss_zero_force_fast_arrayf = _fast_array("loss_zero_force_fast_arrayf")
duration_zero_overlap_fast_arrayf = _fast_array("duration_zero_overlap_fast_arrayf")
duration_zero_force_fast_arrayf = _fast_array("duration_zero_force_fast_arrayf")
max_overlap_fast_arrayf = _fast_array("max_overlap_fast_arrayf")
time_of_max_overlap_fast_arrayf = _fast_array("time_of_max_overlap_fast_arrayf")
