# SPDX-License-Identifier: MIT
"""Tests own laws: corgen's numbers and compiled headers against NumPy's long doubles and SciPy's PCHIP."""

import ctypes
import os
import random
import subprocess

import numpy as np
import pytest

interpolate = pytest.importorskip("scipy.interpolate")
CORGEN = os.environ.get("CORGEN", "build/corgen")
SEED = random.SystemRandom().getrandbits(32)
LONG = np.longdouble


def laws(folder):
    """Returns options, range and eps of each law. The table has unequal distances, and eps rises, falls and is
    constant."""
    rng = np.random.default_rng(SEED)
    rows = int(rng.integers(2, 40))
    speed = np.cumsum(rng.uniform(0.01, 1, rows)) * 10 ** rng.uniform(-3, 0)
    table = [(float(f"{v:.9g}"), float(f"{e:.3g}")) for v, e in zip(speed, rng.choice(rng.uniform(0.1, 1, 5), rows))]
    text = "\ufeffn, eps ,speed_m_s\r\n# rows\r\n" + "".join(f"1,{e!r},{v!r}\r\n" for v, e in table)
    (folder / "table.csv").write_bytes(text.encode())
    # SciPy has no PCHIP of two rows
    pchip = interpolate.PchipInterpolator(*zip(*table)) if len(table) > 2 else lambda v: np.interp(v, *zip(*table))
    ice = lambda v: np.minimum(1, LONG("0.115739") * v ** -LONG("0.234"))  # noqa: E731
    decay = lambda v: LONG("0.3") + LONG("0.7") * np.exp(-v / LONG("0.01"))  # noqa: E731
    return [
        ("power-law --coefficient 0.115739 --exponent 0.234", 1e-6, 1.0, ice),
        ("exponential --eps-inf 0.3 --decay-speed 0.01", 1e-4, 10.0, decay),
        (f"table --table {folder}/table.csv", table[0][0], table[-1][0], pchip),
    ]


def output(command, *words):
    run = subprocess.run([CORGEN, command, *words], stdout=subprocess.PIPE, universal_newlines=True)
    assert run.returncode == 0, f"seed {SEED}: {command} {words}"
    return run.stdout


LOOP = """
void loop(const {type} *v, {type} *eps, int n) {{ for (int i = 0; i < n; i++) eps[i] = f(v[i]); }}
double call(double v) {{ return f_callback(0, v); }}
"""


@pytest.mark.parametrize("number", range(3))
@pytest.mark.parametrize("kind, language, tolerance", [("double", "c", 1e-9), ("float", "c++", 1e-5)])
def test_headers(tmp_path, number, kind, language, tolerance):
    law, low, high, eps = laws(tmp_path)[number]
    scene = ["--law", *law.split(), "--speed-min", repr(low), "--speed-max", repr(high)]
    (tmp_path / "f.h").write_text(
        output("embed", *scene, "--tolerance", str(tolerance), "--type", kind, "--name", "f", "--for", "rebound")
    )
    begin, end = ('extern "C" {', "}") if language == "c++" else ("", "")
    source = f'#include "f.h"\n#include "f.h"\n{begin}{LOOP.format(type=kind)}{end}\n'
    flags = ["-std=c++11"] if language == "c++" else ["-std=c99", "-Wc++-compat"]
    command = ["cc", "-x", language, *flags, *"-O2 -Wall -Wextra -Wconversion -Wdouble-promotion -Werror".split()]
    command += ["-shared", "-fPIC", f"-I{tmp_path}", "-o", str(tmp_path / "f.so"), "-"]
    subprocess.run(command, input=source, universal_newlines=True, check=True)
    made = ctypes.CDLL(str(tmp_path / "f.so"))
    made.call.restype, made.call.argtypes = ctypes.c_double, [ctypes.c_double]
    real = np.float32 if kind == "float" else np.float64
    speed = np.exp(np.random.default_rng(SEED).uniform(np.log(low), np.log(high), 5000)).astype(real)
    speed = np.clip(speed, real(low), real(high))
    got = np.empty_like(speed)
    made.loop(speed.ctypes.data_as(ctypes.c_void_p), got.ctypes.data_as(ctypes.c_void_p), len(speed))
    inside = np.clip(speed.astype(np.float64), low, high)  # the header's limits are rounded to float
    exact = eps(inside.astype(LONG) if "table" not in law else inside)
    assert np.max(np.abs(got / exact - 1)) <= tolerance * 1.0001, f"seed {SEED}"
    assert made.call(-float(speed[0])) == float(got[0]) and np.isnan(made.call(float("nan")))


def test_contact_sample_and_plan(tmp_path):
    for law, low, high, eps in laws(tmp_path):
        words = ["--law", *law.split()]
        speed = np.geomspace(low, high, 9)[1:-1]
        rows = output("contact", *words, "--speed", ",".join(map(repr, map(float, speed))), "--format", "csv").split()
        assert rows[0] == "speed_m_s,eps"
        assert [float(row.split(",")[1]) for row in rows[1:]] == pytest.approx(
            list(eps(speed).astype(float)), rel=1e-11
        )
        words += ["--speed-min", repr(low), "--speed-max", repr(high), "--tolerance", "1e-3", "--format", "csv"]
        points = np.array([row.split(",") for row in output("sample", *words).split()[1:]], float)
        tried = np.geomspace(low, high, 3001)
        assert np.max(np.abs(np.interp(tried, *points.T) / eps(tried) - 1)) < 1.001e-3, f"seed {SEED}"
        rows = [row.split(",") for row in output("plan", *words, "--points", "5").split("\n")[1:-1]]
        chosen = [float(row[2]) for row in rows if row[-1] == "chosen"]
        assert np.max(np.abs(chosen / eps(np.geomspace(low, high, 5)) - 1)) <= 1e-3, f"seed {SEED}"
