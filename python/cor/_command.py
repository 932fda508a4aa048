# SPDX-License-Identifier: MIT
"""Implements the command cor: options, messages, tables and files, which its subcommands share.

A subcommand is a module with NAME, SUMMARY, add_arguments(parser) and run(options) -> exit status. Its output goes
through write_output, its errors are UsageError (status 2) or Failure (status 1).
"""

import argparse
import csv
import io
import json
import math
import os
import resource
import stat
import sys
import tempfile
import time
from importlib import import_module
from typing import Any, Dict, List, NoReturn, Optional, Sequence, Union

import numpy as np

STATUS_OK, STATUS_FAILED, STATUS_USAGE = 0, 1, 2
SUBCOMMANDS = {
    "audit": ("cor._audit.command", "the eps that the input of a simulator really gives"),
    "fit": ("cor._fit.command", "the law and the parameters that fit measured bounces"),
}


class UsageError(Exception):
    """Exit status 2 with this message."""


class Failure(Exception):
    """Exit status 1 with this message."""


# ---- texts and tables ----


def printable(text: str) -> str:
    r"""Returns the text with \xNN for each byte of a control character, or of a byte that is not UTF-8."""
    if text.isprintable():
        return text
    parts = []
    for c in text:
        wrong = ord(c) < 0x20 or 0x7F <= ord(c) < 0xA0 or 0xD800 <= ord(c) < 0xE000 or ord(c) in (0x2028, 0x2029)
        wrong = wrong or 0x202A <= ord(c) <= 0x202E or 0x2066 <= ord(c) <= 0x2069
        parts.append("".join(f"\\x{b:02x}" for b in c.encode("utf-8", "surrogateescape")) if wrong else c)
    return "".join(parts)


def cell(value: object) -> str:
    """Returns a value as text for csv: 12 digits; "" for an unknown value."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return ""
    return f"{value:.12g}" if isinstance(value, float) else printable(str(value))


def _json_value(value: object) -> object:
    if isinstance(value, str):
        return printable(value) or None
    if isinstance(value, float):
        return float(f"{value:.12g}") if math.isfinite(value) else None
    return value


def table(columns: Sequence[str], rows: Sequence[Sequence[object]], form: str) -> str:
    """Returns a table as csv or json. Unknown numbers and empty texts are empty cells, and null in json."""
    if form == "csv":
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([cell(value) for value in row] for row in rows)
        return out.getvalue()
    objects = [json.dumps({c: _json_value(v) for c, v in zip(columns, row)}, ensure_ascii=False) for row in rows]
    return "[" + ",".join(f"\n  {line}" for line in objects) + "\n]\n"


# ---- files ----


def read_text(path: str, most: int) -> str:
    """Returns the text of a regular file, or of standard input for "-". Bytes that are not UTF-8 become surrogates.
    Raises OSError, and ValueError with a sentence for other kinds of files, long files and zero bytes."""
    if path == "-":
        data = sys.stdin.buffer.read(most + 1)
    else:
        with open(os.open(path, os.O_RDONLY | os.O_NONBLOCK | getattr(os, "O_CLOEXEC", 0)), "rb") as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise ValueError("it is not a regular file")
            data = file.read(most + 1)
    if len(data) > most:
        raise ValueError(f"it is longer than {most} bytes")
    zeros = data[:64:2].count(0), data[1:64:2].count(0)
    if data[:2] in (b"\xff\xfe", b"\xfe\xff") or max(zeros) > 4 * min(zeros) + 4:
        raise ValueError("it is UTF-16; allowed: UTF-8; convert it by iconv -f UTF-16 -t UTF-8 FILE")
    if b"\0" in data:
        raise ValueError("it is not a text: it contains zero bytes")
    return data.decode("utf-8-sig", "surrogateescape")


def write_output(path: Optional[str], content: Union[str, bytes]) -> None:
    """Writes a result to standard output, or to a file that changes only if everything succeeds: writes a temporary
    file in its folder and renames it. Follows links; writes devices and pipes directly. Raises Failure."""
    data = content if isinstance(content, bytes) else content.encode("utf-8", "backslashreplace")
    try:
        if path is None:
            sys.stdout.flush()
            sys.stdout.buffer.write(data)
            sys.stdout.buffer.flush()
            return
        target = os.path.realpath(path)
        if os.path.exists(target) and not os.path.isfile(target):
            with open(path, "wb") as device:
                device.write(data)
            return
        mode = os.stat(target).st_mode & 0o777 if os.path.exists(target) else 0o666 & ~_umask()
        handle, temporary = tempfile.mkstemp(prefix=".cor-", dir=os.path.dirname(target))
        try:
            with open(handle, "wb") as file:
                file.write(data)
            os.chmod(temporary, mode)
            os.replace(temporary, target)
        except BaseException:
            os.unlink(temporary)
            raise
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise SystemExit(141) from None
    except OSError as error:
        raise Failure(f"cannot write {path or 'standard output'}: {error.strerror or error}") from None


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


# ---- messages and progress ----


def message(text: str) -> None:
    """Prints a message on standard error, below the progress line."""
    progress.erase()
    print(f"cor: {printable(text)}", file=sys.stderr)


class Progress:
    """A progress line on a terminal, shown after one second, and the times of steps for --profile."""

    def __init__(self) -> None:
        self.started = self.shown = self.since = time.monotonic()
        self.visible = False
        self.now = ""
        self.seconds: Dict[str, float] = {}

    def __call__(self, step: str) -> None:
        """Starts a step with this name."""
        at = time.monotonic()
        name = self.now.partition(":")[0]
        self.seconds[name] = self.seconds.get(name, 0.0) + at - self.since
        self.now, self.since = step, at
        if at - self.started > 1 and at - self.shown > 0.2 and sys.stderr.isatty():
            self.erase()
            sys.stderr.write(printable(step)[:78])
            sys.stderr.flush()
            self.visible, self.shown = True, at

    def erase(self) -> None:
        if self.visible:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
            self.visible = False

    def report(self) -> None:
        """Prints the times of steps for --profile."""
        self("")
        rest = time.monotonic() - self.started
        for name, seconds in self.seconds.items():
            if name:
                rest -= seconds
                print(f"profile: {seconds:10.3f} s  {name}", file=sys.stderr)
        print(f"profile: {rest:10.3f} s  the rest", file=sys.stderr)
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        print(f"profile: {peak:10.1f} MB peak memory", file=sys.stderr)


progress = Progress()


# ---- options ----


class Parser(argparse.ArgumentParser):
    """Options as in corgen: no abbreviations, and error messages that refer to the help."""

    def __init__(self, **settings: Any) -> None:
        settings.setdefault("formatter_class", argparse.RawDescriptionHelpFormatter)
        super().__init__(allow_abbrev=False, **settings)

    def error(self, message: str) -> NoReturn:
        raise UsageError(f"{self.prog}: {message}; see {self.prog} --help")


def positive(text: str) -> float:
    """Returns a number above 0, for argparse."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number above 0")
    return value


def numbers(text: str) -> List[float]:
    """Returns numbers above 0 from numbers and ranges such as 0.1,1:3:+0.5,0.01:10:log:7,1:3:lin:3, for argparse."""
    made: List[float] = []
    for part in text.split(","):
        words = part.split(":")
        if len(words) == 1:
            made.append(positive(part))
            continue
        first, last = positive(words[0]), positive(words[1])
        kind, count = (words + [""])[2], (words + ["", ""])[3]
        if len(words) == 3 and kind[:1] == "+":
            made += [
                float(x)
                for x in first + positive(kind[1:]) * np.arange(min(1e4, (last - first) / float(kind) + 1e-9) + 1)
            ]
        elif len(words) == 4 and kind in ("lin", "log") and count.isdigit() and 2 <= int(count) <= 10000:
            space = np.linspace(first, last, int(count)) if kind == "lin" else np.geomspace(first, last, int(count))
            made += [float(x) for x in space]
        else:
            raise argparse.ArgumentTypeError(
                f"'{part}' is not a range; allowed: FIRST:LAST:+STEP, FIRST:LAST:lin:COUNT and FIRST:LAST:log:COUNT"
            )
    return made


def add_common(parser: Parser, formats: Sequence[str] = ("text", "csv", "json")) -> None:
    """Adds --format, --output and --profile."""
    add = parser.add_argument
    add("--format", choices=formats, default=formats[0], help="output format, %(choices)s (default %(default)s)")
    add("--output", metavar="FILE", help="file for the output, changed only if everything succeeds")
    add("--profile", action="store_true", help="print the seconds of each step and the peak memory on standard error")


def _parser(names: Sequence[str]) -> Parser:
    parser = Parser(prog="cor", description="Coefficient of restitution: decks of simulators, and measured bounces.")
    subparsers = parser.add_subparsers(dest="subcommand", metavar="SUBCOMMAND", parser_class=Parser)
    for name, (module, summary) in SUBCOMMANDS.items():
        made = subparsers.add_parser(name, help=summary, description=summary)
        if name in names:
            import_module(module).add_arguments(made)
    return parser


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command cor; returns its exit status."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        if words and not words[0].startswith("-") and words[0] not in SUBCOMMANDS:
            raise UsageError(f"'{words[0]}' is not a subcommand; allowed: {', '.join(SUBCOMMANDS)}; see cor --help")
        parser = _parser(words[:1])
        options = parser.parse_args(words)
        if options.subcommand is None:
            raise UsageError(f"no subcommand; allowed: {', '.join(SUBCOMMANDS)}; see cor --help")
        status = int(import_module(SUBCOMMANDS[options.subcommand][0]).run(options))
        progress.erase()
        if options.profile:
            progress.report()
        return status
    except UsageError as error:
        message(str(error))
        return STATUS_USAGE
    except Failure as error:
        message(str(error))
        return STATUS_FAILED
    except KeyboardInterrupt:
        progress.erase()
        return 130
