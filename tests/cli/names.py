#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Names of any bytes, drawn at random, in messages, tables and pictures: control characters and bytes that are not UTF-8
are escaped.

usage: names.py CORGEN [SEED]
"""
import csv
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
import unicodedata
import xml.etree.ElementTree

INVALID = [b"\xc0\xaf", b"\xc1\xbf", b"\xe0\x9f\xbf", b"\xed\xa0\x80", b"\xf0\x8f\xbf\xbd", b"\xf4\x90\x80\x80",
           b"\xf8\x90\x80\x80"]


def drawn_name(draw):
    pieces = []
    for _ in range(draw.randint(1, 12)):
        code = draw.choice([draw.randrange(0x100), draw.randrange(0x800), draw.randrange(0x110000), 0xFFFE, 0x7F, 0x9F, 0xA0])
        piece = chr(code).encode("utf-8", "surrogatepass")
        pieces.append(draw.choice([piece, piece[:-1], piece[1:], bytes([draw.randrange(256)]), draw.choice(INVALID)]))
    return b"n" + b"".join(pieces).replace(b"/", b"").replace(b"\0", b"")


def escaped(name):
    def shown(character):
        hidden = unicodedata.category(character) in ("Cc", "Cs") or ord(character) & 0xFFFE == 0xFFFE
        return "".join(f"\\x{byte:02x}" for byte in character.encode("utf-8", "surrogateescape")) if hidden else character
    return "".join(map(shown, name.decode("utf-8", "surrogateescape")))


def main():
    corgen, seed = os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else str(time.time_ns())
    draw = random.Random(seed)
    names = {drawn_name(draw) for _ in range(40)}

    def run(*arguments):
        done = subprocess.run([corgen, *arguments], capture_output=True, check=False)
        return done.stdout.decode(), done.stderr.decode()

    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name in names:
            with open(name, "w", encoding="ascii") as file:
                file.write("units si\npair_style granular\npair_coeff * * hertz/material 1e7 0.5 0.3 damping tsuji\n")
        shown = [escaped(name) + ":3" for name in names]
        printed = "\n" + run("audit", *names)[0]
        wrong = [text for text in shown if f"\n{text}: lammps" not in printed]
        rows = list(csv.reader(run("audit", *names, "--format", "csv")[0].split("\n")))
        objects = json.loads(run("audit", *names, "--format", "json")[0])
        wrong += [text for text, row, item in zip(shown, rows[1:], objects) if not text == row[0] == item["line"]]
        for name in list(names)[:5]:
            with open(name, "w", encoding="ascii") as file:
                file.write("speed_m_s,eps\n0.1,0.95\n1,0.9\n10,0.8\n")
            if shutil.which("gnuplot"):
                run("fit", name, "--law", "constant", "--plot", "x.svg")
                if escaped(name) not in (text.text for text in xml.etree.ElementTree.parse("x.svg").iter()):
                    wrong.append(name)
            if run("fit", b"x" + name)[1] != f"corgen: cannot read x{escaped(name)}: No such file or directory\n":
                wrong.append(name)
    print(f"seed {seed}; wrong: {wrong}")
    sys.exit(bool(wrong))


main()
