# SPDX-License-Identifier: MIT
"""Tests that a header in OpenCL C, after the lines in docs/embed.md, gives the bits of C on the first device.

    python3 opencl.py HEADER FUNCTION double|float FOLDER      FOLDER: where a library in C may be written
"""

import ctypes
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pyopencl as cl

header, function, real, folder = sys.argv[1:]
page = Path(__file__).resolve().parents[2] / "docs" / "embed.md"
prelude = re.search(r"```c\n(#pragma OPENCL.*?)```", page.read_text(encoding="utf-8"), re.S)
text = Path(header).read_text(encoding="utf-8")
number = np.dtype(real if real == "double" else "float32")

speeds = np.concatenate([np.exp(np.linspace(-5, 5, 100000)), [0, -0.0, -1, np.inf, np.nan]]).astype(number)
by_opencl, by_c = np.empty_like(speeds), np.empty_like(speeds)

context = cl.create_some_context(interactive=False)
queue = cl.CommandQueue(context)
kernel = f"kernel void run(global {real} *x) {{ const size_t i = get_global_id(0); x[i] = {function}(x[i]); }}\n"
program = cl.Program(context, prelude[1] + text + kernel).build()
buffer = cl.Buffer(context, cl.mem_flags.READ_WRITE | cl.mem_flags.COPY_HOST_PTR, hostbuf=speeds)
program.run(queue, speeds.shape, None, buffer)
cl.enqueue_copy(queue, by_opencl, buffer)

source, library = Path(folder) / "opencl.c", Path(folder) / "opencl.so"
source.write_text(
    f'#include "{header}"\nvoid run(const {real} *x, {real} *y, size_t n);\n'
    f"void run(const {real} *x, {real} *y, size_t n) {{ for (size_t i = 0; i < n; i++) y[i] = {function}(x[i]); }}\n"
)
subprocess.run(["cc", "-O2", "-ffp-contract=off", "-shared", "-fPIC", source, "-o", library], check=True)
ctypes.CDLL(str(library)).run(
    speeds.ctypes.data_as(ctypes.c_void_p), by_c.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(len(speeds))
)
different = (by_opencl.view(f"u{number.itemsize}") != by_c.view(f"u{number.itemsize}")) & ~(np.isnan(by_opencl) & np.isnan(by_c))
print(f"{context.devices}: {different.sum()} of {len(speeds)} differ")
sys.exit(bool(different.any() or not np.isnan(by_c[-1]) or not 0 < by_c[0] < 1))
