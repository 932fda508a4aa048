# SPDX-License-Identifier: MIT
"""Reads measured bounces from a csv file, a file object, a pandas object, or arrays."""

import csv
import math
import re
from os import PathLike, fspath
from typing import Any, Callable, Dict, List, NamedTuple, NoReturn, Optional, Tuple

import numpy as np

from .data import MAX_BEYOND, MAX_FLIGHT_RATIO, Apexes, Data, DataError, Floats, Form, Heights, Ints, Points, Times
from .track import find_bounces

MAX_ROWS, MAX_COLUMNS, MAX_LINE, BLOCK, SHOWN = 1000000, 256, 65536, 1 << 22, 40
MAX_ABOVE, MAX_GAP = 50, 5  # limits: rows above the names; successive rows without height in a track
WAVEFORM_ROWS = 100  # this number of equal steps means samples, not bounces

# ---- names of columns ----

UNITS = {
    "speed": {"m/s": 1.0, "cm/s": 0.01, "mm/s": 0.001, "ft/s": 0.3048},
    "height": {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048},
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6},
}
UNIT_NAMES = [unit for units in UNITS.values() for unit in units]
ALIASES = dict(zip("µs μs sec seconds m_s cm_s mm_s ft_s meters inch inches feet".split(),
                   "us us s s m/s cm/s mm/s ft/s m in in ft".split()))  # fmt: skip

# Key, dimension, least number in SI units, and other names of the column (letters and digits only)
ROWS = """\
speed speed 1e-30 v v0 vin speedin vbefore speedbefore velocity velocityin impactspeed impactvelocity
speed_out speed 0 v1 vout vafter speedafter velocityout reboundspeed reboundvelocity
eps - -1e31 epsilon ε e cor restitution coefficientofrestitution
h0 height 1e-30 dropheight hbefore heightbefore hdrop initialheight
h1 height 0 rebound reboundheight hafter heightafter hrebound bounceheight
h height 1e-30 apex apexheight y z position positiony
t time 0 timestamp bouncetime timeofbounce xvalue
interval time 1e-30 intervals timeinterval timebetweenbounces dt δt deltat flight flighttime
run label 0
ball label 0
"""


class Quantity(NamedTuple):
    dimension: str
    names: List[str]
    least: float


QUANTITIES: Dict[str, Quantity] = {}
for _key, _dimension, _least, *_names in map(str.split, ROWS.splitlines()):
    _names = [_key.replace("_", ""), *_names] + [_dimension] * (_key in ("t", "h"))
    QUANTITIES[_key] = Quantity(_dimension, _names, float(_least))
    QUANTITIES[_key + "_sigma"] = Quantity(_dimension, [n + "sigma" for n in _names], 1e-30)
SIGMA_WORDS = "sigma std stdev stddev sd sem err error errors uncertainty unc σ delta standarddeviation standarderror"
# Each kind of record: its required and its optional columns. A kind has priority over the kinds below it.
KINDS: List[Tuple[str, List[str], List[str]]] = [
    ("points", ["speed", "eps"], ["eps_sigma"]),
    ("speeds", ["speed", "speed_out"], ["speed_sigma", "speed_out_sigma"]),
    ("heights", ["h0", "h1"], ["h0_sigma", "h1_sigma"]),
    ("track", ["t", "h"], []),
    ("times", ["t"], ["h0"]),
    ("intervals", ["interval"], ["h0"]),
    ("apexes", ["h"], ["h_sigma", "h0"]),
    ("heights", ["h1"], ["h1_sigma"]),  # needs --drop-height
]
WANTED = (
    "a row with the names and units of the columns above the numbers, such as speed_m_s,eps or "
    "speed_cm_s,eps,eps_sigma, speed_m_s,speed_out_m_s, h0_cm,h1_cm, h_cm for successive apexes, t_s for times of "
    "bounces, interval_ms, or time_s,height_m for a track"
)
_UNIT_END = re.compile(
    r"^(?P<base>.*?)(?:[\s_]*[(\[](?P<in>[^()\[\]]*)[)\]]"
    r"|[\s_/]+(?P<end>(?:mm|cm|m|ft)[/_]s|mm|cm|m|in|ft|s|ms|us|µs|μs|sec))$",
    re.I | re.S,
)


def _plain(name: str) -> str:
    """Return the letters and digits of a name, in lower case."""
    return "".join(c for c in name.lower()[: 4 * SHOWN] if c.isalnum())


def _split_name(name: str) -> Tuple[str, Optional[str]]:
    """Return the plain name without its unit, and the unit, or None if the name has no unit. "Latest: Time (s)" and
    "Time (s) Run #1" have the plain name "time"."""
    name = re.sub(r"\s+Run #?\d+$", "", name.strip()).rpartition(": ")[2]
    found = _UNIT_END.match(name)
    if not found or (found["end"] == "in" and _plain(found["base"]) in QUANTITIES["speed"].names):  # v_in
        return _plain(name), None
    unit = (found["in"] if found["in"] is not None else found["end"]).strip().lower()
    return _plain(found["base"]), ALIASES.get(unit, unit)


def _is_near(a: str, b: str) -> bool:
    """True if the names differ by one inserted, missing or wrong letter, or by two swapped letters."""
    if len(b) < 3 or a == b or abs(len(a) - len(b)) > 1:
        return a == b
    i = next((k for k in range(min(len(a), len(b))) if a[k] != b[k]), min(len(a), len(b)))
    swapped = a[i : i + 2] == b[i : i + 2][::-1] and a[i + 2 :] == b[i + 2 :]
    return swapped or a[i + 1 :] == b[i + 1 :] or a[i:] == b[i + 1 :] or a[i + 1 :] == b[i:]


# ---- a table of cells ----


class Table:
    """Columns of cells. Messages name the file, the line and the column of a cell."""

    def __init__(self, name: str, word: str, form: Form) -> None:
        self.name, self.word, self.form = name, word, form
        self.header: List[str] = []
        self.separator = form.separator or ""
        self.columns: List[Any] = []  # lists of texts, or arrays
        self.line: Ints = np.zeros(0, dtype=np.int64)
        self.header_line = self.last_line = 1
        self.found: Dict[str, int] = {}  # the column of a quantity
        self.factor: Dict[str, float] = {}  # factor from its unit to SI
        self.remarks: List[str] = []

    def refuse(self, line: int, key: Optional[str], why: str) -> NoReturn:
        where = [f"{self.word} {line}"] * (self.word == "line" or line != self.header_line)
        where += [f"column {self.header[self.found[key]][:SHOWN]}"] if key else []
        raise DataError(": ".join(filter(None, [self.name, ", ".join(where), why])))

    def refuse_row(self, row: int, key: str, why: str) -> NoReturn:
        self.refuse(int(self.line[row]), key, why)

    def has(self, key: str) -> bool:
        return key in self.found

    def cell(self, row: int, key: str) -> str:
        return str(self.columns[self.found[key]][row]).strip(" \t")[:SHOWN]

    def numbers(self, key: str, least: Optional[float] = None) -> Floats:
        """Return a column in SI units. Refuse the first cell that is not an allowed number."""
        column = self.columns[self.found[key]]
        if not (isinstance(column, np.ndarray) and column.dtype.kind in "iuf"):
            column = [_number(str(cell), self.form.decimal_comma) for cell in column]
        with np.errstate(invalid="ignore", over="ignore"):
            values = np.asarray(column, dtype=np.float64) * self.factor[key]
            wrong = ~((values >= (QUANTITIES[key].least if least is None else least)) & (values <= 1e30))
        if wrong.any():
            self.refuse_cell(int(np.argmax(wrong)), key)
        return values

    def optional(self, key: str) -> Optional[Floats]:
        return self.numbers(key) if self.has(key) else None

    def refuse_cell(self, row: int, key: str) -> NoReturn:
        text, quantity = self.cell(row, key), QUANTITIES[key]
        allowed = f"a {quantity.dimension} {'above 0 and up' if quantity.least else 'from 0'} to 1e30, such as 0.25"
        allowed = "a number from 1e-30 to 1e30, such as 0.01" if key.endswith("_sigma") else allowed
        allowed = "a number from 0 to 1, such as 0.85" if key == "eps" else allowed
        why = "the cell is empty" if text in ("", "nan" if self.word == "row" else "") else f"'{text}' is not allowed"
        if self.form.decimal_comma and "." in text:
            why = f"'{text}' has a decimal point, but --decimal-comma is given"
            allowed += ", or the command without --decimal-comma"
        elif not self.form.decimal_comma and "," in text:
            why, allowed = f"'{text}' has a decimal comma", allowed + ", or --decimal-comma"
        self.refuse_row(row, key, f"{why}; allowed: {allowed}")

    def labels(self, key: str) -> List[str]:
        return [str(c).strip(" \t") for c in self.columns[self.found[key]]] if self.has(key) else []


def _number(text: str, decimal_comma: bool) -> float:
    """Return the value of a decimal number in ASCII; nan for other text."""
    if decimal_comma:
        text = text.replace(".", "x").replace(",", ".")
    try:
        return float(text) if text.isascii() and "_" not in text else np.nan
    except ValueError:
        return np.nan


def _is_number(cell: str) -> bool:
    return math.isfinite(_number(cell.replace(",", "."), False))


def _check_encoding(table: Table, block: bytes) -> bytes:
    """Return the first block without the byte order mark of UTF-8."""
    for form, mark, zero in (("UTF-16LE", b"\xff\xfe", 1), ("UTF-16BE", b"\xfe\xff", 0)):
        if block[:2] == mark or (len(block) > 1 and block[zero] == 0 and block[1 - zero] != 0):
            allowed = f"UTF-8; convert the file by iconv -f {form} -t UTF-8 FILE"
            table.refuse(1, None, f"the text is {form}; allowed: {allowed}")
    return block[3:] if block.startswith(b"\xef\xbb\xbf") else block


def _separator(table: Table, line: str) -> str:
    return table.separator or max(",;\t", key=re.sub('"[^"]*"', "", line).count)


def _split(table: Table, number: int, line: str, separator: str) -> List[str]:
    """Return the cells of a line; [] for a comment or empty cells."""
    if len(line) > MAX_LINE:
        table.refuse(number, None, f"longer than {MAX_LINE} characters; allowed: csv, such as speed_m_s,eps")
    if "\0" in line or "\r" in line:
        table.refuse(number, None, "has a control character; allowed: text with lines that end in LF or CR LF")
    if not line.strip(" \t,;") or line.lstrip(" \t")[0] == "#":
        return []
    return (
        next(csv.reader([line], delimiter=separator, skipinitialspace=True)) if '"' in line else line.split(separator)
    )


def _cells(table: Table, number: int, line: str) -> List[str]:
    """Return the cells of a row. Cells at its end may be missing or empty, if their columns are not read."""
    cells = _split(table, number, line, table.separator)
    missing = len(table.header) - len(cells)
    if cells and (any(cells[missing:]) if missing < 0 else max(table.found.values()) >= len(cells)):
        word = {",": "commas", ";": "semicolons", "\t": "tabs"}[table.separator]
        count = f"{len(cells)} cell{'s' * (len(cells) != 1)}"
        why = f"{count}, but the row of names has {len(table.header)}; allowed: the same number, separated by "
        point = "comma" if table.form.decimal_comma else "point"
        table.refuse(number, None, f"{why}{word}, and numbers with a decimal {point}")
    return (cells + [""] * missing)[: len(table.header)] if cells else []


def _read_csv(table: Table, file: Any, progress: Callable[[str], None]) -> None:
    number, rest, size = 0, b"", MAX_LINE + 2
    columns: List[List[str]] = []
    places: List[int] = []
    while True:
        raw = file.read(size)
        block = rest + (raw.encode("utf-8", "surrogateescape") if isinstance(raw, str) else raw)
        block = block if number else _check_encoding(table, block)
        end = block.rfind(b"\n") + 1
        end = end if raw and len(block) - end <= MAX_LINE + 1 else len(block)  # whole lines, or the rest
        rest = block[end:]
        lines = block[:end].replace(b"\r\n", b"\n").decode("utf-8", "surrogateescape").split("\n")
        lines = lines if lines[-1] else lines[:-1]
        text, others = "\n".join(lines), len(columns) - 1
        begin = 0 if columns else _find_names(table, number, lines)
        columns = columns or [[] for _ in table.header]
        if (  # a fast way for regular rows
            not begin
            and columns
            and not any(c in text for c in '"#\0\r')
            and table.separator * others not in lines
            and all(line.count(table.separator) == others for line in lines)
        ):
            cells = text.replace(table.separator, "\n").split("\n") if lines else []
            for i, column in enumerate(columns):
                column += cells[i :: len(columns)]
            places += range(number + 1, number + len(lines) + 1)
        else:
            for at, line in enumerate(lines[begin:], number + begin + 1) if columns else ():
                cells = _cells(table, at, line)
                if cells:
                    places.append(at)
                    for column, cell in zip(columns, cells):
                        column.append(cell)
        number += len(lines)
        if len(places) > MAX_ROWS:
            why = f"more than {MAX_ROWS} rows; leave out rows, for example all except every tenth"
            table.refuse(places[MAX_ROWS], None, why)
        progress(f"reading: {number} lines")
        if not raw:
            break
        size = BLOCK
    table.last_line = max(number, 1)
    if not columns:
        table.refuse(
            table.last_line, None, "the file is empty; allowed: a row of names, such as speed_m_s,eps, and rows"
        )
    table.columns, table.line = columns, np.array(places, dtype=np.int64)


def _find_names(table: Table, number: int, lines: List[str]) -> int:
    """Set the names of the columns. Return the number of lines above the rows of numbers, or 0 if there are only
    comments. Rows above the names, as in files of Tracker or Logger Pro, are not read. A row of units may follow."""
    rows = [(at, line) for at, line in enumerate(lines[:MAX_ABOVE], 1) if _split(table, number + at, line, ",")]
    if not rows:
        return 0
    labview = [k for k, (_, line) in enumerate(rows[:-1]) if line.startswith("***End_of_Header***")]
    first = labview[-1] + 1 if labview else 0

    def cells_of(k: int) -> List[List[str]]:
        """Return the cells of row k and of three rows below it."""
        separator = _separator(table, rows[k][1])
        return [_split(table, number + at, line, separator) for at, line in rows[k : k + 4]]

    def is_above_numbers(k: int) -> bool:
        names, *below = cells_of(k)
        named, (kind, needed, _) = _match(names, table.form)
        places = [named[key][0] for key in needed if kind]
        return bool(kind) and any(
            len(cells) > max(places) and all(_is_number(cells[i]) for i in places) for cells in below
        )

    k = next(filter(is_above_numbers, range(first, len(rows))), first)
    at, line = rows[k]
    names, *below = cells_of(k)
    table.header_line, table.header, table.separator = number + at, [c.strip() for c in names], _separator(table, line)
    if len(names) > MAX_COLUMNS:
        table.refuse(number + at, None, f"more than {MAX_COLUMNS} cells; allowed: csv, such as speed_m_s,eps")
    for (last, _), cells in zip(rows[k + 1 :], below[:2]):
        units = [cell.strip(" ()[]") for cell in cells]
        if not any(map(_is_number, units)) and any(unit in (*ALIASES, *UNIT_NAMES) for unit in units):
            units += [""] * len(table.header)
            table.header, at = [f"{name} ({u})" if u else name for name, u in zip(table.header, units)], last
            break
    choose_columns(table)
    if k:
        table.remarks.append(f"The names are in line {table.header_line}; lines above are not read.")
    return at


# ---- columns and units ----


def _match(header: List[str], form: Form) -> Tuple[Dict[str, List[int]], Tuple[str, List[str], List[str]]]:
    """Return the columns of each quantity, and the kind of record that they give."""
    plain = [_split_name(name)[0] for name in header]
    places = {key: [i for i, p in enumerate(plain) if p in quantity.names] for key, quantity in QUANTITIES.items()}
    named = {key: found for key, found in places.items() if found}
    kinds = KINDS if form.drop_height_m is not None else KINDS[:-1]
    unknown: Tuple[str, List[str], List[str]] = ("", ["speed"], ["eps", "eps_sigma", "t", "h0", "h1"])
    return named, next((k for k in kinds if all(key in named for key in k[1])), unknown)


def choose_columns(table: Table) -> Tuple[str, List[str]]:
    """Find the quantities of the columns, the kind of record and the units. Return the kind and the unused columns."""
    line, form, split = table.header_line, table.form, [_split_name(name) for name in table.header]
    named, (kind, needed, more) = _match(table.header, form)
    keys = needed + more + ["run", "ball"]
    used = {i for key in keys for i in named.get(key, [])}
    for i, name in enumerate(table.header):
        near = None if i in used else _near_name(split[i][0], [k for k in keys if k not in named], kind)
        if near:
            why = f"the column '{name[:SHOWN]}' is unknown, but its name is close to {near}"
            table.refuse(line, None, f"{why}; allowed: {near}, or a different name, such as remark")
    if not kind:
        missing = "eps or speed_out_m_s" if "speed" in named else "h1_cm" if "h0" in named else "speed_m_s"
        missing = "h0_cm, or --drop-height" if "h1" in named and "h0" not in named else missing
        names = ", ".join(f"'{name[:SHOWN]}'" for name in table.header[:4])
        why = f"no column {missing}" if named else f"{names}: cor fit reads no such column"
        letters = [re.sub(r"\d", "", plain) for plain, _ in split]
        if not named and any(letters.count(text) > 1 for text in letters if text):
            table.refuse(line, None, f"{names}: numbered columns; allowed: one column with a row for each bounce, such "
                         "as interval_s for times between bounces, t_s or h_cm")  # fmt: skip
        table.refuse(line, None, f"{why}; allowed: {WANTED}")
    table.found = {key: named[key][-1] for key in ["eps", *keys] if key in named}
    if "eps" in named and kind not in ("points", "speeds"):
        other = table.header[named[needed[0]][0]]
        why = f"{other} already gives speed and eps; allowed: {other} without eps, or speed_m_s with eps"
        table.refuse(line, "eps", why)
    units: Dict[str, str] = {}
    for unit in form.unit.split(",") if form.unit is not None else []:
        known = [d for d in UNITS if ALIASES.get(unit, unit) in UNITS[d]]
        if not known:
            raise DataError(f"--unit: '{unit}' is not a unit; allowed: {', '.join(UNIT_NAMES)}")
        units[known[0]] = ALIASES.get(unit, unit)
    for key in keys:
        places = named.get(key, [])
        if len(places) > 1:
            same = split[places[0]] == split[places[1]]
            what = "columns of this name" if same else f"columns of {QUANTITIES[key].names[0]}s"
            table.refuse(
                line,
                key,
                f"the file has two {what}; allowed: one column; put drops below each other, with a column named run",
            )
        if places:
            without = {QUANTITIES[k].dimension: 0 for k in keys if k in named and split[named[k][0]][1] is None}
            table.factor[key] = _factor(table, key, split[places[0]][1], units, [d for d in without if d in UNITS])
    for dimension, unit in units.items():
        if dimension not in [QUANTITIES[key].dimension for key in table.found]:
            allowed = ", ".join(UNITS.get(QUANTITIES[needed[0]].dimension, UNIT_NAMES))
            table.refuse(line, needed[0], f"--unit {unit} does not fit any column that is read; allowed: {allowed}")
    return kind, [name for i, name in enumerate(table.header) if i not in used and name]


def _factor(table: Table, key: str, unit: Optional[str], given: Dict[str, str], without: List[str]) -> float:
    """Return the factor to SI units. given: the units of --unit. without: dimensions of columns without a unit."""
    dimension, line = QUANTITIES[key].dimension, table.header_line
    if dimension not in UNITS:
        return 1.0
    allowed, option = UNITS[dimension], given.get(dimension)
    if unit is None and option is None:
        names = [f"{key}_{u.replace('/', '_')}" for u in allowed]
        example = f"--unit, for example --unit {','.join(list(UNITS[d])[1] for d in without)}"
        table.refuse(line, key, f"the name has no unit; allowed: {', '.join(names[:-1])} or {names[-1]}, or {example}")
    if unit is not None and unit not in allowed:
        table.refuse(line, key, f"'{unit}' is not a unit of {dimension}; allowed: {', '.join(allowed)}")
    if unit is not None and option not in (None, unit):
        table.refuse(line, key, f"--unit {option} contradicts the unit in the name; allowed: --unit {unit}, or none")
    return allowed[unit or option or ""]


def _near_name(plain: str, missing: List[str], kind: str) -> Optional[str]:
    """Return the missing column whose name is nearly this name."""
    for key in missing:
        names, words = QUANTITIES[key].names, SIGMA_WORDS.split()
        bases = [n[: -len("sigma")] for n in names] + [""] * (key in ("eps_sigma", "h1_sigma", "h_sigma"))
        if _is_near(plain, names[0]) or (
            key.endswith("_sigma") and any(plain in (b + w, w + b, f"{w}of{b}") for b in bases for w in words)
        ):
            return key + {"speed": "_m_s", "height": "_cm", "time": "_s"}.get(QUANTITIES[key].dimension, "")
    return None


# ---- records ----


def _starts(ball: Ints, run: List[str]) -> Ints:
    """Return the rows at which a drop begins, and the number of rows."""
    begins = np.arange(len(ball)) == 0
    begins[1:] |= np.diff(ball) != 0
    if run:
        text = np.array(run)
        begins[1:] |= text[1:] != text[:-1]
    return np.append(np.flatnonzero(begins), len(ball))


def _refuse_gain(table: Table, key: str, eps: Floats, rows: Optional[Ints] = None) -> None:
    """Refuse the first rebound whose eps is above 1 by more than noise explains."""
    for at in np.flatnonzero(eps > MAX_FLIGHT_RATIO):
        why = f"the rebound gives eps = {eps[at]:.4g}; allowed: up to 1, or with noise up to {MAX_FLIGHT_RATIO}"
        table.refuse_row(int(at if rows is None else rows[at]), key, why)


def _points(table: Table, ball: Ints, _start: Ints) -> Points:
    speed, eps, sigma = table.numbers("speed"), table.numbers("eps"), table.optional("eps_sigma")
    beyond = np.maximum(eps - 1, -eps)
    for row in np.flatnonzero(beyond > (0 if sigma is None else MAX_BEYOND * sigma)):
        if sigma is None:
            table.refuse_cell(int(row), "eps")
        why = f"'{table.cell(row, 'eps')}' is {beyond[row] / sigma[row]:.3g} eps_sigma beyond {int(eps[row] > 1)}"
        allowed = f"a number from 0 to 1, or up to {MAX_BEYOND} eps_sigma outside"
        table.refuse_row(int(row), "eps", f"{why}; allowed: {allowed}")
    return Points(speed, eps, sigma, table.line, ball)


def _speeds(table: Table, ball: Ints, _start: Ints) -> Points:
    before, after = table.numbers("speed"), table.numbers("speed_out")
    eps, errors = after / before, [table.optional("speed_sigma"), table.optional("speed_out_sigma")]
    _refuse_gain(table, "speed_out", eps)
    known = [0 * eps if e is None else e for e in errors]
    sigma = np.hypot(eps * known[0], known[1]) / before if any(e is not None for e in errors) else None
    return Points(before, eps, sigma, table.line, ball)


def _drop_heights(table: Table, rows: int) -> Floats:
    """Return the drop height of each row, nan where it is unknown. An empty cell repeats the one above."""
    if not table.has("h0"):
        return np.full(rows, np.nan if table.form.drop_height_m is None else float(table.form.drop_height_m))
    cells = table.labels("h0")
    for i in range(1, rows):
        cells[i] = cells[i - 1] if cells[i] in ("", "nan") else cells[i]
    table.columns[table.found["h0"]] = cells
    return table.numbers("h0")


def _heights(table: Table, ball: Ints, _start: Ints) -> Heights:
    rebound = table.numbers("h1")
    drop = _drop_heights(table, len(rebound))
    _refuse_gain(table, "h1", np.sqrt(rebound / drop))
    return Heights(drop, rebound, table.optional("h0_sigma"), table.optional("h1_sigma"), table.line, ball)


def _times(table: Table, ball: Ints, start: Ints) -> Times:
    """Return the drops of measured times. Times of intervals are their sums, from 0 in each drop."""
    key = "t" if table.has("t") else "interval"
    time, first = table.numbers(key), start[:-1]
    row = np.arange(len(time))
    height = _drop_heights(table, len(time))[first]
    if key == "interval":
        total = np.cumsum(time)
        time = np.insert(total - np.repeat(total[first] - time[first], np.diff(start)), first, 0.0)
        row, start = np.insert(row, first, first), start + np.arange(len(start))
        table.remarks.append(f"The intervals give {len(time)} times of bounces.")
    flight, inside = np.diff(time), np.ones(len(time), dtype=bool)  # inside: flights that end at a bounce
    inside[start[:-1]] = False
    for at in np.flatnonzero(inside[1:] & (flight <= 0)) + 1:
        text = f"{table.cell(row[at], key)} is not after the previous bounce"
        allowed = "ascending times within a drop; each drop needs its own text in the column named run"
        table.refuse_row(row[at], key, f"{text}; allowed: {allowed}")
    _refuse_waveform(table, key, flight[inside[1:]])
    counts, needed = np.diff(start), np.where(np.isnan(height), 3, 2)
    for k in np.flatnonzero(counts < needed):
        last = k + 1 == len(counts)
        why = f"the drop {'' if last else 'before this line '}has {counts[k]} bounce{'' if counts[k] == 1 else 's'}"
        allowed = f"{needed[k]} or more, because a smaller number gives no eps"
        allowed += "; 2 or more with the height of the drop, --drop-height or h0_cm" if needed[k] == 3 else ""
        at_line = table.last_line if last else int(table.line[row[start[k + 1]]])
        table.refuse(at_line, key, f"{why}; allowed: {allowed}")
    later = np.flatnonzero(inside[1:] & np.append(False, inside[1:-1]))  # flights that follow another one
    for at in later[flight[later] > MAX_FLIGHT_RATIO * flight[later - 1]]:
        why = (
            f"a flight of {flight[at]:g} s after one of {flight[at - 1]:g} s gives eps = {flight[at] / flight[at-1]:g}"
        )
        allowed = f"eps up to 1, or with noise up to {MAX_FLIGHT_RATIO}"
        table.refuse_row(row[at + 1], key, f"{why}; allowed: {allowed}")
    return Times(time, table.line[row], start, height, ball[first])


def _refuse_waveform(table: Table, key: str, flight: Floats) -> None:
    """Refuse time steps that are equal up to rounding. Such data are samples of a sound or of a force."""
    step = float(np.median(flight)) if len(flight) >= WAVEFORM_ROWS else np.nan
    is_rounded = step > 0 and np.unique(np.round(flight / step, 3)).size <= 3  # steps of 0.02, 0.02, 0.03 ms
    if is_rounded or np.mean(np.abs(flight - step) <= 0.1 * step) > 0.9 if len(flight) else False:
        why = f"{len(flight)} steps of {step:.4g} s belong to a waveform sampled at {1 / step:.5g} Hz, not to times"
        allowed = "the times of its peaks, a row for each bounce, or a track with the columns time_s,height_m"
        table.refuse_row(0, key, f"{why} of bounces; allowed: {allowed}")


def _leave_out_gaps(table: Table) -> None:
    """Leave out the rows of a track that lack time or height. Refuse more than MAX_GAP such rows in succession."""
    empty = [any(c.lower() in ("", "nan") for c in pair) for pair in zip(table.labels("t"), table.labels("h"))]
    rows = np.flatnonzero(np.logical_not(empty))
    for k in np.flatnonzero(np.diff(rows) > MAX_GAP + 1):
        why = f"{rows[k + 1] - rows[k] - 1} rows have no height; allowed: up to {MAX_GAP} in succession"
        table.refuse_row(int(rows[k]) + 1, "h", f"{why}, or separate the drops by a column named run")
    if len(rows) < len(empty):
        table.columns = [np.asarray(column)[rows] for column in table.columns]
        table.remarks.append(f"{len(empty) - len(rows)} rows without a height are left out.")
        table.line = table.line[rows]


def _track(table: Table, ball: Ints, start: Ints) -> Times:
    time, height, run = table.numbers("t"), table.numbers("h", -1e30), table.labels("run")
    parts, lines = [], []
    for a, b in zip(start[:-1], start[1:]):
        for at in a + 1 + np.flatnonzero(np.diff(time[a:b]) <= 0):
            allowed = "ascending times within a drop; each drop needs its own text in the column named run"
            table.refuse_row(at, "t", f"{table.cell(at, 't')} is not after the previous row; allowed: {allowed}")
        try:
            parts.append(find_bounces(time[a:b], height[a:b]))
        except ValueError as error:
            table.refuse_row(a, "h", str(error))
        found = parts[-1]
        lines.append(table.line[a + found.row])
        what = f"The track{f' of {run[a]}' if run else ''} has {len(found.time_s)} resolved bounces, from "
        what += f"{found.time_s[0]:.4g} s to {found.time_s[-1]:.4g} s"
        table.remarks.append(f"{what}; its flights give g = {found.gravity_m_s2:.3g} m/s^2.")
    given, first = table.form.drop_height_m, start[:-1]
    height = np.array([p.drop_height_m if given is None else given for p in parts])
    start = np.append(0, np.cumsum([len(p.time_s) for p in parts]))
    return Times(np.concatenate([p.time_s for p in parts]), np.concatenate(lines), start, height, ball[first])


def _apexes(table: Table, ball: Ints, start: Ints) -> Apexes:
    height, sigma, first = table.numbers("h"), table.optional("h_sigma"), start[:-1]
    row = np.arange(len(height))
    drop = _drop_heights(table, len(height))[first]
    if not np.isnan(drop).any():
        height, row = np.insert(height, first, drop), np.insert(row, first, first)
        sigma = None if sigma is None else np.insert(sigma, first, sigma[first])
        start = start + np.arange(len(start))
    inside = np.ones(len(height), dtype=bool)
    inside[start[:-1]] = False
    _refuse_gain(table, "h", np.sqrt(height[1:] / height[:-1]) * inside[1:], row[1:])
    for k in np.flatnonzero(np.diff(start) < 2):
        why = "the drop has 1 apex; allowed: 2 or more, or the height of the drop, --drop-height or h0_cm"
        table.refuse_row(row[start[k]], "h", why)
    return Apexes(height, sigma, table.line[row], start, ball[first])


# ---- sources ----


def _array_table(source: Any, form: Form) -> Table:
    """Return the table of a pandas object, a dict, a structured array, or arrays without names in SI units."""
    table = Table("the data", "row", form)
    if hasattr(source, "iloc"):
        series = not hasattr(source, "columns")
        names = [source.name or "t_s"] if series else list(source.columns)
        columns = [source] if series else [source.iloc[:, i] for i in range(len(names))]
    elif isinstance(source, dict):
        names, columns = list(source), list(source.values())
    elif getattr(getattr(source, "dtype", None), "names", None):
        names, columns = list(source.dtype.names), [source[c] for c in source.dtype.names]
    else:
        array = source if isinstance(source, (tuple, list)) else np.asarray(source)
        if not isinstance(array, tuple):
            array = np.asarray(array, dtype=np.float64)
            array = [array] if array.ndim == 1 else list(array.T) if array.ndim == 2 else []
        columns, names = list(array), ["t_s"] if len(array) == 1 else ["speed_m_s", "eps", "eps_sigma"][: len(array)]
        if not 1 <= len(columns) <= 3:
            allowed = "(speed, eps) or (speed, eps, eps_sigma) in m/s, times of bounces in s, or a dict with names"
            raise DataError(f"the data: {len(columns)} columns without names; allowed: {allowed}")
    table.header = [str(c) for c in names]
    table.columns = [np.asarray(c.to_numpy() if hasattr(c, "to_numpy") else c) for c in columns]
    if len({c.shape for c in table.columns}) != 1 or table.columns[0].ndim != 1:
        raise DataError("the data: columns of different shapes; allowed: arrays of one dimension and one length")
    table.line = np.arange(len(table.columns[0]), dtype=np.int64)
    table.header_line, table.last_line = -1, len(table.line)
    return table


def read(source: Any, form: Form = Form(), progress: Callable[[str], None] = lambda step: None) -> Data:
    """Return the data of a path ("-": standard input), an open file, a pandas object, a dict, or arrays.

    Raises OSError, or DataError with a text that names the place, the allowed values and an example."""
    if isinstance(source, (str, PathLike)):
        path = fspath(source)
        table = Table("standard input" if path == "-" else str(path), "line", form)
        with open(0 if path == "-" else path, "rb", closefd=path != "-") as file:
            _read_csv(table, file, progress)
    elif hasattr(source, "read"):
        name = getattr(source, "name", None)
        table = Table(name if isinstance(name, str) else "the file", "line", form)
        _read_csv(table, source, progress)
    else:
        table = _array_table(source, form)
    kind, unused = choose_columns(table)
    if kind == "track":
        _leave_out_gaps(table)
    names, run = table.labels("ball"), table.labels("run")
    number = {name: i for i, name in enumerate(dict.fromkeys(names))}
    ball = np.array([number[n] for n in names] if names else [0] * len(table.line), dtype=np.int64)
    if len(table.line) == 0:
        table.refuse(table.last_line, None, "the file has no rows of numbers; allowed: 1 or more, such as 0.1,0.93")
    readers: Dict[str, Callable[[Table, Ints, Ints], Any]] = {
        "points": _points, "speeds": _speeds, "heights": _heights, "track": _track, "apexes": _apexes
    }  # fmt: skip
    record = readers.get(kind, _times)(table, ball, _starts(ball, run))
    return Data(table.name, record, tuple(number), tuple(unused), tuple(table.remarks), table.word)
