# SPDX-License-Identifier: MIT
"""Tests the interpreter of LAMMPS' scripts, its limits, and the bodies and contacts that it finds. Compares it with
lmp, if installed. tests/audit has whole decks, which were compared with the simulators."""

import math
import random
import shutil
import subprocess
import time

import pytest

from cor._audit import lammps, physics, script
from cor._audit.deck import Options

BOX = "units si\ntimestep 1e-5\nregion b block -1 1 -1 1 -1 1\ncreate_box 2 b\n"
ATOMS = BOX + "create_atoms 1 single 0 0 0\ncreate_atoms 2 single 0.5 0 0\nset type 1 diameter 0.01 density 2500\n"
ATOMS += "set type 2 diameter 0.02 density 1000\n"
HOOKE = "pair_style gran/hooke 1000 NULL 20 NULL 0 0\npair_coeff * *\n"


class Printer(script.System):
    """A system whose only command is print; it stores the texts."""

    def __init__(self):
        self.out = []

    def copy(self):
        return self

    def on_print(self, words):
        line = words.line._replace(raw=words[1])
        self.out += self.interpreter.worlds_now[-1].expand(line, True).expanded.splitlines()


def printed(text, monkeypatch, **options):
    """Returns the texts that a script prints, and the interpreter."""
    system, interpreter = Printer(), script.Script(Options(**options))
    system.interpreter, interpreter.worlds_now = interpreter, []
    run = script.World.run
    with monkeypatch.context() as patch:
        patch.setattr(script.World, "run", lambda world: (interpreter.worlds_now.append(world), run(world)))
        interpreter.run(text, "deck", system)
    return system.out, interpreter


def by_lammps(text, folder):
    """Returns the texts that lmp prints for a script."""
    (folder / "in").write_text(text)
    done = subprocess.run(["lmp", "-log", "none", "-in", "in"], cwd=folder, capture_output=True, text=True, timeout=60)
    noise = ("LAMMPS", "OMP_", "  using", "Total", "Increment")
    return [line for line in done.stdout.splitlines() if not line.startswith(noise)]


# Formulas with the values that lmp (29 Sep 2021) gives
FORMULAS = {
    "-2^2": "4", "2^-3^2": "0.015625", "2^3^2": "64", "-30^2+1000": "1900", "round(-2.5)": "-2", "round(2.5)": "3",
    "log(1000)": "3", "ln(2)": "0.693147180559945", "7%4*2": "6", "5%-3": "2", "!0+1": "2", "1<2==1": "1",
    "-2*-3": "6", "1/3": "0.333333333333333", "0^0": "1", "3|^0": "1", "1&&2||0": "1", "1e-3*1.e2+.5": "0.6",
    "on+false+PI": "4.14159265358979", "atan2(1,-1)": "2.35619449019234", "100000000": "100000000", "1e18": "1e+18",
    "1/0": None, "0^-1": None, "sqrt(-1)": None, "log(0)": None, "2**3": None, "1=2": None, "+5": None, "2x": None,
    "1-": None, "ke(all)": None, "c_1": None, "((((1)": None, "v_x": None, "step": None,
}  # fmt: skip
CONDITIONS = {
    "1 == 1 && a != b": 1, "2>1>0": 1, "1 |^ 1": 0, "!(1==2)": 1, "-1e3 == -1000.0": 1, "yes == yes": 1, "1": 1,
    "a/b == a/b": 1, "1 || 0 && 0": 1, "1 == 1 == 1": 1, "2 == yes": None, "1+1 > 2": None, "a < b": None, "!a": None,
}  # fmt: skip


def test_formulas(monkeypatch):
    lines = [f'variable x{i} equal "{f}"\nprint "${{x{i}}}"' for i, f in enumerate(FORMULAS)]
    out, _ = printed("\n".join(lines), monkeypatch)
    for (formula, value), got in zip(FORMULAS.items(), out):
        assert ("\0" in got) if value is None else got == value, formula
    for condition, value in CONDITIONS.items():
        out, interpreter = printed(f'if "{condition}" then "print 1" else "print 0"', monkeypatch)
        assert out == [str(value)] if value is not None else interpreter.split, condition


def test_formats_quotes_and_flow(monkeypatch):
    text = """variable a index 2 "x y"
variable b format a %06.2f
variable c string "v$(v_a+1:%.1f)" # a comment
print "$a ${b} ${c} $(1/3) $(v_a/3:%.3e)"
print '''' \"\"\"p # q
r\"\"\"
variable i loop 3 5 pad &
label again # here
"""
    out, _ = printed(text.replace("print '''' ", "print ").replace("pad &\n", "pad\n"), monkeypatch)
    assert out == ["2 002.00 v3.0 0.33333333333333331483 6.667e-01", "p # q", "r"]
    text = "variable e index 1 2 3\nlabel top\nvariable i loop 2\nlabel in\nprint $e$i\nnext i\njump SELF in\n"
    text += 'if "$e == 2" then "jump SELF out" "print never" elif "$e > 5" "print no" else "print $e"\nnext e\n'
    text += "jump SELF top\nlabel out\nprint done &\n\nvariable e delete\nquit\nprint after\n"
    assert printed(text, monkeypatch)[0] == ["11", "12", "1", "21", "22", "done"]
    assert printed("print $e$f", monkeypatch, variables={"e": ("7", "8"), "f": ("9",)})[0] == ["79"]


def test_an_unknown_condition_has_both_branches(monkeypatch):
    text = 'if "$(temp) > 1" then "print hot" elif "1 > 2" "print no" else "print cold"\nprint both'
    out, interpreter = printed(text, monkeypatch)
    assert sorted(out) == ["both", "both", "cold", "hot"] and len(interpreter.split) == 1
    loop = "label l\nif '$(ke) < 1' then 'jump SELF e'\nrun 9\njump SELF l\nlabel e\nprint end\n"
    out, interpreter = printed(loop, monkeypatch)
    assert out == ["end"] and not interpreter.remarks


def test_bounds(monkeypatch):
    monkeypatch.setattr(script, "MAX_SECONDS", 0.3)
    files = {"a": "include b", "b": "include a"}
    grow = "variable s string xx\nlabel l\nvariable s string ${s}${s}\njump SELF l\n"
    twice = "".join(f"variable a{i + 1} equal v_a{i}+v_a{i}\n" for i in range(60)) + "variable a0 equal 1\nprint ${a60}"
    deep = "variable x equal " + "(" * 100000 + "1" + "\nprint $x"
    itself = "variable c index 'if 1 then ${c}'\nif 1 then '${c}'"
    for text in ("label l\njump SELF l\n", "include a\n", grow, twice, deep, itself, "jump a\n", "include -\n"):
        start = time.process_time()
        out, interpreter = printed(
            text, monkeypatch, include=lambda name, of: (files[name], name) if name in files else None
        )
        assert time.process_time() - start < 4 and (interpreter.remarks or "\0" in "".join(out)), text[:40]
    for empty in ("variable e equal\nprint ${e}", "variable e format x\nprint ${e}", "variable e index\nprint $e"):
        assert "1" not in "".join(printed(empty, monkeypatch)[0])
    monkeypatch.setattr(script, "MAX_COMMANDS", 9)
    _, interpreter = printed("label l\njump SELF l\n", monkeypatch)
    assert "more commands than cor reads" in str(interpreter.remarks)
    monkeypatch.setattr(script, "MAX_LINE", 150)
    for copies in (1, 3):  # each value is shorter than the bound
        _, interpreter = printed(f"variable a string {'x' * 60}\nprint '{'${a}' * copies}'", monkeypatch)
        assert ("make a line of more than 150" in str(interpreter.remarks)) == (copies == 3)
    _, interpreter = printed("shell rm x\nshell gmsh x\npython f source here\nplugin load x", monkeypatch)
    assert [r.matters for r in interpreter.remarks.values()] == [False] * 3


@pytest.mark.skipif(not shutil.which("lmp"), reason="no program lmp")
def test_against_lammps(monkeypatch, tmp_path):
    """Random formulas, which never need more than four places of LAMMPS' stack, and random loops."""
    draw = random.Random(1)

    def formula(depth):
        kind = draw.random()
        if depth == 0 or kind < 0.2:
            return draw.choice("0 1 2 3 7 0.5 .25 1.5e2 2. PI yes v_n".split())
        if kind < 0.4:
            return draw.choice("-!") + formula(depth - 1)
        if kind < 0.6:
            return draw.choice("abs exp cos ceil floor round atan".split()) + f"({formula(depth - 1)})"
        sign = draw.choice("+ - * ^ == != < <= > >= && || |^".split())
        return f"{formula(depth - 1)}{draw.choice(['', ' '])}{sign}({formula(depth - 1)})"

    lines = ["variable n index 3"]
    for i in range(150):
        lines += [f'variable q{i} equal "{formula(3)}"', f'print "{i} ${{q{i}}} $(v_q{i}:%.{i % 9}f)"']
    for i in range(40):
        style = draw.choice(["loop 3", "loop 2 5", "index a b c", "loop 9 11 pad"])
        test = draw.choice([f'"${{j{i}}} == {k}"' for k in (2, 3)] if style[:4] == "loop" else ['"$n > 2"'])
        lines += [f"variable j{i} {style}", f"label l{i}", f'print "${{j{i}}} $n"']
        lines += [f'if {test} then "variable n delete" "variable n index {i}" "jump SELF e{i}" else "print \'no $n\'"']
        lines += [f"next j{i}", f"jump SELF l{i}", f"label e{i}"]
    text = "\n".join(lines) + "\n"
    out, wanted = printed(text, monkeypatch)[0], by_lammps(text, tmp_path)
    assert len(wanted) > 200
    for got, want in zip(out, wanted):
        same = got == want or ("\0" in got and ("nan" in want or "inf" in want))
        assert same or [float(x) for x in got.split()] == pytest.approx([float(x) for x in want.split()], rel=1e-13)


def rows(text, simulator="lammps", **options):
    """Returns the rows of a deck by pair, in their order."""
    read = lammps.read_lammps if simulator == "lammps" else lammps.read_liggghts
    given = Options(speeds=(1.0,), tolerance=9e-5, **options)
    return [(row.pair, row) for row in physics.rows_of(read(text, "deck", given), given) if row.model]


def eps(zeta):
    return math.exp(-math.pi * zeta / math.sqrt(1 - zeta * zeta))


BALLS = {1: math.pi / 6 * 1e-6 * 2500, 2: math.pi / 6 * 8e-6 * 1000}


@pytest.mark.parametrize(
    "more, pairs",
    [
        ("", {"1-1": BALLS[1] / 2, "1-2": 1 / (1 / BALLS[1] + 1 / BALLS[2]), "2-2": BALLS[2] / 2}),
        ("set type 1 mass 0.003\nset type 1 diameter 0.5\n", {"1-1": 0.0015}),
        ("set type 1 density/disc 30\n", {"1-1": math.pi / 4 * 1e-4 * 30 / 2}),
        ("set atom 2 mass 0.1\ngroup a id 1\nset group a mass 0.2\n", {"1-1": 0.1, "2-2": 0.05}),
        ("group two type 2\nfix f two freeze\n", {"1-1": BALLS[1] / 2, "1-2": BALLS[1]}),
        ("group two type 2\nneigh_modify exclude group two two\n", {"1-1": BALLS[1] / 2, "1-2": None}),
        ("region h block -1 0.1 -1 1 -1 1\ngroup h region h\ndelete_atoms group h\n", {"2-2": BALLS[2] / 2}),
        ("fix p all pour 9 1 1 diam one 0.02 dens 9 9\nset type 1 density 500\n", {"1-1, least": BALLS[1] / 10}),
        ("fix w all wall/gran hooke 1000 NULL 20 NULL 0 0 zplane 0 NULL\n", {"1-wall": BALLS[1], "2-wall": BALLS[2]}),
        ("group g type 2\nfix w g wall/gran 1000 NULL 20 NULL 0 0 zplane 0 NULL\n", {"2-wall": BALLS[2]}),
        ("set type 1 type 2\nset type 2 mass 0.1 diameter 1\n", {"2-2": 0.05}),
        ("lattice sc 1\nreplicate 1 1 1\nclear\n" + ATOMS + HOOKE + "run 1\nrun 2\n", {"1-1": BALLS[1] / 2}),
    ],
)  # fmt: skip
def test_masses(more, pairs):
    """zeta = (gamma/2) sqrt(m/K), computed by hand for the effective mass of each pair."""
    found = dict(rows(ATOMS + more + HOOKE))
    for pair, mass in pairs.items():
        assert pair in found, found.keys()
        if mass:
            assert found[pair].realised == pytest.approx(eps(10 * math.sqrt(mass / 1000)), rel=1e-12), pair
    assert ("2-2" in found) == ("fix f" not in more and "exclude" not in more)
    assert any(pair[:3] == "1-1" for pair in found) == ("delete" not in more and "type 1 type" not in more)


def test_a_body_held_without_freeze():
    """The damping uses the masses of both bodies, but the held body moves as if its mass were infinite."""
    moving = "group one type 1\nfix i one nve/sphere\n"
    mass = 1 / (1 / BALLS[1] + 1 / BALLS[2])
    found = dict(rows(ATOMS + moving + HOOKE))
    assert set(found) == {"1-1", "1-2 fixed"}
    assert found["1-2 fixed"].realised == pytest.approx(eps(10 * mass / math.sqrt(BALLS[1] * 1000)), rel=1e-12)


def test_runs_loops_and_versions():
    text = "variable e index 0.9 0.5\nlabel top\n" + BOX + "pair_style granular\n"
    text += "pair_coeff * * hertz 1e7 $e damping coeff_restitution\nrun 10\nrun 10\nclear\nnext e\njump SELF top\n"
    found = rows(text, radii={"": 0.01}, densities={"": 1000.0})
    assert [(pair, row.asked, row.contact.runs) for pair, row in found] == [("*-*", 0.9, (1, 2)), ("*-*", 0.5, (3, 4))]
    split = "if '$(temp) > 1' then 'pair_style gran/hooke 9 NULL 9 NULL 0 0'\n"
    given = Options()
    remarks = lammps.read_lammps(ATOMS + HOOKE + split, "deck", given).remarks
    assert "both branches" in remarks[0].text and not remarks[0].matters
    early = "if '$(temp) > 1' then 'quit'\n"
    assert len(lammps.read_lammps(BOX + HOOKE + early + ATOMS + HOOKE, "deck", given).contacts) == 3
    stepped = ATOMS + "reset_timestep 20\n" + HOOKE.replace(" 20 ", " $(step) ")
    assert rows(stepped)[0][1].realised == rows(ATOMS + HOOKE)[0][1].realised
    assert not rows(ATOMS + HOOKE + "fix r all rigid single\n")  # one body
    changed = ATOMS + HOOKE + "fix a all adapt 1 pair gran/hooke kn * * v_k\nfix d all dt/reset 1 1 1 1\n"
    assert "adapt" in rows(changed)[0][1].advice and "dt/reset" in rows(changed)[0][1].advice
    assert not lammps.read_lammps(ATOMS + HOOKE + split.replace("pair_style", "print"), "deck", given).remarks
    assert [pair for pair, _ in rows(text, radii={"": 0.01, "2": 0.02})] == ["1-1", "1-2", "2-2"] * 2
    granular = "pair_style granular\npair_coeff 1 1 hertz 1 0.9 damping {0}\npair_coeff 2 2 hertz 1 0.4 damping {0}\n"
    assert [pair for pair, _ in rows("read_data x\n" + granular.format("coeff_restitution"))] == ["1-1", "1-2", "2-2"]
    assert math.isnan(rows("units real\n" + HOOKE)[0][1].realised)
    assert [pair for pair, _ in rows("read_restart x\n" + HOOKE)] == ["*-*"]
    old = BOX + granular.format("tsuji")
    assert math.isnan(dict(rows(old))["1-2"].realised)  # LAMMPS of 2021 uses damping velocity there
    assert dict(rows(old, version="20260901"))["1-2"].asked == pytest.approx(0.6)
    wall = (
        HOOKE
        + "fix w all wall/gran 1000 NULL 20 NULL 0 0 zplane 0 NULL\nfix v all wall/gran hooke 1 1 1 1 1 1 xplane 0 1\n"
    )
    assert [p for p, _ in rows(ATOMS + wall)][-4:] == ["1-wall w", "2-wall w", "1-wall v", "2-wall v"]
    assert "before 2017" in dict(rows(ATOMS + wall, version="20210929"))["1-wall w"].advice


def test_lines_to_write():
    """A replacement line keeps the variables of the line, unless one of them contains several words."""
    head = BOX + "pair_style granular\nvariable m string 'hertz 1e7 0.5'\nvariable e equal 1/2\nvariable k index 1e7\n"
    for line, repaired in {
        "pair_coeff * * hertz $k ${e} damping tsuji": "pair_coeff * * hertz $k 0.366651 damping tsuji",
        "pair_coeff * * ${m} damping tsuji": "pair_coeff * * hertz 1e7 0.366651 damping tsuji",
        "pair_coeff * * hertz $k &\n $(v_e:%.2f) damping tsuji # e": "pair_coeff * * hertz $k  0.366651 damping tsuji ",
        "if 1 then 'pair_coeff * * hertz 1 0.5 damping tsuji'": "",
    }.items():
        assert rows(head + line)[0][1].instead == repaired


LIGGGHTS = "fix y all property/global youngsModulus peratomtype 5e6 5e6\nfix n all property/global poissonsRatio "
LIGGGHTS += "peratomtype 0.3 0.3\nfix e all property/global coefficientRestitution peratomtypepair 2 0.5 {e} {e} 0.05\n"


def test_liggghts():
    text = BOX + LIGGGHTS.format(e=0.7) + "pair_style gran model hertz tangential history limitForce on\n"
    text += "fix a all particletemplate/sphere 1 atom_type 1 density constant 2500 radius constant 0.01\n"
    text += "fix c all particletemplate/sphere 1 atom_type 2 density constant 900 radius uniform 0.01 0.02\n"
    text += "fix m all mesh/surface file x type 2\n"
    text += "fix w all wall/gran model hertz mesh n_meshes 2 meshes m m2 limitForce on\n"
    found = dict(rows(text, "liggghts"))
    assert found["1-1"].instead.endswith("peratomtypepair 2 0.436288 0.679194 0.679194 0.05")
    assert found["1-1"].instead == found["1-2, largest"].instead
    assert "above 0.05" in found["2-2, least"].advice and found["1-wall w m"].asked == 0.7
    assert "not known" in found["1-wall w m2"].advice
    matrix = LIGGGHTS.format(e=0.7) + "pair_style gran model hooke\n"
    assert [pair for pair, _ in rows("read_restart x\n" + matrix, "liggghts")] == ["1-1", "1-2", "2-2"]
    used = text + "fix d all particledistribution/discrete 1 1 a 1\n"
    used += "fix i all insert/pack seed 1 distributiontemplate d\n"
    assert [p for p, _ in rows(used, "liggghts") if "wall" not in p] == ["1-1"]
    for body in ("fix f all multisphere\n", "fix g all rigid/small molecule\n"):
        assert "centre of mass" in dict(rows(used + body, "liggghts"))["1-1"].advice
