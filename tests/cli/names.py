#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""names.py CORGEN [SEED]: names of any bytes, drawn at random, in messages, tables and pictures. Control characters and
bytes that are not UTF-8 are escaped."""
import csv
import json
import os
import random
import subprocess
import sys
import tempfile
import time
import unicodedata

INVALID = [b"\xc0\xaf", b"\xc1\xbf", b"\xe0\x9f\xbf", b"\xed\xa0\x80", b"\xf0\x8f\xbf\xbd", b"\xf4\x90\x80\x80",
           b"\xf8\x90\x80\x80"]
INPUT = "units si\npair_style granular\npair_coeff * * hertz/material 1e7 0.5 0.3 damping tsuji\n"
corgen, seed = os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else str(time.time_ns())
draw = random.Random(seed)


def drawn_name():
    name = b"n"
    for _ in range(draw.randint(1, 12)):
        code = draw.choice([draw.randrange(0x100), draw.randrange(0x800), draw.randrange(0x110000), 0xFFFE, 0x7F, 0x9F, 0xA0])
        piece = chr(code).encode("utf-8", "surrogatepass")
        name += draw.choice([piece, piece[:-1], piece[1:], bytes([draw.randrange(256)]), draw.choice(INVALID)])
    return name.replace(b"/", b"").replace(b"\0", b"")


def escaped(name):
    def shown(character):
        hidden = unicodedata.category(character) in ("Cc", "Cs") or ord(character) & 0xFFFE == 0xFFFE
        return "".join(f"\\x{byte:02x}" for byte in character.encode("utf-8", "surrogateescape")) if hidden else character
    return "".join(map(shown, name.decode("utf-8", "surrogateescape")))


def run(*arguments):
    done = subprocess.run([corgen, *arguments], capture_output=True, check=False)
    return done.stdout.decode(), done.stderr.decode()


def write(name, text):
    with open(name, "w", encoding="ascii") as file:
        file.write(text)


names = list({drawn_name() for _ in range(40)})
wrong = []
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for each in names:
        write(each, INPUT)
    printed = "\n" + run("audit", *names)[0]
    rows = list(csv.reader(run("audit", *names, "--format", "csv")[0].split("\n")))
    objects = json.loads(run("audit", *names, "--format", "json")[0])
    for each, row, item in zip(names, rows[1:], objects):
        place = escaped(each) + ":3"
        if f"\n{place}: lammps" not in printed or not place == row[0] == item["line"]:
            wrong.append(each)
print(f"seed {seed}; wrong: {wrong}")
sys.exit(bool(wrong))
