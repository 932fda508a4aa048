# SPDX-License-Identifier: MIT
"""Time of functions of the package on arrays, against the same array functions called from C with the same arrays.

    python3 arrays.py [ELEMENTS]        10^5 elements unless another number is given

C is called with the addresses of two arrays that exist already. The loop over calls is in Python for both, and its own
time is subtracted. Each figure is the least of many runs; without out= the package also makes the array of results.
"""

import sys
import time

import numpy as np

import cor
from cor._cor import ffi, lib

LINEAR = (lib.COR_LAW_LINEAR, lib.COR_END_ZERO_FORCE, lib.COR_EPS)
FUNCTIONS = (
    ("sphere_eps_zero_force", (), cor.sphere.eps_zero_force, np.float64),
    ("sphere_eps_zero_overlap", (), cor.sphere.eps_zero_overlap, np.float64),
    ("sphere_eps_zero_force", (), cor.sphere.eps_zero_force, np.float32),
    ("law_value", LINEAR, lambda *x, **out: cor.law.value("linear", "zero-force", "eps", *x, **out), np.float64),
)


def least_seconds(call, runs=300):
    best = np.inf
    for _ in range(runs):
        begin = time.perf_counter()
        call()
        best = min(best, time.perf_counter() - begin)
    return best


def main():
    elements = int(sys.argv[1]) if len(sys.argv) > 1 else 100000
    nothing = least_seconds(lambda: None)
    print(f"{'function':28s} {'ns per element: C':>18s} {'Python':>8s} {'out=':>8s} {'ratio':>6s}")
    for name, given, function, dtype in FUNCTIONS:
        x = np.linspace(0.0, 4.0, elements).astype(dtype)
        y = np.empty_like(x)
        narrow = dtype is np.float32
        loop = getattr(lib, f"cor_loop_{name}{'f' if narrow else ''}")
        c_type = "float[]" if narrow else "double[]"
        from_x, to_y = ffi.from_buffer(c_type, x), ffi.from_buffer(c_type, y, True)
        in_c = least_seconds(lambda: loop(*given, from_x, 1, to_y, elements)) - nothing
        in_python = least_seconds(lambda: function(x)) - nothing
        into = least_seconds(lambda: function(x, out=y)) - nothing
        figures = [1e9 * t / elements for t in (in_c, in_python, into)]
        label = name + (" (float)" if narrow else "")
        print(f"{label:28s} {figures[0]:18.3f} {figures[1]:8.3f} {figures[2]:8.3f} {in_python / in_c:6.2f}")


if __name__ == "__main__":
    main()
