# SPDX-License-Identifier: MIT
"""Runs another program on a temporary copy of a folder, with time limits. The copy is removed afterwards."""

import os
import pty
import re
import select
import shutil
import signal
import stat
import subprocess
import time
from contextlib import suppress
from typing import List, Sequence

from .collision import Failed

RUN_S, ALL_S = 60.0, 600.0  # time limits of one answer and of all runs
MOST_BYTES, MOST_FILES = 200_000_000, 20_000  # limits of a copied folder


def copy_folder_of(path: str, whole: str) -> str:
    """Copies the folder of a file to a folder three levels below `whole`, so that paths with ../ stay inside `whole`.
    Copies only files, no devices, up to a total size. Returns the new folder."""
    source, target = os.path.dirname(os.path.realpath(path)), os.path.join(whole, "1", "2", "3")
    size = files = 0
    for folder, folders, names in os.walk(source):
        inner = [name for name in folders if not name.startswith(".") and os.path.join(folder, name) != whole]
        folders[:] = inner if files < MOST_FILES else []
        copy = os.path.normpath(os.path.join(target, os.path.relpath(folder, source)))
        os.makedirs(copy, exist_ok=True)
        for name in names:
            with suppress(OSError):  # the program reports missing files
                info = os.stat(os.path.join(folder, name))
                asked = folder == source and name == os.path.basename(path)
                if stat.S_ISREG(info.st_mode) and (asked or size + info.st_size <= MOST_BYTES):
                    shutil.copy(os.path.join(folder, name), copy)
                    size, files = size + info.st_size, files + 1
    return target


class Process:
    """A program that reads from a pipe. It writes to a terminal, so that each line arrives immediately."""

    def __init__(self, command: Sequence[str], folder: str, end: float) -> None:
        """end: the time.monotonic() at which all runs end."""
        self.end, self.rest, self.open = end, b"", True
        self.terminal, slave = pty.openpty()
        environment = {**os.environ, "OMP_NUM_THREADS": "1", "MPLBACKEND": "agg", "TMPDIR": os.path.dirname(folder)}
        environment.pop("DISPLAY", None)
        try:
            self.process = subprocess.Popen(
                list(command), cwd=folder, env=environment, stdin=subprocess.PIPE, stdout=slave, stderr=slave,
                start_new_session=True,
            )  # fmt: skip
        except OSError as error:
            os.close(self.terminal)
            raise Failed(f"{command[0]}: {error.strerror}") from None
        finally:
            os.close(slave)
        assert self.process.stdin
        self.pipe = self.process.stdin

    def send(self, text: str) -> None:
        """Writes one line."""
        with suppress(BrokenPipeError, ValueError):  # read_until reports the reason
            self.pipe.write(text.encode(errors="surrogateescape") + b"\n")
            self.pipe.flush()

    def read_until(self, mark: str) -> List[str]:
        """Returns the lines up to the next one that begins with the mark."""
        limit = min(time.monotonic() + RUN_S, self.end)
        found: List[str] = []
        while True:
            *lines, self.rest = self.rest.split(b"\n")
            for i, line in enumerate(lines):
                text = line.decode(errors="replace").strip("\r")
                found = found[-1000:] + [text]
                if text.startswith(mark):
                    self.rest = b"\n".join(lines[i + 1 :] + [self.rest])
                    return found
            try:
                ready = select.select([self.terminal], [], [], max(limit - time.monotonic(), 0))[0]
                block = os.read(self.terminal, 1 << 16) if ready else None
            except OSError:  # the program has ended
                block = b""
            if not block:
                late = f"no answer within {RUN_S:.0f} s" if time.monotonic() < self.end else "the runs took 10 minutes"
                text = late if block is None else _reason(found + [self.rest.decode(errors="replace")])
                self.close()
                raise Failed(text)
            self.rest += block

    def close(self) -> None:
        """Ends the program and all processes that it started."""
        if not self.open:
            return
        self.open = False
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        with suppress(BrokenPipeError):
            self.pipe.close()
        os.close(self.terminal)


def _reason(lines: List[str]) -> str:
    """Returns the program's first error message, or its last line."""
    said = [re.sub(r"\s+", " ", line).strip() for line in lines if line.strip()]
    errors = [line for line in said if re.search(r"\bERROR\b|Error:|Exception", line)]
    return (errors or said[-1:] or ["it ended without a message"])[0][:300]
