# SPDX-License-Identifier: MIT
"""Runs collisions in the user's own LAMMPS or LIGGGHTS. The program reads the user's script line by line from a pipe.
In place of each run, two particles collide, or one particle and a plane wall. The program evaluates all variables and
conditions. This module follows the order of lines (if, jump, label, include) to check commands before execution."""

import itertools
import math
import os
import re
import shutil
import time
from contextlib import suppress
from dataclasses import dataclass
from typing import Dict, List, Optional, Tuple

from .._command import progress
from .collision import Failed, eps_of, measured
from .process import Process

# Commands that are never executed: they execute others, write files or run the simulation
LEFT_OUT = (
    "shell python plugin mdi kim kim_init geturl message server partition dump undump dump_modify restart write_data "
    "write_dump write_restart write_coeff group2ndx minimize rerun neb neb/spin temper temper/grem temper/npt tad prd "
    "hyper dynamical_matrix third_order"
).split()
# Commands omitted without a report, because no result depends on them
UNNAMED = "log echo print label thermo thermo_log thermo_modify thermo_style info timer balance processors".split()
# Styles of fix that write files or execute programs
WRITING = re.compile(r".*\$|print$|ave/|python|external$|plumed|colvars|ipi$|imd$|mdi|qmmm|couple/")
PLANES = "xplane yplane zplane zcylinder region".split()
KEPT = re.compile(r"property/|mesh/|particle|freeze$|adapt$|lb/|check/")  # styles of fix that move nothing


@dataclass
class Collision:
    """One contact, in the units of the deck: two particles, or one and a wall. The second diameter and mass are unused
    with a wall. Unknown sizes are NaN. runs: the runs with this contact; empty: any."""

    types: Tuple[int, int]
    wall: List[str]  # words, one of which is the fix of the wall; empty: no wall
    diameters: Tuple[float, float]
    masses: Tuple[float, float]
    held: Tuple[bool, bool]
    speed: float
    runs: Tuple[int, ...]
    eps: float = math.nan
    eps_small_step: float = math.nan
    reason: str = ""  # reason if there is no result
    done: bool = False


class Stop(Exception):
    """Raised at the end of the script, or if nothing is left to measure."""


def words_of(line: str) -> List[str]:
    """Returns the words of a line without its comment. A quoted text is one word, with its quotes."""
    found = re.findall(r"\"\"\".*?\"\"\"|\"[^\"]*\"|'[^']*'|#.*|(?:\$\([^)]*\)|\$\{[^}]*\}|[^\s#\"'])+", line, re.S)
    return [word for word in found if not word.startswith("#")]


def unquoted(word: str) -> str:
    return re.sub(r"^(\"\"\"|\"|')(.*)\1$", r"\2", word, flags=re.S).strip()


def writes(words: List[str]) -> bool:
    """True if a fix writes files or executes a program."""
    style = words[3] if len(words) > 3 else ""
    named = {"file", "append", "out", "outfile"} & set(words) and not style.startswith(("mesh/", "particle"))
    return bool(named or WRITING.match(style))


def lines_of(path: str) -> List[Tuple[int, str]]:
    """Returns the commands of a file, each with the number of its first line."""
    if not os.path.isfile(path):
        raise Failed(f"cannot open {os.path.basename(path)}")
    with open(path, encoding="utf-8", errors="surrogateescape") as file:
        text = file.read()
    found, number = [], 1
    for line in re.findall(r"(?:[^\n\"&]|\"\"\".*?\"\"\"|\"|&[^\S\n]*\n|&)*\n?", text, re.S):
        found.append((number, re.sub(r"&[^\S\n]*\n", " ", line).strip()))
        number += line.count("\n")
    return found


class Script:
    """Runs the script in the program, with collisions in place of its runs."""

    def __init__(self, command: List[str], folder: str, source: str, end: float, todo: List[Collision]) -> None:
        self.command, self.folder, self.source, self.end, self.todo = command, folder, source, end, todo
        self.number, self.runs, self.marks, self.version, self.dt = 0, 0, 0, "", math.nan
        self.log = open(os.path.join(folder, "cor-sent"), "w", encoding="utf-8", errors="surrogateescape")
        self.sent: List[str] = ["newton off"]  # commands that restore the state
        self.left_out: Dict[str, List[int]] = {}
        self.bodies: List[str] = []  # fixes of rigid bodies, which are not executed
        self.fixes: Dict[str, List[str]] = {}  # the words of each existing fix, in the order of definition
        self.places: Dict[str, str] = {}  # the line of each fix
        for file, text in ("cor-jump", "jump cor-jumped"), ("cor-jumped", 'print "cor jumped"'):
            with open(os.path.join(folder, file), "w", encoding="ascii") as made:
                made.write(text + "\n")
        self.process = self.started()

    # ---- the program ----

    def restore(self) -> None:
        """Restarts the program and repeats the commands up to the present line of the script."""
        self.process.close()
        self.process = self.started()
        for line in self.sent[1:]:
            self.ask(line)

    def started(self) -> Process:
        self.log.write("\n# the program\n")
        self.process = Process(self.command, self.folder, self.end)
        said = [line for line in self.ask() if re.match("(LAMMPS|LIGGGHTS) ", line)]
        self.version = re.sub(r".*\((?:Version )?(.*?)(, compiled.*)?\)$", r"\1", said[0]) if said else ""
        self.new = bool(said) and said[0].startswith("LAMMPS")
        self.ask(self.sent[0])
        return self.process

    def ask(self, *lines: str) -> List[str]:
        """Sends commands. Returns the answer."""
        self.marks += 1
        for line in lines:
            self.log.write(line + "\n")
            self.process.send(line.replace("\n", " "))
        self.process.send(f'print "cor {self.marks}."')
        return self.process.read_until(f"cor {self.marks}.")

    def answer(self, text: str) -> str:
        """Returns a text of one line after the program has replaced its variables."""
        quote = next((q for q in ("'", '"', '"""') if q not in text), "'")
        found = [line for line in self.ask(f"print {quote}cor = {text}{quote}") if line.startswith("cor = ")]
        return found[-1][6:] if found else text

    def values(self, **expressions: str) -> List[float]:
        """Returns the values of equal-style variables."""
        self.ask(*(f"variable cor_{name} equal {value}" for name, value in expressions.items()))
        return [float(word) for word in self.answer(" ".join("${cor_%s}" % name for name in expressions)).split()]

    # ---- the script ----

    def play(self, path: str) -> None:
        """Executes a file. A jump may continue in another file."""
        lines, i = lines_of(path), 0
        while i < len(lines):
            self.number, line = lines[i]
            jump = self.execute(line)
            i += 1
            if jump:
                lines = lines if jump[0] == "SELF" else lines_of(self.found(jump[0]))
                labels = [k for k, line in enumerate(lines) if words_of(line[1])[:2] == ["label", jump[1]]]
                if jump[1] and not labels:
                    raise Failed(f"label {jump[1]} does not exist")
                i = labels[0] if jump[1] else 0

    def found(self, name: str) -> str:
        """Returns the path of a file of the script. Copies a file that is outside the script's folder."""
        path = os.path.normpath(os.path.join(self.folder, unquoted(name)))
        original = os.path.normpath(os.path.join(self.source, unquoted(name)))
        if not os.path.exists(path) and os.path.isfile(original):
            os.makedirs(os.path.dirname(path), exist_ok=True)
            shutil.copy(original, path)
        return path

    def execute(self, line: str) -> Optional[Tuple[str, str]]:
        """Executes a command; returns file and label of a jump."""
        if "$" in line and "\n" not in line and not re.match(r"(if|print|label|#)\b", line):
            line = self.answer(line)
        words = words_of(line)
        name = words[0] if words else ""
        is_python = name == "variable" and words[2:3] == ["python"]
        if not words or name in UNNAMED:
            return None
        if name == "if":
            return self.branch(words)
        if name == "jump":
            self.sent.append("include cor-jump")  # a jump is skipped after the last value of a variable
            jumps = "cor jumped" in self.ask(self.sent[-1])
            return (unquoted(words[1]), unquoted(" ".join(words[2:3]))) if jumps else None
        if name == "include":
            self.play(self.found(words[1]))
        elif name == "quit":
            raise Stop
        elif name == "run":
            self.runs += 1
            self.collide()
            if self.sent[-1] != "run 0 post no":
                self.keep("run 0 post no")
        elif "$" in name or "\n" in line or name in LEFT_OUT or is_python or name == "fix" and writes(words):
            self.left_out.setdefault(" ".join(words[:1] + words[3:4] * (name == "fix")), []).append(self.number)
        elif name == "fix" and (words[3] == "multisphere" or words[3].startswith("insert/") and self.has_bodies()):
            self.bodies.append(words[1])  # LIGGGHTS cannot remove this fix; cor adds particles with the mass of a body
        elif name == "unfix" and words[1] in self.bodies:
            pass
        elif name == "clear":
            self.fixes, kept = {}, [line for line in self.sent if re.match("variable|next|include cor-jump", line)]
            self.keep("clear", "newton off")
            self.sent = ["newton off", *kept]
        else:
            for word in words[1:]:
                if word.startswith("../"):
                    self.found(word)
            self.keep(line)
            if name == "fix":
                self.fixes[words[1]], self.places[words[1]] = words, str(self.number)
            elif name == "unfix":
                self.fixes.pop(words[1], None)
        return None

    def has_bodies(self) -> bool:
        return any(words[3] == "particletemplate/multisphere" for words in self.fixes.values())

    def keep(self, *lines: str) -> None:
        self.sent += lines
        self.ask(*lines)

    def branch(self, words: List[str]) -> Optional[Tuple[str, str]]:
        """Executes the branch of an `if` that the program would execute. Returns file and label of a jump."""
        jump, rest = None, words[1:]
        starts = [0] + [i + 1 for i, word in enumerate(rest) if word in ("elif", "else")]
        for start in starts:
            part = rest[start : next((i - 1 for i in starts if i > start), None)]
            if start == 0 or rest[start - 1] == "elif":
                if "cor true" not in self.ask(f"if {part[0]} then \"print 'cor true'\""):
                    continue
                part = part[1:]
            for command in part[part[:1] == ["then"] :]:
                jump = self.execute(unquoted(command)) or jump
            break
        return jump

    # ---- the collisions ----

    def collide(self) -> None:
        """Measures the collisions of this run, then restores the program, unless nothing is left to measure."""
        ready = False
        for c in self.todo:
            if c.done or c.runs and self.runs and self.runs not in c.runs:
                continue
            c.done = True
            progress(f"measuring: {sum(c.done for c in self.todo)} of {len(self.todo)} contacts")
            try:
                if not ready:
                    self.prepare()
                ready = True
                least = self.size(c, 0)[0] / c.speed / 4
                c.eps, c.eps_small_step = measured(lambda dt, phase: self.collision(c, dt, phase), self.dt, least)
            except Failed as error:
                if self.end < time.monotonic():
                    raise
                c.reason = str(error)
                self.restore()
                ready = False
        if all(c.done for c in self.todo):
            raise Stop
        if ready:
            self.restore()

    def prepare(self) -> None:
        """Records the sizes of the particles by type. Removes the particles and every fix that moves them."""
        if not any(re.match("(comm_modify|communicate) .*vel", line) for line in self.sent):
            self.ask("comm_modify vel yes" if self.new else "communicate single vel yes")
        self.groups: List[str] = []
        self.sizes: Dict[int, List[float]] = {}  # least and largest diameter, least and largest mass
        types = sorted({t for c in self.todo for t in c.types if t > 0})
        if self.values(n="count(all)")[0] > 0:
            names: List[str] = []
            lines = ["compute cor_p all property/atom diameter mass"]
            for t, column, sign in itertools.product(types, (1, 2), "-+"):
                names.append(f"v_cor_s{len(names)}")
                value = f"{sign}c_cor_p[{column}]*(type=={t})-1e30*(type!={t})"
                lines.append(f'variable {names[-1][2:]} atom "0{value}"')
            lines.append("compute cor_m all reduce max " + " ".join(names))
            columns = {f"m{i + 1}": f"c_cor_m[{i + 1}]" for i in range(len(names))}
            self.ask(*lines, "thermo_style custom step " + " ".join(columns.values()), "run 0 post no")
            found = self.values(**columns)
            self.ask("thermo_style custom step", "uncompute cor_m", "uncompute cor_p")
            for i, t in enumerate(types):
                least, largest, light, heavy = found[4 * i : 4 * i + 4]
                if largest > 0:
                    self.sizes[t] = [-least, largest, -light, heavy]
        dead = [name for name, words in self.fixes.items() if not KEPT.match(words[3])]
        self.ask("delete_atoms group all", *(f"unfix {name}" for name in reversed(dead)))
        flat = any(words_of(line)[:2] == ["dimension", "2"] for line in self.sent)
        given = [d for c in self.todo for d in c.diameters if d > 0]
        most = max(given + [x[1] for x in self.sizes.values()], default=0)
        bounds = self.values(**{f"{x}{end}": x + end for x in "xyz"[: 3 - flat] for end in ("lo", "hi")})
        bounds = [x + (5 if i % 2 else -5) * most for i, x in enumerate(bounds)]
        sides = [f"{x} final {low:.17g} {high:.17g}" for x, low, high in zip("xyz", bounds[::2], bounds[1::2])]
        self.ask(f"change_box all boundary f f {'fp'[flat]} {' '.join(sides)} units box")
        self.ask("thermo 1000000000", "thermo_style custom step")
        self.ask("neigh_modify delay 0 every 1 check yes", "atom_modify sort 0 0")
        places = {"dt": "dt", "x": "0.5*(xlo+xhi)", "y": "0.5*(ylo+yhi)", "z": "0.5*(zlo+zhi)"}
        self.dt, *self.middle = self.values(**places)

    def size(self, c: Collision, i: int) -> Tuple[float, float]:
        """Returns diameter and mass of a particle: from the audit, or else from the program's particles."""
        diameter, mass = c.diameters[i], c.masses[i]
        least, largest, light, heavy = self.sizes.get(c.types[i], [diameter, diameter, mass, mass])
        if not least * (1 - 1e-6) <= diameter <= largest * (1 + 1e-6):
            diameter = math.sqrt(least * largest)
        rigid = any(re.match("rigid|poems|multisphere", words[3]) for words in self.fixes.values())
        if not (rigid and mass > 0) and not light * (1 - 1e-6) <= mass <= heavy * (1 + 1e-6):
            mass = math.sqrt(light * heavy)
        if not (diameter > 0 and mass > 0):
            raise Failed(f"the deck has no particle of type {c.types[i]}; give --radius and --density")
        return diameter, mass

    def collision(self, c: Collision, dt: float, phase: float) -> Tuple[float, int]:
        """Computes one collision. Returns eps and the number of steps until the bodies have parted."""
        sizes = [self.size(c, i) for i in range(1 if c.wall else 2)]
        gap, (x, y, z) = c.speed * dt * (1 + phase) + 1e-9 * sizes[0][0], self.middle
        touch = sum(diameter for diameter, _ in sizes) / 2
        if not self.new and 1 not in c.types[: len(sizes)]:  # LIGGGHTS needs a particle of type 1
            self.particle("cor_s", 1, sizes[0], (x, y + 3 * touch, z), 0)
        if c.wall:
            self.ask(self.wall_at(c, x))
            self.particle("cor_b", c.types[0], sizes[0], (x + touch + gap, y, z), -c.speed)
        else:
            self.particle("cor_a", c.types[0], sizes[0], (x - touch / 2, y, z), 0 if c.held[0] else c.speed)
            self.particle("cor_b", c.types[1], sizes[1], (x + touch / 2 + gap, y, z), -c.speed if c.held[0] else 0)
        frozen = [words[2] for words in self.fixes.values() if words[3] == "freeze"]
        moved = "all"
        for i, group in enumerate(("cor_a", "cor_b")):
            if c.held[i] and not c.wall:
                moved = "cor_b" if i == 0 else "cor_a"
                self.ask(*(f"group {name} union {name} {group}" for name in frozen[:1]))
        self.ask(f"neighbor {0.1 * sizes[0][0]:.17g} nsq", f"timestep {dt:.17g}", f"fix cor_nve {moved} nve/sphere")
        try:
            return self.until_parted(c, touch, x)
        finally:
            if self.process.open:
                self.ask("unfix cor_nve", "delete_atoms group all", *(["unfix cor_wall"] if c.wall else []))
                self.ask(*(f"group {name} delete" for name in self.groups))
                self.groups = []

    def until_parted(self, c: Collision, touch: float, wall: float) -> Tuple[float, int]:
        other = ("0", repr(wall)) if c.wall else ("vcm(cor_a,x)", "xcm(cor_a,x)")
        self.ask(f"variable cor_g equal vcm(cor_b,x)-{other[0]}", f"variable cor_s equal xcm(cor_b,x)-{other[1]}")
        first = ["post no"]

        def advance(steps: int) -> Tuple[float, float]:
            self.ask(f"run {steps} {first[0]}")
            first[0] = "pre no post no"
            velocity, distance = self.answer("${cor_g} ${cor_s}").split()
            return float(velocity), float(distance)

        return eps_of(advance, c.speed, touch)

    def particle(self, group: str, kind: int, size: Tuple[float, float], at: Tuple[float, ...], speed: float) -> None:
        """Creates a particle as the only one in a new group."""
        place = " ".join(f"{x:.17g}" for x in at)
        self.ask(f"create_atoms {kind} single {place} units box")
        self.ask(f"group {group} " + " ".join(["subtract", "all", *self.groups] if self.groups else ["union", "all"]))
        self.groups.append(group)
        self.ask(f"set group {group} diameter {size[0]:.17g}", f"set group {group} mass {size[1]:.17g}")
        self.ask(f"velocity {group} set {speed:.17g} 0 0 units box")

    def wall_at(self, c: Collision, x: float) -> str:
        """Returns the wall as a plane at x, with the deck's model and type."""
        walls = {name: words for name, words in self.fixes.items() if "wall/" in words[3]}
        named = [name for name in walls if name in c.wall or self.places[name] in c.wall] or list(walls)
        words = walls.get(named[0], []) if len(named) == 1 else []
        if not words:
            raise Failed("the wall does not exist at this run")
        if self.new:
            end = next((i for i, word in enumerate(words) if word in PLANES and i > 3), len(words))
            return f"fix cor_wall all wall/gran {' '.join(words[4:end])} xplane {x:.17g} NULL"
        end = next(i for i, word in enumerate(words) if word in ("mesh", "primitive") and i > 3)
        rest = words[end + 1 :]
        kind = rest[1] if words[end] == "primitive" else str(c.types[1])
        skipped = 3 + int(rest[1]) if words[end] == "mesh" else 3  # the next line skips the plane's numbers
        rest = list(itertools.dropwhile(lambda word: not re.match("[a-z]", word, re.I), rest[skipped:]))
        if "shear" in rest:
            del rest[rest.index("shear") : rest.index("shear") + 3]
        start = f"fix cor_wall all wall/gran {' '.join(words[4:end])} primitive type {kind}"
        return f"{start} xplane {x:.17g} {' '.join(rest)}"


def measure(
    command: List[str], folder: str, path: str, end: float, variables: Dict[str, Tuple[str, ...]], todo: List[Collision]
) -> Tuple[str, Dict[str, List[int]], str]:
    """Executes a script and, in place of each of its runs, measures collisions. Returns the program's version, the
    omitted commands with their lines, and the reason if the script did not reach its end."""
    flags = [word for key, values in variables.items() for word in ("-var", key, *values)]
    source, name = os.path.split(os.path.abspath(path))
    script, reason = Script(command + ["-log", "none", *flags], folder, source, end, todo), ""
    try:
        with suppress(Stop):
            script.play(os.path.join(folder, name))
        if not script.runs:
            with suppress(Stop):
                script.collide()
    except Failed as error:
        reason = f"line {script.number}: {error}"
    finally:
        script.process.close()
        script.log.close()
    return script.version, script.left_out, reason
