# SPDX-License-Identifier: MIT
"""Interprets the scripts of LAMMPS and LIGGGHTS: variables, branches, loops and included files. Passes other commands
to a System (cor._audit.lammps), which records its contacts at each run. Runs no program, and reads files only
through Options.include.

An `if` whose condition is unknown splits the script into worlds, one for each branch."""

import math
import operator
import re
import time
from typing import Any, Callable, Dict, List, NamedTuple, NoReturn, Optional, Sequence, Set, Tuple

from .deck import Options, Remark

MAX_COMMANDS = 400000  # limit for all worlds together
MAX_SECONDS = 5.0
MAX_NESTED = 16  # depth of files, as in LAMMPS
MAX_WORLDS = 64
MAX_WORDS = 100000  # largest number of words in a line
MAX_CONTINUED = 2000  # continuation lines of one command
MAX_LINE = 1 << 26
_MARK = "\0"  # encloses the name of an unknown value within a word
_BLANK = "\1"  # replaces each blank in the name of an unknown value


class Unknown(Exception):
    """Raised for a value that only a run of the simulator can give. The text names the value."""


class OutOfBounds(Exception):
    """Raised if reading the script takes too long. The text is the reason."""


class Variable(NamedTuple):
    style: str
    values: Tuple[str, ...] = ()  # of style equal: formula; of format: variable, format; of loop: first, format, last
    at: int = 0


class Line(NamedTuple):
    """A command with its place. raw: the text with continued lines joined. nested: inside an `if`."""

    file: str
    line: int
    last_line: int
    raw: str
    nested: bool = False


class Source(NamedTuple):
    name: str
    text: str


def number(word: str) -> float:
    """Returns the value of a word that is a number. Raises Unknown for other words and unknown values."""
    if _MARK in word:
        raise Unknown(word.split(_MARK)[1])
    if re.fullmatch(rf"[+-]?{_NUMBER}", word):
        return float(word)
    raise Unknown(f"{word or 'a missing number'}, which is not a number")


def is_known(word: str) -> bool:
    return _MARK not in word


# ---- formulas ----

_LEVELS = {"||": 1, "|^": 1, "&&": 2, "==": 3, "!=": 3, "<": 4, "<=": 4, ">": 4, ">=": 4}
_LEVELS.update({"+": 5, "-": 5, "*": 6, "/": 6, "%": 6, "^": 7})
_NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_TOKEN = re.compile(rf"\s*({_NUMBER}(?![A-Za-z])|\|\||\|\^|&&|[=!<>]=|[-+*/%^!<>(),[\]]|[A-Za-z_][\w.]*)")
_TEST = re.compile(rf"\s*(-?{_NUMBER}(?![A-Za-z])|\|\||\|\^|&&|[=!<>]=|[!<>()]|[A-Za-z][^\s()=!<>&|]*)")
_CONSTANTS = {"PI": math.pi, "yes": 1.0, "on": 1.0, "true": 1.0, "no": 0.0, "off": 0.0, "false": 0.0}
_FUNCTIONS: Dict[str, Tuple[int, Callable[..., Any]]] = {
    **{name: (1, getattr(math, name)) for name in "sqrt exp sin cos tan asin acos atan ceil floor".split()},
    "ln": (1, math.log), "log": (1, math.log10), "abs": (1, abs), "atan2": (2, math.atan2),
    "round": (1, lambda x: math.ceil(x) if x - math.floor(x) >= 0.5 else math.floor(x)),
    "ternary": (3, lambda x, y, z: y if x else z),
}  # fmt: skip
SIGNS: Dict[str, Callable[[Any, Any], float]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "%": math.fmod,
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "==": operator.eq, "!=": operator.ne,
    "^": lambda x, y: 1.0 if y == 0 else math.pow(x, y),
    "&&": lambda x, y: bool(x and y), "||": lambda x, y: bool(x or y), "|^": lambda x, y: bool(x) != bool(y),
}  # fmt: skip


class _Formula:
    """A formula with LAMMPS's precedence: minus and ! bind before ^, and equal operators are evaluated from the left.

    is_test: the condition of an `if`, in which names are words and arithmetic is not allowed."""

    def __init__(self, text: str, world: "World", is_test: bool = False):
        self.text, self.world, self.at, self.is_test = text, world, 0, is_test
        self.tokens: List[str] = []
        at, text = 0, text.rstrip()
        while at < len(text):
            found = (_TEST if is_test else _TOKEN).match(text, at)
            if not found:
                self.fail()
            self.tokens.append(found[1])
            at = found.end()

    def fail(self) -> NoReturn:
        raise Unknown(f"{self.text}, which cor cannot evaluate")

    def peek(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def next(self) -> str:
        self.at += 1
        return self.tokens[self.at - 1] if self.at <= len(self.tokens) else ""

    def take(self, sign: str) -> None:
        if self.next() != sign:
            self.fail()

    def value(self) -> float:
        try:
            result = self.binary(1)
        except (ValueError, ZeroDivisionError, OverflowError, RecursionError, TypeError):
            self.fail()  # an error in LAMMPS, too
        if self.peek() or isinstance(result, str):
            self.fail()
        return float(result)

    def binary(self, least: int) -> Any:
        left = self.unary()
        while _LEVELS.get(self.peek(), 0) >= least:
            sign = self.next()
            right = self.binary(_LEVELS[sign] + 1)
            if isinstance(left, str) != isinstance(right, str) or (isinstance(left, str) and sign not in ("==", "!=")):
                self.fail()
            left = float(SIGNS[sign](left, right))
        return left

    def unary(self) -> Any:
        self.world.script.tick()
        token = self.next()
        if token == "-":
            return -self.unary()
        if token == "!":
            return float(abs(self.unary()) == 0)
        if token == "(":
            x = self.binary(1)
            self.take(")")
            return x
        if token[:1].isalpha():
            return token if self.is_test else self.named(token)
        return float(token)

    def named(self, name: str) -> float:
        if self.peek() == "[" or (self.peek() == "(" and name not in _FUNCTIONS and name != "is_defined"):
            raise Unknown(
                f"{name}{self.peek()}...{']' if self.peek() == '[' else ')'}, which has a value only during a run"
            )
        if name.startswith("v_"):
            return number(self.world.text_of(name[2:]))
        if self.peek() != "(":
            return _CONSTANTS[name] if name in _CONSTANTS else self.world.system.keyword(name)
        self.take("(")
        if name == "is_defined":
            category, comma, defined, end = (self.next() for _ in range(4))
            return float(self.world.is_defined(category, defined)) if comma + end == ",)" else self.fail()
        count, function = _FUNCTIONS[name]
        arguments = []
        for i in range(count):
            arguments.append(self.binary(1))
            self.take("," if i + 1 < count else ")")
        return float(function(*arguments))


# ---- words ----


_QUOTE = re.compile(r'"""|["\'#]')
_DOLLAR = re.compile(r'"""|["\'$]')
_SPLIT = re.compile(r'\s*(?:"""(.*?)(?:"""|$)|"([^"]*)"?|\'([^\']*)\'?|(\S+))', re.S)


def _without_comment(text: str) -> str:
    quote = ""
    for found in _QUOTE.finditer(text) if "#" in text else ():
        if quote:
            quote = "" if found[0] == quote else quote
        elif found[0] == "#":
            return text[: found.start()]
        else:
            quote = found[0]
    return text


class Words(List[str]):
    """The words of a command; "" beyond the last. expanded: the text with its variables replaced. inside: start and
    end of each word in `expanded`. pieces: parts of `expanded`, each with its start and end in the raw text."""

    def __init__(self, line: Line, pieces: Sequence[Tuple[str, int, int]]):
        super().__init__()
        self.line = line
        self.expanded = "".join(piece for piece, _, _ in pieces)
        self.inside: List[Tuple[int, int]] = []
        self.pieces = pieces
        for found in _SPLIT.finditer(self.expanded):
            if len(self) == MAX_WORDS:
                break
            self.append(next(word for word in found.groups() if word is not None))
            self.inside.append((found.end() - len(found[0].lstrip()), found.end()))

    def __getitem__(self, i: Any) -> Any:
        return super().__getitem__(i) if isinstance(i, slice) or -len(self) <= i < len(self) else ""

    def slots(self, indices: Sequence[int]) -> Tuple[str, Tuple[Tuple[int, int], ...]]:
        """Returns a text of the line, and the parts of this text that contain the words.

        The text is the raw line or, if a variable contains several words, the line with its variables replaced."""
        spans = []
        for i in indices:
            start, end = self.inside[i]
            at = 0
            covered = []
            for piece, first, last in self.pieces:
                if at < end and at + len(piece) > start:
                    literal = len(piece) == last - first and self.line.raw[first:last] == piece
                    if literal:
                        covered.append((first + max(start - at, 0), first + min(end - at, len(piece))))
                    elif start <= at and at + len(piece) <= end:
                        covered.append((first, last))
                    else:
                        return self.expanded, tuple(self.inside[k] for k in indices)
                at += len(piece)
            spans.append((covered[0][0], covered[-1][1]))
        return self.line.raw, tuple(spans)

    def find(self, text: str, first: int = 0) -> int:
        """Returns the index of a word from `first` onward, or -1."""
        return next((i for i in range(first, len(self)) if self[i] == text), -1)

    def after(self, text: str, first: int = 0, offset: int = 1) -> str:
        """Returns the word after `text`, or ""."""
        at = self.find(text, first)
        return "" if at < 0 else str(self[at + offset])

    def number(self, i: int) -> float:
        return number(self[i])

    def value(self, i: int) -> float:
        """Returns the number, or NaN if it is unknown."""
        try:
            return number(self[i])
        except Unknown:
            return math.nan


# ---- the script ----


class System:
    """The state of the simulator. The method on_NAME executes the command NAME; it returns False if nothing changes."""

    is_changed = True  # True if the system changed since the last run

    def copy(self) -> "System":
        raise NotImplementedError

    def count(self) -> int:
        """Returns the number of contacts."""
        return 0

    def keyword(self, name: str) -> float:
        """Returns the value of a thermodynamic keyword. Raises Unknown if only a run gives it."""
        raise Unknown(f"{name}, which has a value only during a run")

    def is_defined(self, category: str, name: str) -> bool:
        raise Unknown("is_defined()")

    def finish(self) -> None:
        """Records the contacts of a system that was never run."""


class World:
    """One path through a script: its place in the files, its variables and its system."""

    def __init__(self, script: "Script", system: System):
        self.script, self.system = script, system
        self.variables: Dict[str, Variable] = {}
        self.stack: List[Tuple[Source, int, int]] = []  # file, offset, number of the next line
        self.label, self.skip_jump, self.partition, self.depth, self.is_left = "", False, 0, 0, False
        self.evaluated: Set[str] = set()
        self.changes = 0  # number of commands that changed the system
        self.rounds: Dict[Tuple[str, str], List[int]] = {}  # number of contacts at each jump to a label
        self.visited: Dict[Tuple[str, int], Any] = {}  # place of an `if` -> changes and variables at its last visit
        self.pending: List[str] = []
        self.place = Line("", 0, 0, "")

    def copy(self) -> "World":
        other = World(self.script, self.system.copy())
        other.variables, other.stack = dict(self.variables), list(self.stack)
        other.skip_jump, other.partition, other.place = self.skip_jump, self.partition, self.place
        other.changes, other.visited = self.changes, dict(self.visited)
        return other

    # -- variables --

    def is_defined(self, category: str, name: str) -> bool:
        return name in self.variables if category == "variable" else self.system.is_defined(category, name)

    def text_of(self, name: str) -> str:
        """Returns the text of a variable as ${name} gives it."""
        variable = self.variables.get(name)
        if variable is None:
            raise Unknown(f"the variable {name}, which the script does not define (give it by -var {name} VALUE)")
        if len(variable.values) < (2 if variable.style == "format" else 1):
            raise Unknown(f"the variable {name}, which has no value")
        if variable.style in ("index", "string"):
            return variable.values[variable.at]
        if variable.style == "loop":
            return variable.values[1] % (int(variable.values[0]) + variable.at)
        if variable.style not in ("equal", "format", "internal"):
            raise Unknown(f"the variable {name} of style {variable.style}")
        if name in self.evaluated:
            raise Unknown(f"the variable {name}, whose formula contains itself")
        self.evaluated.add(name)
        try:
            if variable.style == "format":
                return _formatted(variable.values[1], number(self.text_of(variable.values[0])))
            return "%.15g" % _Formula(variable.values[0], self).value()
        except Unknown as reason:
            text = str(reason)
            raise Unknown(text if len(text) > 400 or f"{name}:" in text else f"{name}: {text}") from None
        finally:
            self.evaluated.discard(name)

    def expand(self, line: Line, inside_quotes: bool = False) -> Words:
        """Replaces the variables outside of quotes and splits the text into words.

        An unknown value is replaced by a mark with its name."""
        text, start, quote = line.raw, 0, ""
        pieces: List[Tuple[str, int, int]] = []
        length = len(text)
        for found in _DOLLAR.finditer(text) if "$" in text else ():
            dollar, sign = found.start(), found[0]
            if dollar < start:
                continue
            if quote:
                quote = "" if sign == quote else quote
            elif sign != "$":
                quote = "" if inside_quotes else sign
            else:
                end, value = self.replaced(text, dollar)
                pieces += [(text[start:dollar], start, dollar), (value, dollar, end)]
                start, length = end, length + len(value)
                if length > MAX_LINE:
                    raise OutOfBounds(f"The variables make a line of more than {MAX_LINE} characters.")
        pieces.append((text[start:], start, len(text)))
        return Words(line, [piece for piece in pieces if piece[0]])

    def replaced(self, text: str, dollar: int) -> Tuple[int, str]:
        """Returns the end of the variable at a dollar, and its value."""
        opening = text[dollar + 1 : dollar + 2]
        end = dollar + 2
        try:
            if opening == "{":
                end = text.find("}", dollar) + 1
                if end > 0:
                    return end, self.text_of(text[dollar + 2 : end - 1])
                end = len(text)
                raise Unknown(text[dollar:])
            if opening != "(":
                return end, self.text_of(opening)
            depth = 1
            while end < len(text) and depth:
                depth += (text[end] == "(") - (text[end] == ")")
                end += 1
            formula, colon, form = text[dollar + 2 : end - 1].rpartition(":")
            if colon and form.startswith("%"):
                return end, _formatted(form, _Formula(formula, self).value())
            return end, "%.20g" % _Formula(text[dollar + 2 : end - 1], self).value()
        except Unknown as reason:
            value = f"{text[dollar:end]}: {reason}".replace(_MARK, " ")
            return end, _MARK + re.sub(r"\s", _BLANK, value) + _MARK

    def set_variable(self, words: Words) -> None:
        name, style, old = words[1], words[2], self.variables.get(words[1])
        values = tuple(words[3:])
        if style == "delete":
            self.variables.pop(name, None)
        elif style in ("index", "universe", "uloop", "loop", "world", "getenv", "file", "atomfile") and old:
            return  # LAMMPS ignores a second definition
        elif style in ("index", "universe", "world") and values:
            if style == "world" and len(values) > 1:
                self.part(len(values))
            self.variables[name] = Variable("index", values, self.partition if style == "world" else 0)
        elif style in ("loop", "uloop"):
            self.variables[name] = self.loop([v for v in values if v != "pad"], "pad" in values)
        elif style == "string" and len(values) == 1:
            self.variables[name] = Variable("string", (self.expand(words.line._replace(raw=values[0]), True).expanded,))
        elif style in ("equal", "internal") and values:
            self.variables[name] = Variable(style, (" ".join(values),))
        elif style == "format" and len(values) == 2:
            self.variables[name] = Variable(style, values)
        elif style:
            self.variables[name] = Variable(style, values)

    def loop(self, values: List[str], padded: bool) -> Variable:
        try:
            first, last = (1, int(number(values[0]))) if len(values) == 1 else [int(number(v)) for v in values[:2]]
        except (Unknown, IndexError):
            return Variable("loop with an unknown count")
        return Variable("loop", (str(first), f"%0{len(str(last))}d" if padded else "%d", str(last)))

    def part(self, count: int) -> None:
        """Makes a world for each partition."""
        if self.partition or self.script.partitioned:
            return
        self.script.partitioned = True
        for k in range(1, min(count, MAX_WORLDS)):
            other = self.copy()
            other.partition = k
            other.pending = [self.place.raw]
            self.script.worlds.append(other)

    def advance(self, words: Words) -> None:
        """Executes `next`."""
        for name in words[1:]:
            old = self.variables.get(name)
            if old is None or old.style not in ("index", "loop"):
                self.script.remark(self.place, f"next {name}: the values of this variable are unknown here.")
                self.skip_jump = True
                continue
            count = len(old.values) if old.style == "index" else int(old.values[2]) - int(old.values[0]) + 1
            if old.at + 1 < count:
                self.variables[name] = old._replace(at=old.at + 1)
            else:
                del self.variables[name]
                self.skip_jump = True

    # -- flow --

    def open(self, name: str, words: Words) -> Optional[Source]:
        found = self.script.options.include(name, self.stack[-1][0].name) if is_known(name) and self.stack else None
        if found is None:
            shown = name.split(_MARK)[1].replace(_BLANK, " ") if not is_known(name) else name
            self.script.remark(
                words.line, f"The file {shown} cannot be read: it must be a plain file next to this one."
            )
            return None
        return Source(found[1], found[0])

    def include(self, words: Words) -> None:
        if len(self.stack) >= MAX_NESTED:
            self.script.remark(words.line, f"{words[1]}: more than {MAX_NESTED} nested files.")
            return
        source = self.open(words[1], words)
        if source:
            self.stack.append((source, 0, 1))

    def jump(self, words: Words) -> None:
        if self.skip_jump:
            self.skip_jump = False
            return
        source = self.stack[-1][0] if words[1] == "SELF" and self.stack else self.open(words[1], words)
        if source is None:
            self.stack.clear()
            return
        here, self.stack[-1] = self.stack[-1], (source, 0, 1)
        if len(words) > 2:
            key = source.name, words[2]
            if key not in self.script.labels:
                found = re.search(rf"^[ \t]*label[ \t]+{re.escape(words[2])}[ \t\r]*(#.*)?$", source.text, re.M)
                at = found.start() if found else -1
                self.script.labels[key] = at, 1 + source.text.count("\n", 0, max(at, 0))
            at, line = self.script.labels[key]
            if at < 0:
                self.script.remark(words.line, f"jump: {source.name} has no label {words[2]}.")
                self.stack.clear()
                return
            self.stack[-1] = (source, at, line)
            rounds = self.rounds.setdefault(key, [])
            rounds.append(self.system.count())
            if source.name == here[0].name and at < here[1] and self.script.is_late():
                text = "The loop takes too long to read; cor reads only its first rounds."
                self.script.remark(words.line, text, rounds[-1] != rounds[len(rounds) // 2])
                self.stack[-1] = here
                return
            self.label = words[2]

    def branch(self, words: Words) -> None:
        """Executes the first true branch of `if`. Each earlier branch with an unknown condition has its own world."""
        marks = [1] + [i for i in range(2, len(words)) if words[i] in ("elif", "else")] + [len(words)]
        branches: List[List[str]] = []
        unknown, is_true = "", False
        for start, end in zip(marks, marks[1:]):
            first = start + (start > 1)
            commands = words[first:end]
            is_true = start > 1 and words[start] == "else"
            if not is_true:
                commands = commands[1 + (words[first + 1] == "then") :]
                try:
                    test = self.expand(words.line._replace(raw=words[first]), True).expanded
                    is_true = is_known(test) and _Formula(test, self, True).value() != 0
                    reason = "" if is_known(test) else test.split(_MARK)[1]
                except Unknown as failure:
                    reason = str(failure)
                if not reason and not is_true:
                    continue
                unknown = unknown or reason
            branches.append(commands)
            if is_true:
                break
        if not is_true:
            branches.append([])
        if not unknown:
            self.execute_all(branches[-1], words.line)
            return
        if not any(self.matters(command) for commands in branches for command in commands):
            return
        place = (words.line.file, words.line.line)
        state = self.changes, dict(self.variables)
        if self.visited.get(place) == state:  # a loop that only a run can end
            self.stack.clear()
            self.is_left = True
            return
        self.visited[place] = state
        if place not in self.script.split and len(self.script.split) < MAX_WORLDS:
            self.script.split[place] = unknown.replace(_BLANK, " ")
            for commands in branches[:-1]:
                other = self.copy()
                other.pending = commands
                self.script.worlds.append(other)
        self.execute_all(branches[-1], words.line)

    def matters(self, command: str) -> bool:
        name = (command.split() or [""])[0]
        return "$" in name or name in _FLOW or hasattr(self.system, f"on_{name}")

    def execute_all(self, commands: Sequence[str], line: Line) -> None:
        self.depth += 1
        if self.depth > MAX_NESTED:
            self.script.remark(line, f"if: more than {MAX_NESTED} nested conditions.")
        else:
            for command in commands:
                if not self.label:
                    self.execute(line._replace(raw=command, nested=True))
        self.depth -= 1

    def execute(self, line: Line) -> None:
        self.script.tick()
        raw = _without_comment(line.raw)
        name = (raw.split(None, 1) or [""])[0]
        if not self.matters(name):
            return
        words = self.expand(line._replace(raw=raw))
        self.place = words.line
        name = words[0]
        if self.label:
            if name == "label" and words[1] == self.label:
                self.label = ""
        elif name in _FLOW:
            _FLOW[name](self, words)
        elif hasattr(self.system, f"on_{name}"):
            changes = self.script.attempt(line, name, lambda: getattr(self.system, f"on_{name}")(words))
            self.system.is_changed |= changes is not False
            self.changes += changes is not False

    def quit(self, words: Words) -> None:
        self.stack.clear()
        self.is_left = bool(self.script.split)  # after an unknown condition, LAMMPS may not reach this line

    def name_only(self, words: Words) -> None:
        if words[0] == "shell" and words[1] in ("mkdir", "rm", "rmdir", "cd", "echo"):
            return
        self.script.remark(words.line, f"{words[0]} is not executed; contacts that depend on it are wrong.", False)

    def run(self) -> None:
        """Executes until the files end."""
        self.execute_all(self.pending, self.place)
        while self.stack:
            source, at, line = self.stack[-1]
            if at >= len(source.text):
                if self.label:
                    self.stack.clear()
                else:
                    self.stack.pop()
                continue
            raw, at, after = _logical_line(source.text, at, line)
            self.stack[-1] = (source, at, after)
            self.script.tick()
            words = raw.split(None, 1)
            if words and self.matters(words[0]):
                self.execute(Line(source.name, line, after - 1, raw))
        if not self.is_left:
            self.script.attempt(self.place, "the script", self.system.finish)


def _formatted(form: str, value: float) -> str:
    if not re.fullmatch(r"%[-+ 0-9]{0,4}\.\d{1,2}[efgEFG]|%\d{0,2}[efgEFG]", form):
        raise Unknown(f"a number in the format {form}")
    return form % value


def _logical_line(text: str, at: int, line: int) -> Tuple[str, int, int]:
    """Returns a line with the lines that continue it (&, or an open triple quote), and the start of the next line."""
    parts: List[str] = []
    quoted = False
    while True:
        end = text.find("\n", at)
        end = len(text) if end < 0 else end
        part, at, line = text[at:end].rstrip(), end + 1, line + 1
        quoted ^= bool(part.count('"""') & 1)
        follows = at < len(text) and len(parts) < MAX_CONTINUED
        if follows and part.endswith("&"):
            parts.append(part[:-1])
        elif follows and quoted:
            parts.append(part + "\n")
        else:
            return "".join(parts) + part, at, line


_FLOW: Dict[str, Callable[[World, Words], None]] = {
    "variable": World.set_variable,
    "next": World.advance,
    "include": World.include,
    "jump": World.jump,
    "label": lambda world, words: None,
    "if": World.branch,
    "quit": World.quit,
    "shell": World.name_only,
    "python": World.name_only,
    "plugin": World.name_only,
}


class Script:
    """The worlds of a script. remarks: sentences about lines. split: place and reason of each unknown condition."""

    def __init__(self, options: Options):
        self.options = options
        self.remarks: Dict[Tuple[str, int, str], Remark] = {}
        self.worlds: List[World] = []
        self.split: Dict[Tuple[str, int], str] = {}
        self.labels: Dict[Tuple[str, str], Tuple[int, int]] = {}  # offset and line, by file and label
        self.partitioned = False
        self.count, self.next_progress = 0, time.monotonic() + 1
        self.set_end(MAX_SECONDS)

    def set_end(self, seconds: float) -> None:
        self.end, self.processor_end = time.monotonic() + 1.4 * seconds, time.process_time() + seconds

    def is_late(self) -> bool:
        """True if half of the time is over."""
        half = MAX_SECONDS / 2
        return time.monotonic() > self.end - 1.4 * half or time.process_time() > self.processor_end - half

    def remark(self, line: Line, text: str, matters: bool = True) -> None:
        if len(self.remarks) < 200:
            self.remarks.setdefault((line.file, line.line, text), Remark(line.file, line.line, text, matters))

    def attempt(self, line: Line, name: str, command: Callable[[], Any]) -> Any:
        try:
            return command()
        except Unknown as reason:
            text = f"{name}: a value is unknown: {reason}".replace(_BLANK, " ").replace(_MARK, "")
            self.remark(line, text)
        except (ArithmeticError, IndexError, ValueError):
            self.remark(line, f"{name}: its numbers are missing or out of range.")
        return None

    def tick(self) -> None:
        self.count += 1
        if self.count % 64 == 0:
            now = time.monotonic()
            if now > self.end or time.process_time() > self.processor_end:
                raise OutOfBounds(f"The script takes more than {MAX_SECONDS:g} s to read; the rest is not read.")
            if now > self.next_progress:
                self.next_progress = now + 1
                self.options.progress("reading the script")
        if self.count > 20 * MAX_COMMANDS:
            raise OutOfBounds("The loops of the script have more commands than cor reads; the rest is not read.")

    def run(self, text: str, name: str, system: System) -> None:
        """Executes a script in all its worlds."""
        world = World(self, system)
        for key, values in self.options.variables.items():
            world.variables[key] = Variable("index", tuple(values))
        world.stack = [(Source(name, text), 0, 1)]
        self.worlds = [world]
        while self.worlds:
            world = self.worlds.pop()
            try:
                world.run()
            except OutOfBounds as reason:
                self.remark(world.place, str(reason))
                self.count = 0
                self.set_end(MAX_SECONDS / 6)
                try:
                    self.attempt(world.place, "the script", world.system.finish)
                except OutOfBounds:
                    pass
                self.worlds.clear()
