# SPDX-License-Identifier: MIT
"""Tests records of laboratories: accepted files, and files refused with line, column and advice."""

import io
import json
import random
import re
import subprocess
import sys
import time

import cor
import numpy as np
import pytest
from cor._command import main
from cor._fit.data import Apexes, DataError, Form, Heights, Points, Times
from cor._fit.records import read

POINTS, TIMES = "speed_m_s,eps\n", "t_s\n"
CARRIED = "run,t_s,h0_cm\na,0,\na,1,\n"


def read_text(text, **form):
    data = text if isinstance(text, bytes) else text.encode()
    return read(io.BytesIO(data), Form(**form))


# text, options, the class of the record, and some of its fields
READ = [
    (b"\xef\xbb\xbfspeed_m_s,eps,eps_sigma\r\n0.1,.95,1e-2", {}, Points, dict(eps=[0.95], sigma=[0.01])),
    ('\n# note\neps,remark,speed_cm_s\n0.95,"a, b",10\n .9 ,,"100"\n', {}, Points, dict(eps=[0.95, 0.9], line=[4, 5])),
    ("speed_m_s;eps\n0,1;0,95\n1;,9\n", dict(decimal_comma=True), Points, dict(speed_m_s=[0.1, 1], eps=[0.95, 0.9])),
    ('speed_m_s\teps\n"0,1"\t0,95\n', dict(decimal_comma=True), Points, dict(speed_m_s=[0.1])),
    ("speed_m_s,eps,a;b;c;d\n1,0.9,0\n", dict(separator=","), Points, dict(eps=[0.9])),
    ("speed,eps\n100,0.9\n", dict(unit="mm/s"), Points, dict(speed_m_s=[0.1])),
    ("Speed (m/s),EPS,Temperature (C)\n1,0.5,20\n", {}, Points, dict(speed_m_s=[1])),
    ("speed_m_s,eps,eps_sigma\n1,1.002,0.01\n2,-0.04,0.01\n", {}, Points, dict(eps=[1.002, -0.04])),
    ("v_in_cm_s,v_out_cm_s\n100,80\n", {}, Points, dict(speed_m_s=[1], eps=[0.8])),
    # eps = 0.8; its error is sqrt((0.8 * 0.03)^2 + 0.032^2)/2 = 0.02
    ("speed_m_s,speed_out_m_s,speed_sigma_m_s,speed_out_sigma_m_s\n2,1.6,.03,.032\n", {}, Points, dict(sigma=[0.02])),
    ("h0_cm,h_1_mm,h1_sigma_cm\n100,640,1\n", {}, Heights, dict(drop_m=[1], rebound_m=[0.64], rebound_sigma_m=[0.01])),
    ("h_0 (cm),h_1 (cm)\n100,64\n,63\n50,30\n", {}, Heights, dict(drop_m=[1, 1, 0.5])),
    ("h0,h1\n100,64\n", dict(unit="cm"), Heights, dict(drop_m=[1], rebound_m=[0.64])),
    ("rebound [cm]\n64\n63\n", dict(drop_height_m=1), Heights, dict(drop_m=[1, 1], rebound_m=[0.64, 0.63])),
    ("h_cm\n64\n40\n", {}, Apexes, dict(height_m=[0.64, 0.4], start=[0, 2])),
    ("ball,apex_cm\nA,64\nB,60\nB,36\n", dict(drop_height_m=1), Apexes, dict(height_m=[1, 0.64, 1, 0.6, 0.36])),
    ("timestamp (ms)\n0\n1000\n1800\n", {}, Times, dict(time_s=[0, 1, 1.8])),
    ('"Latest: Time (s)","Latest: Flag"\n0,a\n1,b\n1.8,c\n', {}, Times, dict(time_s=[0, 1, 1.8])),
    ("t_s\n0\n1\n1.8\n", {}, Times, dict(time_s=[0, 1, 1.8], height_m=[np.nan])),
    ('"Time (ms)"\n0\n1000\n', dict(drop_height_m=1.5), Times, dict(time_s=[0, 1], height_m=[1.5])),
    (CARRIED.replace("0,\n", "0,150\n"), {}, Times, dict(height_m=[1.5])),
    ("run,t_s\na,0\na,1\na,1.8\nb,5\nb,6\nb,6.5\n", {}, Times, dict(start=[0, 3, 6])),
    ("interval_ms\n800\n640\n", {}, Times, dict(time_s=[0, 0.8, 1.44], line=[2, 2, 3])),
    ("run,dt (s)\na,1\na,.8\nb,.9\nb,.8\n", {}, Times, dict(time_s=[0, 1, 1.8, 0, 0.9, 1.7], start=[0, 3, 6])),
    # speed with eps has priority over heights, heights over times
    ("h0_cm,h1_cm,speed_m_s,eps\n100,64,4.4,.81\n", {}, Points, dict(eps=[0.81])),
    ("t_s,h0_cm,h1_cm\n1,100,64\n", {}, Heights, dict(drop_m=[1])),
    ("run,speed_m_s,eps\na,1,.5\nb,2,.4\n", {}, Points, dict(eps=[0.5, 0.4])),
    # files exported by programs: rows above the names, units below the names, runs, empty cells and rows
    ("mass_A\nt\tx\n0E0\t1\n1\t\n1.8\t1\n", dict(unit="s"), Times, dict(time_s=[0, 1, 1.8], line=[3, 4, 5])),
    ("Vernier Format 2\nTime\tForce\nT\tF\nms\tN\n\n0\t1\n1000\t1\n1800\t1\n", {}, Times, dict(time_s=[0, 1, 1.8])),
    ("LabVIEW Measurement\nTime\t9\n***End_of_Header***\t\nX_Value\tA\tComment\n0\t1\n1\t1\n1.8\t1\n", dict(unit="s"),
     Times, dict(time_s=[0, 1, 1.8])),
    ('\ufeff"Time (s) Run #1","Light (lx) Run #1"\n0,1\n1,1\n1.8,\n,\n', {}, Times, dict(time_s=[0, 1, 1.8])),
    ("sep=;\nh0;h1\n(cm);cm\n100;64,5\n;\n", dict(decimal_comma=True), Heights, dict(drop_m=[1], rebound_m=[0.645])),
    ("h0 (inches),h1_ft\n10,.5\n", {}, Heights, dict(drop_m=[0.254], rebound_m=[0.1524])),
    ("v_in (ft/s),v_out_ft_s\n10,8\n", {}, Points, dict(speed_m_s=[3.048], eps=[0.8])),
    ("h_in\n10\n5,\n", {}, Apexes, dict(height_m=[0.254, 0.127])),
    ("v_in,v_out\n10,8\n", dict(unit="cm/s"), Points, dict(speed_m_s=[0.1])),
]  # fmt: skip


@pytest.mark.parametrize("text,form,kind,fields", READ, ids=range(len(READ)))
def test_read(text, form, kind, fields):
    record = read_text(text, **form).record
    assert isinstance(record, kind)
    for name, values in fields.items():
        np.testing.assert_allclose(getattr(record, name), values, rtol=1e-14)


# the message after the name of the file, as a regular expression; text; options
REFUSED = [
    ("line 1: the file is empty; allowed: .*, such as speed_m_s,eps", "", {}),
    ("line 1: '1', '0.5': cor fit reads no such column; allowed: .* speed_m_s,eps", "1,0.5\n2,0.4\n", {}),
    ("line 1: 'Time 1 .s.', 'Time 2 .s.': numbered columns; .* interval_s", "Time 1 (s),Time 2 (s)\n.9,.7\n", {}),
    ("line 2, column t: the name has no unit; .*--unit ms,cm", "mass_A\nt\ty\n0\t1\n", {}),
    ("line 3, column y .m.: 6 rows have no height; allowed: up to 5", "t_s,y (m)\n0,1\n" + "1,\n" * 6 + "2,1\n", {}),
    ("line 1: no column eps or speed_out_m_s; allowed", "speed_m_s,b\n1,0.5\n", {}),
    ("line 1: no column h0_cm, or --drop-height", "h1_cm\n64\n", {}),
    ("line 1, column eps: the file has two columns of this name", "speed_m_s,eps,eps\n1,0.5,0.5\n", {}),
    ("line 1, column speed_mm_s: the file has two columns of speeds; allowed: one", "speed_m_s,speed_mm_s,eps\n", {}),
    ("line 1, column speed_m_s: --unit cm/s contradicts the unit in the name; allowed: ", POINTS, dict(unit="cm/s")),
    ("line 1, column t_s: --unit cm/s does not fit any column", TIMES, dict(unit="cm/s")),
    ("--unit: 'km/h' is not a unit; allowed: m/s, cm/s, mm/s, ft/s, m, cm, mm, in, ft, s", POINTS, dict(unit="km/h")),
    ("line 1, column speed: the name has no unit; allowed: speed_m_s, .*--unit cm/s", "speed,eps\n1,0.5\n", {}),
    ("line 1, column h0: the name has no unit; allowed: h0_m, .* --unit cm", "h0,h1\n1,0.5\n", {}),
    ("line 1, column Time .h.: 'h' is not a unit of time; allowed: s, ms, us", "Time (h)\n1\n", {}),
    ("line 1: the column 'spede_m_s' is unknown, but its name is close to speed_m_s", "spede_m_s,eps\n1,0.5\n", {}),
    ("line 1: the column 'rum' is unknown, but its name is close to run", "rum,t_s\na,0\n", {}),
    ("line 1: the column 'h1 error .cm.' is .* h1_sigma_cm", "h0_cm,h1_cm,h1 error (cm)\n100,64,1\n", {}),
    ("line 3: 1 cell, but .* has 2", POINTS + "1,0.5\n2\n", {}),
    ("line 3: 4 cells, but .* has 2; .* commas, .* decimal point", POINTS + "1,0.5\n0,5,0,85\n", {}),
    ("line 2, column eps: '0,85' has a decimal comma; .* such as 0.85, or --decimal-comma", POINTS + '1,"0,85"\n', {}),
    ("line 2, column eps: '.5' has a decimal point, but .*without", "speed_m_s;eps\n2;.5\n", dict(decimal_comma=True)),
    ("line 1: 'speed_m_s;eps': cor fit reads no such column", "speed_m_s;eps\n1;0.5\n", dict(separator=",")),
    ("line 3, column eps: 'half' is not .*; allowed: a number from 0 to 1, such as 0", POINTS + "1,0.5\n2,half\n", {}),
    ("line 2, column speed_m_s: 'NaN' is not allowed; allowed: a speed above 0 and up", POINTS + "NaN,1\n", {}),
    ("line 3, column speed_m_s: '-2' is not allowed", POINTS + "1,0.5\n-2,0.4\n", {}),
    ("line 2, column speed_m_s: '0' is not allowed", POINTS + "0,0.5\n", {}),
    ("line 2, column speed_m_s: '1_0' is not allowed", POINTS + "1_0,0.5\n", {}),
    ("line 2, column speed_m_s: '\u0661' is not allowed", POINTS + "\u0661,0.5\n", {}),
    *[(f"line 2, column eps: '{v}' is not allowed", f"{POINTS}1,{v}\n", {}) for v in "inf 1.01 -0.1 1/2".split()],
    ("line 2, column eps: the cell is empty; allowed", POINTS + "1,\n2,0.4\n", {}),
    ("line 3, column eps_sigma: '0' is not .*from 1e-30 to 1e30", "speed_m_s,eps,eps_sigma\n1,0.5,0.1\n2,0.4,0\n", {}),
    ("line 2, column eps: '1.06' is 6 eps_sigma beyond 1; .*to 5 eps", "speed_m_s,eps,eps_sigma\n1,1.06,0.01\n", {}),
    ("line 2, column eps: '-0.06' is 6 eps_sigma beyond 0", "speed_m_s,eps,eps_sigma\n1,-0.06,0.01\n", {}),
    ("line 1: the file has no rows of numbers", POINTS, {}),
    ("line 1: the text is UTF-16LE; allowed: UTF-8; convert .* iconv -f UTF-16LE", POINTS.encode("utf-16-le"), {}),
    ("line 1: the text is UTF-16BE", POINTS.encode("utf-16-be"), {}),
    ("line 1: the text is UTF-16LE", b"\xff\xfes\0p\0", {}),
    ("line 2: has a control character", POINTS + "1,0.5\0\n", {}),
    ("line 1: has a control character", "speed_m_s,eps\r1,0.5\r", {}),
    ("line 1: longer than 65536 characters", "x" * 65538, {}),
    ("line 3: longer than 65536 characters", POINTS + "1,1\n" + "x" * 200000, {}),
    ("line 1: 'x{40}': cor fit reads no such column", "x" * 65536, {}),
    ("line 1: more than 256 cells", POINTS.strip() + ",a" * 255, {}),
    ("line 4, column t_s: 0.5 is not after the previous bounce", TIMES + "0\n1\n0.5\n", {}),
    ("line 3, column t_s: '-1' is not allowed; allowed: a time from 0 to", TIMES + "0\n-1\n", {}),
    ("line 2, column h1_cm: '-64' is not allowed; allowed: a height from 0", "h0_cm,h1_cm\n100,-64\n", {}),
    ("line 3, column h_cm: '-64' is not allowed; allowed: a height above 0", "h_cm\n100\n-64\n", {}),
    ("line 4, column t_s: a flight of 1.5 s after one of 1 s gives eps = 1.5; allowed", TIMES + "0\n1\n2.5\n", {}),
    ("line 3, column h1_cm: the rebound gives eps = 1.414", "h0_cm,h1_cm\n100,64\n50,100\n", {}),
    ("line 3, column h_cm: the rebound gives eps = 1.581", "h_cm\n40\n100\n", {}),
    ("line 4, column t_s: the drop before .* has 2 bounces; .* 3 or .*--drop-height", "run,t_s\na,0\na,1\nb,0\n", {}),
    ("line 2, column t_s: the drop has 1 bounce; allowed: 2 or more", TIMES + "1\n", dict(drop_height_m=1.0)),
    ("line 2, column h_cm: the drop has 1 apex", "h_cm\n64\n", {}),
    ("line 1, column eps: t_s already gives speed and eps", "t_s,eps\n0,1\n", {}),
    ("line 2, column Time .s.: 399 steps of 0.001 s belong to a waveform .* 1000 Hz", "", dict(waveform=1e3)),
    ("line 2, column Time .s.: 399 steps of 2.3e-05 s belong to a waveform", "", dict(waveform=44100.0)),
    ("line 2, column Time .s.: 399 steps of 2e-05 s belong to a waveform", "", dict(waveform=44100.0, digits=5)),
    ("line 2, column y .m.: the heights increase downward", "", dict(track=40)),
    ("line 1000002: more than 1000000 rows", POINTS + "1,0.5\n" * 1000001, {}),
]  # fmt: skip


@pytest.mark.parametrize("message,text,form", REFUSED, ids=range(len(REFUSED)))
def test_refused(message, text, form):
    form = dict(form)
    if "waveform" in form:
        rate, digits = form.pop("waveform"), form.pop("digits", 6)
        text = "Time (s),Sound pressure (a.u.)\n" + "".join(f"{k / rate:.{digits}f},{k % 7}\n" for k in range(400))
    if "track" in form:
        text = "t_s,y (m)\n" + "".join(f"{k / 60},{(k / 60) ** 2}\n" for k in range(form.pop("track")))
    with pytest.raises(DataError) as error:
        read_text(text, **form)
    assert re.match("(the file: )?(" + message + ")", str(error.value))


def test_arrays_and_data_frames():
    t = np.array([0, 1, 1.8])
    for source in (t, {"t_s": t}, list(t), np.array([(x,) for x in t], dtype=[("t_s", float)])):
        assert list(read(source).record.time_s) == [0, 1, 1.8]
    assert list(read((np.array([1, 2]), np.array([0.9, 0.8]))).record.eps) == [0.9, 0.8]
    assert read({"speed": [100], "eps": [1], "ball": ["a"]}, Form(unit="cm/s")).balls == ("a",)
    for source, message in (
        ({"t_s": [0, 1, 0.5]}, "the data: row 2, column t_s: 0.5 is not after"),
        ({"speed": [1], "eps": [1]}, "the data: column speed: the name has no unit"),
        ({"speed_m_s": [1, 2], "eps": [1]}, "the data: columns of different shapes"),
        ({"t_s": np.ones((2, 2))}, "the data: columns of different shapes"),
        ({"speed_m_s": [1, 2], "eps": [1, np.nan]}, "the data: row 1, column eps: the cell is empty"),
        (np.zeros((2, 5)), "the data: 5 columns without names"),
        (5, "the data: 0 columns without names"),
    ):
        with pytest.raises(DataError, match=re.escape(message)):
            read(source)
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"speed_m_s": [1, 2, 3], "eps": [0.9, 0.8, 0.7], "ball": ["a", "a", "b"], "note": 1})
    data = read(frame)
    assert data.balls == ("a", "b") and data.unused == ("note",) and list(data.of_ball(1).record.eps) == [0.7]
    assert list(read(pandas.Series(t)).record.time_s) == [0, 1, 1.8]
    assert list(read(io.StringIO(POINTS + "1,0.5\n")).record.eps) == [0.5]


def falling(height, eps, terminal_speed, samples_per_second, noise, seed):
    """Integrate drops with drag by small steps; return times, heights with noise, and the times of seven bounces."""
    g, step, y, v, t, bounces, track = 9.80665, 2e-4, height, 0.0, 0.0, [], []
    while len(bounces) < 7:
        track.append((t, y))
        a = -g * (1 + np.sign(v) * (v / terminal_speed) ** 2)
        y, v, t = y + v * step + a * step**2 / 2, v + a * step, t + step
        if y < 0:
            bounces.append(t - y / v)
            v, y = -v * eps, -y * eps
    times, heights = np.array(track).T
    at = np.arange(0, t, 1 / samples_per_second)
    random_numbers = np.random.default_rng(seed)
    return at, np.interp(at, times, heights) + random_numbers.normal(0, noise, at.size), np.array(bounces)


@pytest.mark.parametrize("eps,rate,noise,bound", [(0.8, 60, 1e-3, 2e-3), (0.85, 240, 0, 5e-4), (0.9, 500, 5e-4, 2e-3)])
def test_bounces_of_a_track(eps, rate, noise, bound):
    pytest.importorskip("scipy")
    at, heights, bounces = falling(1.0, eps, 9.0, rate, noise, 1)
    data = read({"time_s": at + 3, "height_m": heights + 0.2})  # any origins
    record = data.record
    assert 5 <= record.time_s.size <= 7 and data.remarks[0].startswith("The track has ")
    np.testing.assert_allclose(record.time_s[:5] - 3, bounces[:5], atol=bound)
    assert abs(record.height_m[0] - 1) < 0.005
    thrown = read({"time_s": at[at > 0.2], "height_m": heights[at > 0.2]}).record  # begins in flight
    assert np.isnan(thrown.height_m[0])
    heights[[*range(7, 12), int(bounces[1] * rate)]] = np.nan  # frames in which the ball was not found
    gaps = read({"time_s": at, "height_m": heights})
    np.testing.assert_allclose(gaps.record.time_s[:5], bounces[:5], atol=bound)
    assert gaps.remarks[0] == "6 rows without a height are left out."
    assert np.all(np.abs(gaps.record.line[:5] - record.line[:5]) <= 1)  # numbers of the rows


def test_hostile_bytes():
    """Files with random changes are read with numbers in their ranges, or refused by DataError."""
    seeds = [text if isinstance(text, bytes) else text.encode() for text, *_ in READ]
    pick = random.Random(3)
    for _ in range(1500):
        text = bytearray(pick.choice(seeds))
        for _ in range(pick.randrange(1, 5)):
            at = pick.randrange(len(text))
            text[at : at + pick.randrange(3)] = pick.choice(b'|\0|"|,|;|\n|-|1e999|nan|\xff|#|_|9'.split(b"|"))
            text = text or bytearray(b",")
        try:
            record = read_text(bytes(text), drop_height_m=pick.choice([None, 1.0])).record
        except DataError as error:
            assert str(error).startswith("the file: line ") and "; allowed: " in str(error)
            continue
        for name, values in vars(record).items():
            if isinstance(values, np.ndarray) and name != "height_m":
                assert np.all(np.isfinite(values)), name
        if isinstance(record, Times):
            steps = np.diff(record.time_s)
            steps[record.start[1:-1] - 1] = 1  # time begins again with each drop
            assert np.all(steps > 0)


def test_a_million_bounces():
    """A tenth of the largest file takes a tenth of the allowed time, and the progress is shown."""
    flights = 0.8 * 0.9 ** np.arange(10)
    times = (np.arange(10000)[:, None] * 100 + np.cumsum(flights)).ravel()
    text = "run,t_s\n" + "".join(f"d{k // 10},{t:.6f}\n" for k, t in enumerate(times))
    steps = []
    begin = time.process_time()
    data = read(io.BytesIO(text.encode()), Form(), steps.append)
    assert time.process_time() - begin < 0.5
    assert data.record.start.size == 10001 and steps[-1] == "reading: 100001 lines"


# ---- the command ----


def cor_fit(capfd, *words):
    """Run cor fit; return status, standard output and standard error."""
    status = main(["fit", *map(str, words)])
    return (status, *capfd.readouterr())


def test_command(tmp_path, capfd):
    pytest.importorskip("scipy")
    file = tmp_path / "a.csv"
    file.write_text("speed_m_s,eps,eps_sigma\n1,0.9,0.01\n2,0.8,0.02\n4,0.85,0.01\n")
    status, out, err = cor_fit(capfd, file, "--law", "constant", "--format", "csv")
    assert status == 0 and "None of these models fits the data." in err
    head, row = out.splitlines()
    assert head == "model,end,parameter,value,low_68,high_68,low_95,high_95,rms,chi2,aic"
    # the weighted mean (4 * 0.9 + 0.8 + 4 * 0.85)/9, its sigma 0.01/1.5
    expected = [7.8 / 9, 7.8 / 9 - 0.02 / 3, 7.8 / 9 + 0.02 / 3]
    np.testing.assert_allclose([float(x) for x in row.split(",")[3:6]], expected)
    words = [sys.executable, "-m", "cor", "fit", "-", "--law", "constant", "--output", str(tmp_path / "t")]
    run = subprocess.run(words, input=file.read_bytes(), capture_output=True)
    assert (run.returncode, run.stdout, run.stderr) == (0, b"", b"")
    assert re.match(r"model +end +.*\nconstant +both +eps +0.866667 .*\n\n3 points: ", (tmp_path / "t").read_text())
    file.write_text("ball,h0,h1\nA,100,81\nA,50,40.5\nB,100,64\nB,50,32\n")
    status, out, _ = cor_fit(capfd, file, "--unit", "cm", "--law", "constant", "--format", "json")
    values = {row["ball"]: row["value"] for row in json.loads(out)}
    assert status == 0 and abs(values["A"] - 0.9) < 1e-9 and abs(values["B"] - 0.8) < 1e-9
    assert 0.8 < values[None] < 0.9


def test_command_refuses(tmp_path, capfd):
    pytest.importorskip("scipy")
    file, none = tmp_path / "a.csv", tmp_path / "none"
    file.write_text(POINTS + "1,0.9\n2,0.8\n3,0.8\n4,0.7\n")
    for status, message, *words in (
        (2, "cor fit needs one DATA, for example cor fit DATA.csv"),
        (2, "unrecognized arguments: b.csv", file, "b.csv"),
        (2, f"cannot read {none}: No such file", none),
        (2, f"cannot read {tmp_path}: Is a directory", tmp_path),
        (2, "--law: 'hertz' is not a model; allowed: all, viscoelastic, plate,", file, "--law", "constant,hertz"),
        (2, "--law: '' is not a model", file, "--law", "constant,"),
        (2, "--end: no model of law plate ends at zero-force", file, "--law", "plate", "--end", "zero-force"),
        (2, "'space' is not a separator; allowed: comma, semicolon, tab", file, "--separator", "space"),
        (2, "--young: 'inf' is not", file, "--young", "inf"),
        (2, "--young-2: '-inf' is not", file, "--young-2=-inf"),
        (2, "--poisson is missing: a contact of bodies needs --young, --poisson,", file, "--young", "1e9"),
        (
            2,
            "give exactly one of --density and --mass",
            file,
            *"--young 1 --poisson 0 --radius 1 --mass 1 --density 1".split(),
        ),
        (
            2,
            "--wall is flat and fixed: leave out --radius-2",
            file,
            *"--young 1 --poisson 0 --radius 1 --mass 1 --wall --mass-2 1".split(),
        ),
        (2, "--unit: 'km/h' is not a unit; allowed: m/s", file, "--unit", "km/h"),
        (2, "--drag-coefficient needs --mass; give --mass", file, "--drag-coefficient", "0.4"),
        (2, "--fit-drag: .* contains speeds; allowed: only for times", file, "--fit-drag"),
        (2, "name the same file", file, "--output", file),
        (2, "--plot: 'a.jpg' is not the name of a picture; allowed: FILE.pdf", file, "--plot", "a.jpg"),
    ):
        found, out, err = cor_fit(capfd, *words)
        assert (found, out) == (status, "") and re.search(message, err), err


def test_pictures(tmp_path, capfd):
    pytest.importorskip("scipy")
    pytest.importorskip("matplotlib")
    file = tmp_path / "a $x$.csv"
    file.write_text(POINTS + "".join(f"{v},{0.9 * v**-0.1 + v % 3 / 1e3}\n" for v in range(1, 13)))
    result = cor.fit(file, law="constant,power-law")
    upper, lower = result.plot(all=True).axes
    assert lower.get_xlabel() == "impact speed (m/s)" and upper.get_title().startswith(
        r"restitution of a \$x\$.csv, fitted by "
    )
    assert upper.get_xlim() == (1, 12)  # the range of the data
    names = ", ".join(text.get_text() for text in upper.get_legend().get_texts())
    assert names == "measured, 95 % of the curve, power-law, constant"
    for form, begin in (("svg", b"<?xml"), ("pdf", b"%PDF"), ("png", b"\x89PNG")):
        paths = [tmp_path / f"{k}.{form}" for k in range(2)]
        for path in paths:
            result.plot(path)
        assert paths[0].read_bytes().startswith(begin) and paths[0].read_bytes() == paths[1].read_bytes()
    eps = 0.8 + 0.02 * np.random.default_rng(1).standard_normal(25)
    apexes = cor.fit({"h_m": np.cumprod(np.append(1, eps**2))}, law="constant")
    bars = apexes.plot().axes[0].containers[0][2][0].get_segments()
    assert min(bar[1, 1] - bar[0, 1] for bar in bars) / 2 > 0.99 * apexes.find(group="")[1].sigma[1] > 0.01
    assert cor_fit(capfd, file, "--law", "constant", "--plot", tmp_path / "c.svg")[0] == 0
    assert b">constant<" in (tmp_path / "c.svg").read_bytes()
